"""check_urdf, urdf_to_graphviz, xacro, and the launch files that use them."""

import pytest

from coursekit.urdf import load
from tests.urdf.oracle import ROBOTS

TUTORIAL = ROBOTS.parents[1] / "urdf_tutorial" / "urdf"
PARTS = {
    "01-myfirst": (1, 0),
    "02-multipleshapes": (2, 0),
    "03-origins": (3, 0),
    "04-materials": (3, 0),
    "05-visual": (14, 0),
    "06-flexible": (14, 8),
    "07-physics": (14, 8),
    "08-macroed": (15, 8),
}
"""Links and joints that move."""


@pytest.mark.parametrize("path", sorted(TUTORIAL.iterdir()), ids=lambda path: path.name)
def test_the_tutorials_robots_are_sound(path):
    robot = load(path)
    name = path.name.partition(".")[0]
    assert robot.name == name[3:]
    assert (len(robot.links), len(robot.moving_joints())) == PARTS[name]
    assert not robot.warnings


def test_check_urdf_prints_the_tree(run):
    command = run("urdfdom", "check_urdf", str(ROBOTS / "wheel.urdf"))
    assert command.wait(10) == 0
    assert command.output == (
        "robot name is: wheel_robot\n---------- Successfully Parsed XML ---------------\n"
        "root Link: wheel_base_footprint has 1 child(ren)\n    child(1):  wheel_base_link\n"
    )


def test_check_urdf_says_what_is_wrong(run, tmp_path):
    path = tmp_path / "bad.urdf"
    path.write_text('<robot name="r">\n<link name="a"/>\n<link name="a"/></robot>')
    command = run("urdfdom", "check_urdf", str(path))
    assert command.wait(10) == 255
    assert command.output == (
        f"Error:   link 'a' is not unique.\n         at {path}:3 in <link name=\"a\">\n"
        "         The first one is in line 2: give one of them another name.\nERROR: Model Parsing the xml failed\n"
    )


def test_check_urdf_warns_of_bodies_that_cannot_be(run, tmp_path):
    path = tmp_path / "odd.urdf"
    inertia = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="9"/>'
    path.write_text(f'<robot name="r"><link name="a"><inertial><mass value="1"/>{inertia}</inertial></link></robot>')
    command = run("urdfdom", "check_urdf", str(path))
    assert command.wait(10) == 0
    assert "Warning: wrong: a: no body has the principal moments" in command.output


def test_urdf_to_graphviz_writes_text_and_picture(run, tmp_path):
    command = run("urdfdom", "urdf_to_graphviz", str(ROBOTS / "r2d2.urdf"), str(tmp_path / "tree"))
    assert command.wait(30) == 0
    assert (tmp_path / "tree.gv").read_text().startswith("digraph G {")
    assert (tmp_path / "tree.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize(
    ("executable", "words"), [("check_urdf", "Expect URDF xml file to parse."), ("urdf_to_graphviz", "Usage:")]
)
def test_without_a_file_they_say_how_to_use_them(run, executable, words):
    command = run("urdfdom", executable)
    assert command.wait(10) == 255
    assert words in command.output


def test_xacro_prints_the_urdf(run):
    command = run("xacro", "xacro", str(ROBOTS / "rdk_x3_robot.urdf.xacro"))
    assert command.wait(10) == 0
    assert '<robot name="rdk_x3_robot">' in command.output


def test_xacro_ends_with_2_for_a_missing_file(run, tmp_path):
    command = run("xacro", "xacro", str(tmp_path / "no.xacro"))
    assert command.wait(10) == 2
    assert "No such file" in command.output


VIEWER = "import sys\nprint('viewer', sys.argv[1:3])\n"


@pytest.fixture
def viewer(tmp_path, monkeypatch):
    """A stand-in for rviz2: these tests are about what is published."""
    prefix = tmp_path / "install"
    for folder in ("share/ament_index/resource_index/packages", "share/rviz2", "lib/rviz2"):
        (prefix / folder).mkdir(parents=True)
    (prefix / "share/ament_index/resource_index/packages/rviz2").touch()
    path = prefix / "lib/rviz2/rviz2"
    path.write_text("#!/usr/bin/env python3\n" + VIEWER)
    path.chmod(0o755)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(prefix))
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))


@pytest.mark.parametrize("model", ["", str(ROBOTS / "r2d2.urdf.xacro"), "urdf/05-visual.urdf"])
def test_the_tutorials_launch_file_shows_any_model(session, ros2, viewer, model):
    words = [f"model:={model}"] if model else []
    output = ros2("launch", "urdf_tutorial", "display.launch.py", "gui:=false", *words)
    assert "got segment head" in output if model else "got segment base_link" in output
    assert "[joint_state_publisher-" in output
    assert "viewer ['-d', " in output


def test_urdf_launch_takes_a_package_and_a_path(session, ros2, viewer):
    words = ["urdf_package:=coursekit_robots", "urdf_package_path:=urdf/robot2.urdf.xacro"]
    output = ros2("launch", "urdf_launch", "display.launch.py", *words)
    assert "got segment laser_link" in output
    assert "joint_state_publisher_gui-" in output


MESHES = """<robot name="r"><link name="base">
<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<visual><geometry><mesh filename="package://nowhere/meshes/a.stl"/></geometry></visual>
<collision><geometry><mesh filename="missing.dae"/></geometry></collision></link></robot>"""


def test_check_urdf_reads_a_robot_whose_meshes_are_elsewhere(run, tmp_path):
    """The tree stands all the same, as on a robot: check_urdf opens no mesh there."""
    path = tmp_path / "meshes.urdf"
    path.write_text(MESHES)
    command = run("urdfdom", "check_urdf", str(path))
    assert command.wait(10) == 0
    warning, *tree = command.output.splitlines()
    assert warning.startswith("Warning: odd: base: its mass cannot be compared with its shape: 'missing.dae' not found")
    assert tree[0] == "robot name is: r" and tree[-1] == "root Link: base has 0 child(ren)"
