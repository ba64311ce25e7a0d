"""What the checks of chapter 6 say is wrong with a cart, an arm and slipping wheels."""

import math

import pytest

from coursekit.grade.chapters.measures.rolling import judge_wheel_s_distance
from coursekit.grade.checking import judge
from coursekit.grade.exercise import find
from coursekit.grade.verdict import Wrong
from tests.grade.tried import told_of

CART = """<robot name="cart">
<link name="base_footprint"/>
<link name="base_link"><visual><geometry><box size="0.5 0.3 0.1"/></geometry></visual></link>
<joint name="base_joint" type="fixed"><origin xyz="0 0 0.15"/><parent link="base_footprint"/>
<child link="base_link"/></joint>
{left}{right}
<link name="lift_link"><visual><geometry><box size="0.4 0.3 0.02"/></geometry></visual></link>
<joint name="lift_joint" type="prismatic"><origin xyz="0 0 0.06"/><parent link="base_link"/><child link="lift_link"/>
<axis xyz="0 0 1"/><limit lower="0" upper="0.4" effort="300" velocity="0.2"/></joint>
</robot>"""
WHEEL = """<link name="{0}_wheel_link"><visual><origin rpy="{rpy} 0 0"/><geometry><cylinder radius="{radius}" length="0.05"/>
</geometry></visual></link><joint name="{0}_wheel_joint" type="continuous"><origin xyz="0 {y} 0"/>
<parent link="base_link"/><child link="{0}_wheel_link"/>{axis}</joint>"""


def cart(folder, rpy="1.5708", radius="0.15", axis='<axis xyz="0 1 0"/>'):
    wheels = {"left": 0.2, "right": -0.2}
    parts = {side: WHEEL.format(side, rpy=rpy, radius=radius, axis=axis, y=y) for side, y in wheels.items()}
    file = folder / "src/s6_py_urdf/urdf/cart.urdf"
    file.parent.mkdir(parents=True)
    file.write_text(CART.format(**parts))
    return folder


def test_the_cart_itself_is_taken(tmp_path):
    assert judge(find("ch06.q1"), {}, cart(tmp_path)).passed


@pytest.mark.parametrize(
    ("wheel", "cause"),
    [
        ({"rpy": "90"}, "radians"),
        ({"rpy": "0"}, "axle lie along y"),
        ({"radius": "0.3"}, "radius"),
        ({"axis": ""}, "x, where no <axis> is given"),
        ({"axis": '<axis xyz="0 -1 0"/>'}, "top of the wheel"),
    ],
)
def test_a_wheel_s_fault_is_named(tmp_path, wheel, cause):
    assert cause in told_of("ch06.q1", {}, cart(tmp_path, **wheel)).cause


@pytest.mark.parametrize("mass", ["nan", "inf", "2 kg"])
def test_a_link_that_ros_passes_over_is_told(tmp_path, mass):
    cart(tmp_path)
    file = tmp_path / "src/s6_py_urdf/urdf/cart.urdf"
    inertial = f'<inertial><mass value="{mass}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
    file.write_text(
        file.read_text().replace('<link name="base_footprint"/>', f'<link name="base_footprint">{inertial}</link>')
    )
    verdict = told_of("ch06.q1", {}, tmp_path)
    assert verdict.got == f"cart.urdf:2: Inertial: mass [{mass}] is not a float" and "kilograms" in verdict.cause


def test_a_fault_in_an_expanded_xacro_is_placed_by_its_element_not_by_a_line_that_is_not_in_the_file(tmp_path):
    file = tmp_path / "src/s6_py_urdf/urdf/own.urdf.xacro"
    file.parent.mkdir(parents=True)
    file.write_text('<robot name="own" xmlns:xacro="http://www.ros.org/wiki/xacro">\n</robot>\n')
    assert (
        told_of("ch06.q4", {}, tmp_path).got
        == 'own.urdf.xacro, expanded: <robot name="own">: No link elements found in urdf file'
    )


def right(shoulder, elbow, upper=0.4, fore=0.3):
    x = upper * math.cos(shoulder) + fore * math.cos(shoulder + elbow)
    return x, upper * math.sin(shoulder) + fore * math.sin(shoulder + elbow)


def elbow_alone(shoulder, elbow, upper=0.4, fore=0.3):
    return right(shoulder, elbow - shoulder, upper, fore)


@pytest.mark.parametrize(
    ("tip", "cause"),
    [
        (lambda s, e, *ways: right(math.radians(s), math.radians(e), *ways), "radians"),
        (elbow_alone, "elbow's angle alone"),
        (lambda *given: right(*given)[::-1], "x first"),
        (lambda *given: tuple(round(coordinate, 2) for coordinate in right(*given)), "rounded"),
        (lambda s, e, *_: right(s, e), "other lengths"),
        (lambda *given: (*right(*given), 0.0), "2 values are asked for, these are 3"),
        (lambda *given: str(right(*given)), "text"),
        (lambda *given: dict(zip("xy", right(*given), strict=True)), "tuple or a list"),
        (lambda s, e, upper=0.4, fore=0.3: (upper, fore), "Draw"),
    ],
)
def test_an_arm_s_fault_is_named(tmp_path, tip, cause):
    assert cause in told_of("ch06.q2", {"tip": tip}, tmp_path).cause


@pytest.mark.parametrize(
    ("radius", "factor", "cause"),
    [
        (1.0, lambda radius, aside: radius, "middle"),
        (1.0, lambda radius, aside: aside - radius, "backwards"),
        (1.0, lambda radius, aside: radius + aside, "other side's"),
        (0.5, lambda radius, aside: 1.0 - aside, "`radius` used"),
        (1.0, lambda radius, aside: (radius - aside) * 0.0375, "divided by the wheel's radius"),
        (1.0, lambda radius, aside: math.degrees(radius - aside), "Radians"),
        (1.0, lambda radius, aside: 7.0, "Which wheels"),
    ],
)
def test_a_slipping_wheel_s_fault_is_named(radius, factor, cause):
    with pytest.raises(Wrong) as caught:
        judge_wheel_s_distance("left_back_joint", radius, 0.77, 0.094, 0.77 * factor(radius, 0.094))
    assert cause in caught.value.cause
