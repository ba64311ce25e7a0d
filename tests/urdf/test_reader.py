"""What is read: values, defaults, warnings, files, xacro."""

import math

import pytest

from coursekit.interfaces.find import UNDERLAY
from coursekit.urdf import UrdfError, load, load_text, parse
from coursekit.urdf.expand import expand
from coursekit.urdf.texts import check_text, error_text, graphviz_text
from tests.needs import slashed
from tests.urdf.oracle import ROBOTS

ARM = """<robot name="arm">
<link name="a"><visual><geometry><sphere radius="1"/></geometry><material name="red"/></visual></link>
<link name="b"/><link name="c"/><link name="d"/>
<joint name="zz" type="revolute"><origin xyz="1 2 3" rpy="0.1 0.2 0.3"/><parent link="a"/><child link="b"/>
<axis xyz="0 0 -2"/><limit lower="-1" upper="1" effort="5" velocity="2"/><dynamics damping="0.5"/>
<safety_controller k_velocity="10" soft_lower_limit="-0.5" soft_upper_limit="0.5"/></joint>
<joint name="mm" type="continuous"><parent link="b"/><child link="c"/><mimic joint="zz" multiplier="2"/></joint>
<joint name="aa" type="fixed"><parent link="a"/><child link="d"/></joint>
<gazebo reference="a"><sensor><range>3</range></sensor></gazebo>
</robot>"""


def test_all_of_a_joint_is_read():
    joint = parse(ARM).joints["zz"]
    assert (joint.type, joint.parent, joint.child, joint.line) == ("revolute", "a", "b", 4)
    assert joint.origin.xyz == (1.0, 2.0, 3.0)
    assert joint.axis == (0.0, 0.0, -1.0)
    assert (joint.limit.lower, joint.limit.effort, joint.damping, joint.friction) == (-1.0, 5.0, 0.5, 0.0)
    assert joint.safety.upper == 0.5


def test_what_is_not_given_has_its_default():
    joint = parse(ARM).joints["mm"]
    assert joint.axis == (1.0, 0.0, 0.0)
    assert joint.origin.xyz == joint.origin.rpy == (0.0, 0.0, 0.0)
    assert (joint.mimic.joint, joint.mimic.multiplier, joint.mimic.offset) == ("zz", 2.0, 0.0)


def test_what_is_probably_not_meant_is_warned_of():
    assert parse(ARM, "arm.urdf").warnings == (
        "arm.urdf:2: link 'a' material 'red' undefined. There are: none.",
        "arm.urdf:7: joint 'mm' has no <axis>; it moves along or about x.",
    )


def test_the_tree_is_walked_from_the_root():
    robot = parse(ARM)
    assert robot.root == "a"
    assert [(depth, link.name) for depth, link in robot.walk()] == [(0, "a"), (1, "b"), (2, "c"), (1, "d")]
    assert robot.joint_above("c").name == "mm"
    assert [joint.name for joint in robot.joints_below("a")] == ["zz", "aa"]
    assert [joint.name for joint in robot.moving_joints()] == ["zz"]
    with pytest.raises(LookupError, match="arm has no link 'e'"):
        robot.link("e")


def test_gazebo_blocks_are_kept():
    (block,) = parse(ARM).gazebo
    assert block.get("reference") == "a"
    assert block.tell("sensor/range") == "3"
    assert block.tell("sensor/nothing") == ""


def test_check_urdf_lists_children_by_their_joints_names():
    assert check_text(parse(ARM)) == (
        "robot name is: arm\n---------- Successfully Parsed XML ---------------\nroot Link: a has 2 child(ren)\n"
        "    child(1):  d\n    child(2):  b\n        child(1):  c\n"
    )


def test_check_urdf_tells_place_and_cure():
    with pytest.raises(UrdfError) as caught:
        parse('<robot name="r"><link name="a"/><link name="b"/></robot>', "r.urdf")
    assert error_text(caught.value) == (
        "Error:   Failed to find root link: Two root links found: [a] and [b]\n"
        '         at r.urdf:1 in <link name="b">\n'
        '         All links but one are the child of a joint: add a joint with <child link="b"/>.\n'
    )


def test_graphviz_text_has_every_link_and_joint():
    text = graphviz_text(parse(ARM))
    assert text.splitlines()[:4] == ["digraph G {", "node [shape=box];", '"a" [label="a"];', '"d" [label="d"];']
    assert '"a" -> "zz" [label="xyz: 1 2 3 \\nrpy: 0.1 0.2 0.3"]' in text


# -- files


@pytest.mark.parametrize("path", sorted(ROBOTS.glob("*.urdf.xacro")), ids=lambda path: path.name)
def test_a_urdf_file_is_what_its_xacro_file_gives(path):
    kept = path.with_suffix("").read_text(encoding="utf-8")
    meant = [line.strip() for line in load_text(path).splitlines() if line.strip() and "<!--" not in line]
    assert [line.strip() for line in kept.splitlines() if "<!--" not in line] == meant


def test_a_file_that_is_not_there_is_said_to_be_missing():
    with pytest.raises(UrdfError, match=r"there is no such file\n(.*)Did you mean 'robot.urdf'"):
        load(ROBOTS / "robots.urdf")


def test_a_binary_file_is_no_robot():
    with pytest.raises(UrdfError, match="no UTF-8 text"):
        load(ROBOTS.parent / "meshes" / "finger.stl")


XACRO = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="size" default="2"/>
<link name="{link}"><visual><geometry><sphere radius="$(arg size)"/></geometry></visual></link></robot>"""


def test_a_xacro_file_takes_arguments(tmp_path):
    path = tmp_path / "r.urdf.xacro"
    path.write_text(XACRO.format(link="${'a' * 3}"))
    assert load(path).links["aaa"].visuals[0].geometry.radius == 2.0
    assert load(path, {"size": "0.5"}).links["aaa"].visuals[0].geometry.radius == 0.5


@pytest.mark.skipif("$(" in str(UNDERLAY), reason="xacro takes what is found for more to find, here as on a robot")
def test_xacro_finds_packages_in_the_index(tmp_path):
    path = tmp_path / "r.xacro"
    path.write_text(XACRO.format(link="$(find coursekit_robots)"))
    assert slashed(next(iter(load(path).links))).endswith("share/coursekit_robots")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (XACRO.format(link="${nothing}"), "nothing"),
        (XACRO.format(link="$(find no_such_package)"), "no_such_package"),
        (XACRO.format(link="$(find no_such_package)"), "Build the workspace that holds the package"),
        (XACRO.format(link="$(arg colour)"), "colour"),
        ("<robot><xacro:include", "XML parser error"),
        ('<robot name="r"><xacro:property name="a" value="1"/></robot>', 'xmlns:xacro="http://www.ros.org/wiki/xacro"'),
        ('<robot xmlns:xacro="x"><xacro:include filename="gone.xacro"/></robot>', "gone.xacro"),
    ],
)
def test_a_faulty_xacro_file_is_named(tmp_path, text, words):
    path = tmp_path / "r.xacro"
    path.write_text(text)
    with pytest.raises(UrdfError) as caught:
        expand(path)
    assert words in str(caught.value) and "r.xacro" in str(caught.value)


def test_angles_are_kept_as_written():
    assert load(ROBOTS / "wheel.urdf").joints["base_joint"].origin.rpy == (math.pi / 2, 0.0, 0.0)


def test_long_chains_of_joints_that_follow_each_other_are_read():
    count = 5000
    text = '<robot name="r">' + "".join(f'<link name="l{n}"/>' for n in range(count))
    for n in range(1, count):
        mimic = f'<mimic joint="j{n + 1}"/>' if n < count - 1 else ""
        ends = f'<parent link="l{n - 1}"/><child link="l{n}"/>'
        text += f'<joint name="j{n}" type="continuous">{ends}{mimic}</joint>'
    robot = parse(text + "</robot>")
    assert (robot.root, len(robot.joints), len(robot.moving_joints())) == ("l0", count - 1, 1)


def test_of_a_long_loop_only_the_beginning_is_told():
    text = '<robot name="r">' + "".join(f'<link name="l{n}"/>' for n in range(100))
    joints = "".join(
        f'<joint name="j{n}" type="fixed"><parent link="l{n}"/><child link="l{(n + 1) % 100}"/></joint>' for n in range(100)
    )
    with pytest.raises(UrdfError) as caught:
        parse(text + joints + "</robot>")
    assert "-> ... ->" in caught.value.cure and len(caught.value.cure) < 300
