"""The likely cause that a check gives is that of the fault at hand, not of the exercise's usual one."""

import cmath
import math
import posixpath

import numpy as np
import pytest
from ament_index_python.packages import get_package_prefix, get_package_share_directory

from coursekit.grade.chapters import ch06, ch07, ch08, ch09
from coursekit.grade.checking import judge, judge_work
from coursekit.grade.exercise import Exercise, find
from coursekit.grade.facts import BuildFacts
from coursekit.grade.outputs import last_words
from coursekit.grade.plan import Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work


def told_of(name, variables, workspace):
    verdict = judge(find(name), variables, workspace)
    assert not verdict.passed
    return verdict


def trace(error, line):
    where = '  File "/ws/install/p/lib/python3.10/site-packages/s7_py_client_robot/stages.py", line 4, in next_step'
    return f"Traceback (most recent call last):\n{where}\n    {line}\n{error}\n"


@pytest.mark.parametrize(
    ("error", "line", "cause"),
    [
        ("NotImplementedError", "raise NotImplementedError()", "write your code where that line stands"),
        ("TypeError: cannot unpack non-iterable float object", "x, y = step()", "what should your function return?"),
        ("ValueError: not enough values to unpack (expected 4, got 3)", "a, b, c, d = step()", "your function return?"),
        ("KeyError: 3", "poses[3]", "mend the line that it names"),
    ],
)
def test_what_a_program_died_of_comes_before_the_check_s_guess_also_where_the_check_has_told_it(error, line, cause):
    class Tried(Work):
        def try_out(self, *commands, **plan):
            return Seen(outputs=[trace(error, line)], exit_codes=[1])

    def judge_trial(work):
        output = work.try_out("run p p_exe").outputs[0]
        raise Wrong("reports", f"none; it said: {last_words(output)}", "Was it built?", hint=0)

    verdict = judge_work(Exercise("ch99.q1", "Try", 1, ("a hint",), judge_trial), Tried({}, None), 3)
    assert verdict.got.count(f"{error} (line 4") == 1 and cause in verdict.cause and not verdict.hint


# -- chapter 6

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
        (lambda *given: tuple(round(one, 2) for one in right(*given)), "rounded"),
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
        ch06._judge_wheel_s_way("left_back_joint", radius, 0.77, 0.094, 0.77 * factor(radius, 0.094))
    assert cause in caught.value.cause


# -- chapter 7


def seen_from(me, other, yaw=None, sign=1.0):
    shift = sign * (complex(*other[:2]) - complex(*me[:2])) * cmath.rect(1.0, -(me[2] if yaw is None else yaw))
    return shift.real, shift.imag, math.remainder(other[2] - me[2], math.tau)


@pytest.mark.parametrize(
    ("seen", "cause"),
    [
        (lambda me, other: seen_from(me, other, yaw=0.0), "My yaw is not used"),
        (lambda me, other: seen_from(me, other, yaw=-me[2]), "wrong direction"),
        (lambda me, other: seen_from(me, other, yaw=math.radians(me[2])), "in radians already"),
        (lambda me, other: seen_from(me, other, sign=-1.0), "The other minus me"),
        (lambda me, other: seen_from(me, other)[:2], "3 values are asked for, these are 2"),
    ],
)
def test_a_view_s_fault_is_named(tmp_path, seen, cause):
    assert cause in told_of("ch07.q1", {"seen": seen}, tmp_path).cause


@pytest.mark.parametrize(("turned", "cause"), [(1.0, "theta is in radians"), (0.5, "")])
def test_a_turn_of_a_radian_is_told_as_such(turned, cause):
    with pytest.raises(Wrong) as caught:
        ch07._judge_step(0, 0, (0.0, 0.0, 0.0), (0.0, 0.0, turned))
    assert caught.value.cause.startswith(cause) and bool(caught.value.cause) == bool(cause)


@pytest.mark.parametrize(
    ("end", "steps", "cause"), [(0.1, 10, "too early"), (-0.5, 10, "two poses"), (0.995, 100, "last, shorter step")]
)
def test_how_a_stage_ends_wrong_is_told(end, steps, cause):
    with pytest.raises(Wrong) as caught:
        ch07._judge_stage(1, (0.0, 0.0, 0.0), (end, 0.0, 0.0), (1.0, 0.0, 0.0), steps)
    assert cause in caught.value.cause


# -- chapter 8


def distance(walls, x, y, angle, range_max=10.0):
    """As numpy's functions give it."""
    c, s, found = math.cos(angle), math.sin(angle), [np.float64(math.inf)]
    for x1, y1, x2, y2 in walls:
        across = c * (y2 - y1) - s * (x2 - x1)
        if abs(across) > 1e-12:
            t = ((x1 - x) * (y2 - y1) - (y1 - y) * (x2 - x1)) / across
            part = ((x1 - x) * s - (y1 - y) * c) / across
            found += [np.float64(t)] if 0 <= t <= range_max and 0 <= part <= 1 else []
    return np.min(found)


def test_a_ray_that_ends_nowhere_may_say_so_with_numpys_infinity(tmp_path):
    assert judge(find("ch08.q2"), {"cast_ray": distance}, tmp_path).passed


@pytest.mark.parametrize(
    ("cast", "cause"),
    [
        (lambda walls, x, y, angle, *most: distance(walls, x, y, math.radians(angle), *most), "radians already"),
        (lambda walls, x, y, angle, range_max=10.0: min(distance(walls, x, y, angle, 99.0), range_max), "`math.inf`"),
        (lambda walls, x, y, angle, *most: None, "return"),
        (lambda walls, x, y, angle, range_max=10.0: distance(walls, x, y, angle), "further than range_max"),
        (lambda walls, x, y, angle, *most: -math.inf, "divided by zero"),
    ],
)
def test_a_ray_s_fault_is_named(tmp_path, cast, cause):
    assert cause in told_of("ch08.q2", {"cast_ray": cast}, tmp_path).cause


def test_a_ray_along_a_wall_divides_by_nothing(tmp_path):
    def unguarded(walls, x, y, angle, range_max=10.0):
        (x1, y1, x2, y2), c, s = walls[0], math.cos(angle), math.sin(angle)
        t = ((x1 - x) * (y2 - y1) - (y1 - y) * (x2 - x1)) / (c * (y2 - y1) - s * (x2 - x1))
        part = ((x1 - x) * s - (y1 - y) * c) / (c * (y2 - y1) - s * (x2 - x1))
        return t if 0 <= t <= range_max and 0 <= part <= 1 else math.inf

    assert "ZeroDivisionError" in told_of("ch08.q2", {"cast_ray": unguarded}, tmp_path).got


def model(r, z):
    return -0.4 if r < z - 0.04 else 0.85 if r < z + 0.04 else 0.0


def test_one_number_may_be_numpys_array_of_none_dimensions(tmp_path):
    assert judge(find("ch08.q1"), {"inverse_sensor_model": lambda r, z: np.array(model(r, z))}, tmp_path).passed


@pytest.mark.parametrize(
    ("wrong", "cause"),
    [
        (lambda r, z: 0.85 if r == z else -0.4 if r < z else 0.0, "Walls get lost"),
        (lambda r, z: (model(r, z), z), "One number is asked for"),
        (lambda r, z: np.array([model(r, z), z]), "One number is asked for"),
        (lambda r, z: f"{model(r, z)}", "That is a text"),
    ],
)
def test_a_sensor_model_s_fault_is_named(tmp_path, wrong, cause):
    assert cause in told_of("ch08.q1", {"inverse_sensor_model": wrong}, tmp_path).cause


@pytest.mark.parametrize(
    ("off", "turned", "moved", "cause"),
    [
        (0.28, 0.1, 0.0, "where the guess was"),
        (0.6, 0.1, 0.5, "further off than the guess"),
        (0.01, 1.2, 0.2, "in radians"),
        (0.25, 0.1, 0.1, "0.3 m and 0.15 rad around"),
        (0.05, 0.0, 0.2, "finer steps"),
    ],
)
def test_a_pose_s_fault_is_named(off, turned, moved, cause):
    assert cause in ch08._why_pose(off, turned, moved)


# -- chapter 9


def cost(distance, inscribed=0.2, scaling=3.0, radius=0.55, start=None):
    if distance <= inscribed:
        return 253 if distance > 0 else 254
    start = inscribed if start is None else start
    return int(252 * math.exp(-scaling * (distance - start))) if distance <= radius else 0


def test_the_costs_themselves_are_taken(tmp_path):
    assert judge(find("ch09.q1"), {"inflation_cost": cost}, tmp_path).passed


@pytest.mark.parametrize(
    ("wrong", "cause"),
    [
        (lambda d, i=0.2, s=3.0, r=0.55: cost(d, i, s, r, start=0.0), "begins to fall at `inscribed`"),
        (lambda d, i=0.2, s=3.0, r=0.55: cost(d, i, 3.0, r), "`scaling` used"),
        (lambda d, i=0.2, s=3.0, r=0.55: cost(d, i, s, 0.55), "`radius` used"),
        (lambda *given: float(cost(*given)), "`int(...)` makes an integer"),
        (lambda d, i=0.2, s=3.0, r=0.55: round(252 * math.exp(-s * (d - i))) if i < d <= r else cost(d, i, s, r), "Cut off"),
    ],
)
def test_a_cost_s_fault_is_named(tmp_path, wrong, cause):
    assert cause in told_of("ch09.q1", {"inflation_cost": wrong}, tmp_path).cause


@pytest.mark.parametrize(
    ("output", "cause"),
    [
        ("[INFO] [1.0] [basic_navigator]: stop 1: SUCCEEDED\n", "`print`"),
        ("stop 1: TaskResult.SUCCEEDED\n", "`getResult().name`"),
        ("stop 1: FAILED\n", ""),
    ],
)
def test_lines_that_are_not_as_asked_for_are_told_why(output, cause):
    assert cause in ch09._why_lines(output) and bool(cause) == bool(ch09._why_lines(output))


def test_a_price_is_no_way(tmp_path):
    assert "One number came" in told_of("ch09.q2", {"find_way": lambda *_: 13.0}, tmp_path).cause


# -- appendix C


def place_of(uri, find, cut):
    if not uri.startswith("package://"):
        raise ValueError
    name, _, rest = uri.removeprefix("package://").partition("/")
    return f"{find(name)}/{cut(rest)}"


@pytest.mark.parametrize(
    ("find_folder", "cut", "cause"),
    [
        (get_package_prefix, str, "share folder"),
        (get_package_share_directory, lambda rest: rest.split("/")[-1], "kept whole"),
    ],
)
def test_a_place_s_fault_is_named(tmp_path, find_folder, cut, cause):
    assert cause in told_of("appc.q1", {"where": lambda uri: place_of(uri, find_folder, cut)}, tmp_path).cause


def test_outside_of_the_folder_the_hint_is_about_its_border(tmp_path):
    def portable(name, package, root, near):
        path = posixpath.normpath(posixpath.join(near, name.removeprefix("file://")))
        root = posixpath.normpath(root)
        return name if name.startswith("package://") else f"package://{package}/{path[len(root) + 1 :]}"

    verdict = judge(find("appc.q3"), {"portable": portable}, tmp_path, tries=2)
    assert "a ValueError" in verdict.expected and verdict.hint == find("appc.q3").hints[1]


def test_after_a_failed_build_its_output_is_named(tmp_path, monkeypatch):
    class Failed(Work):
        def _read(self, what, **arguments):
            return BuildFacts(True, "the last build of p failed, so install/ holds an older one")

    with pytest.raises(Wrong) as caught:
        Failed({}, tmp_path).built("p")
    assert caught.value.cause == "The build's output says why. Mend that, then run: %colcon build --packages-select p"
