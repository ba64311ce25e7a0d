"""Link poses: against pinocchio, and by hand."""

import math
import random
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from coursekit.geometry.pose import compose
from coursekit.geometry.rotation import quaternion_of
from coursekit.urdf import Robot, load, parse
from coursekit.urdf.kinematics import Kinematics, joint_pose
from coursekit.urdf.shapes import matrix_of
from tests.urdf.oracle import ROBOTS, pinocchio, pinocchio_matrices, public_robots, random_positions

OURS = sorted(ROBOTS.glob("*.urdf"))
BROKEN = {
    "ur3.urdf": "No name given for the robot.",
    "alex_psyonic_hands.urdf": "joint [Left_index_q2] mimics joint [index_q1], which does not exist",
    "fr3.urdf": "<xacro:fr3_robot> is xacro, not URDF",
    "dual_fr3.urdf": "is xacro, not URDF",
    "finger_macro.urdf": "No name given for the robot.",
    "trifinger_stage.urdf": "parent link [base_link] of joint [base_to_table] not found",
    "trifingeredu_stage.urdf": "parent link [base_link] of joint [base_to_table] not found",
    "stretch4_sg4.urdf": "Parser found 5 elements but 4 expected while parsing color",
}
"""Public robots that are wrong, and how."""


def agree(path: Path, robot: Robot) -> None:
    kinematics = Kinematics(robot)
    text = path.read_text(encoding="utf-8")
    for seed in range(3):
        positions = random_positions(robot, seed) if seed else {}
        theirs = pinocchio_matrices(text, robot, positions)
        for name, ours in zip(kinematics.links, kinematics.matrices(positions), strict=True):
            np.testing.assert_allclose(ours, theirs[name], atol=1e-9, err_msg=f"{path.name}: {name}")


@pytest.mark.parametrize("path", OURS, ids=lambda path: path.stem)
def test_the_course_robots_have_their_links_where_pinocchio_has_them(path):
    agree(path, load(path))


def test_all_robots_of_the_course_are_there():
    names = {"sphere", "cylinder", "wheel", "robot", "r2d2", "r2d2_2", "rdk_x3_robot", "robot_lidar"}
    names |= {f"robot{number}" for number in range(1, 5)} | {f"cylinder{number}" for number in range(1, 9)}
    assert {path.stem for path in OURS} == names


@pytest.mark.parametrize("path", public_robots(), ids=lambda path: path.stem)
def test_public_robots_have_their_links_where_pinocchio_has_them(path):
    if path.name in BROKEN:
        with pytest.raises(ValueError) as caught:
            load(path)
        assert BROKEN[path.name] in str(caught.value)
        return
    try:
        robot = load(path)
        pinocchio().buildModelFromXML(path.read_text(encoding="utf-8"))
    except ValueError as error:
        pytest.fail(f"{path.name}: {error}")
    agree(path, robot)


def arm(seed: int, links: int = 16) -> str:
    """A random tree with all kinds of joints."""
    chance = random.Random(seed)

    def three(size: float) -> str:
        return " ".join(f"{chance.uniform(-size, size):.6f}" for _ in range(3))

    text = '<robot name="arm"><link name="l0"/>'
    for number in range(1, links):
        type_ = chance.choice(["revolute", "continuous", "prismatic", "fixed", "floating"])
        mimic = f'<mimic joint="j{number - 1}" multiplier="-0.5" offset="0.2"/>' if chance.random() < 0.2 else ""
        moved = type_ not in ("fixed", "floating") and text.rpartition('type="')[2].startswith(("rev", "con", "pri"))
        text += (
            f'<link name="l{number}"/><joint name="j{number}" type="{type_}"><origin xyz="{three(1)}" rpy="{three(3)}"/>'
            f'<parent link="l{chance.randrange(number)}"/><child link="l{number}"/><axis xyz="{three(1)}"/>'
            f'<limit lower="-2" upper="2" effort="1" velocity="1"/>{mimic if moved else ""}</joint>'
        )
    return text + "</robot>"


def by_matrices(robot: Robot, positions: dict[str, float]) -> dict[str, np.ndarray]:
    """The same, joint by joint, with Rodrigues' formula."""
    pose_by_link = {robot.root: np.eye(4)}
    for _, link in robot.walk():
        joint = robot.joint_above(link.name)
        if joint is None:
            continue
        local = matrix_of(joint.origin)
        if joint.moves:
            value = positions[joint.name]
            motion, axis = np.eye(4), np.array(joint.axis)
            if joint.type == "prismatic":
                motion[:3, 3] = axis * value
            else:
                x, y, z = axis
                cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
                motion[:3, :3] += math.sin(value) * cross + (1 - math.cos(value)) * cross @ cross
            local = local @ motion
        pose_by_link[link.name] = pose_by_link[joint.parent] @ local
    return pose_by_link


@pytest.mark.parametrize("seed", range(20))
def test_random_trees_agree_with_matrices(seed):
    from tests.urdf.oracle import all_positions

    robot = parse(arm(seed))
    positions = random_positions(robot, seed)
    kinematics = Kinematics(robot)
    expected = by_matrices(robot, all_positions(robot, positions))
    for name, ours in zip(kinematics.links, kinematics.matrices(positions), strict=True):
        np.testing.assert_allclose(ours, expected[name], atol=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_the_compiled_poses_are_those_of_joint_after_joint(seed):
    robot = parse(arm(seed))
    positions = random_positions(robot, seed)
    poses = Kinematics(robot).poses(positions)
    for joint in robot.joints.values():
        if joint.mimic is None:
            expected = compose(poses[joint.parent], joint_pose(joint, positions.get(joint.name, 0.0)))
            assert poses[joint.child] == pytest.approx(expected, abs=1e-12)


@settings(deadline=None)
@given(st.tuples(*[st.floats(-7, 7)] * 3))
def test_a_quaternion_turns_as_roll_pitch_and_yaw_do(rpy):
    x, y, z, w = quaternion_of(rpy)
    assert math.hypot(x, y, z, w) == pytest.approx(1.0)


def test_a_joint_that_is_not_there_is_named():
    kinematics = Kinematics(load(ROBOTS / "rdk_x3_robot.urdf"))
    with pytest.raises(LookupError, match="Did you mean 'left_front_joint'"):
        kinematics.poses({"left_frnt_joint": 1.0})
    with pytest.raises(LookupError, match="joint 'laser_joint' is fixed"):
        kinematics.poses({"laser_joint": 1.0})


def test_names_cannot_become_code():
    name = "');import os#"
    robot = parse(
        f'<robot name="r"><link name="a"/><link name="{name}"/><joint name="{name}" type="continuous">'
        f'<parent link="a"/><child link="{name}"/></joint></robot>'
    )
    assert list(Kinematics(robot).poses({name: 0.5})) == ["a", name]
