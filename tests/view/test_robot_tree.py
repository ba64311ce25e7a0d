"""The tree of links and joints as text and picture."""

from coursekit.urdf import load
from coursekit.view.robot_tree import RobotTree
from tests.urdf.oracle import ROBOTS

TEXT = """my_robot: 5 links, 4 joints
base_footprint
└─ base_link  (base_joint: fixed)
   ├─ head_link  (head_joint: fixed)
   ├─ left_wheel_link  (left_wheel_joint: continuous about y)
   └─ right_wheel_link  (right_wheel_joint: continuous about y)"""


def test_the_text_is_a_tree():
    assert repr(RobotTree(load(ROBOTS / "robot.urdf"))) == TEXT


def test_limits_and_axes_are_told():
    text = RobotTree(load(ROBOTS / "r2d2.urdf")).text()
    assert "gripper_extension: prismatic along x, -0.2 .. 0 m" in text
    assert "right_gripper_joint: revolute about -z, 0 .. 34.38 °" in text


def test_the_picture_has_every_link_and_joint():
    robot = load(ROBOTS / "r2d2.urdf")
    tree = RobotTree(robot)
    assert {part.name for part in tree.drawing().parts if part.name} == {*robot.links, *robot.joints}
    assert tree.svg().startswith("<svg") and tree.png().startswith(b"\x89PNG")


def test_a_notebook_keeps_text_and_png():
    data, _ = RobotTree(load(ROBOTS / "sphere.urdf"))._repr_mimebundle_()
    assert data["text/plain"] == "sphere_robot: 1 link, 0 joints\nbase_link"
    assert sorted(data) == ["image/png", "text/plain"]
