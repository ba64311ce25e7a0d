"""Packages in the shapes of public courses and robots: built by colcon, started by their launch files, driven."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from control_msgs.action import FollowJointTrajectory, GripperCommand
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Image, Imu, JointState, LaserScan
from tf2_msgs.msg import TFMessage

from coursekit.packages.overlay import overlay_environment
from tests.nodes.control.test_arm import send, trajectory

SOURCE = Path(__file__).parents[2] / "fixtures" / "gz_ws" / "src"
BIN = Path(sys.executable).parent
pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    """The workspace, built once."""
    root = tmp_path_factory.mktemp("gz") / "gz_ws"
    shutil.copytree(SOURCE, root / "src")
    env = {key: value for key, value in os.environ.items() if not key.startswith(("AMENT_", "COURSEKIT_"))}
    words = [BIN / "colcon", "build", "--symlink-install"]
    built = subprocess.run(words, cwd=root, env=env, capture_output=True, encoding="utf-8", timeout=240)
    assert built.returncode == 0, built.stdout + built.stderr
    return root


@pytest.fixture
def launch(session, workspace):
    """launch("package", "file.launch.py", "name:=value")"""
    from coursekit.cli.parser import run

    def start(*words):
        env = overlay_environment(workspace / "install", os.environ)
        return session.start(lambda: run(["launch", *words]), name="ros2", argv=words, env=env)

    return start


def drive(friend, kind, topic, seconds=2.0, ahead=0.2):
    """Send a command ten times a second."""
    out, msg = friend.node.create_publisher(kind, topic, 10), kind()
    getattr(msg, "twist", msg).linear.x = ahead
    for _ in range(round(seconds * 10)):
        out.publish(msg)
        friend.spin(0.1)


def test_a_cart_with_xacro_and_gz_ros2_control_drives(launch, friend):
    started = launch("cart_bringup", "launch_sim.launch.py")
    friend.spin(5.0)
    assert "Traceback" not in started.output and "process has died" not in started.output, started.output
    odometry, scans, joints = (
        friend.hear(*type_and_topic)
        for type_and_topic in ((Odometry, "/diff_cont/odom"), (LaserScan, "/scan"), (JointState, "/joint_states"))
    )
    drive(friend, Twist, "/diff_cont/cmd_vel_unstamped")
    assert odometry[-1].pose.pose.position.x == pytest.approx(0.4, abs=0.08)
    assert scans[-1].header.frame_id == "laser_frame" and min(scans[-1].ranges) == pytest.approx(1.6, abs=0.15)
    assert set(joints[-1].name) == {"left_wheel_joint", "right_wheel_joint"} and joints[-1].position[0] > 5


def test_a_robot_with_gazebo_s_drive_and_a_bridge_by_yaml(launch, friend):
    started = launch("scout_gz", "scout_gz.launch.py")
    friend.spin(5.0)
    assert "Traceback" not in started.output and "process has died" not in started.output, started.output
    kinds = (Odometry, "/odom"), (LaserScan, "/scan"), (JointState, "/joint_states"), (Imu, "/imu"), (TFMessage, "/tf")
    odometry, scans, joints, imu, tf = (friend.hear(*type_and_topic) for type_and_topic in kinds)
    pictures = friend.hear(Image, "/camera/image_raw")
    friend.spin(1.5)
    drive(friend, Twist, "/cmd_vel")
    assert odometry[-1].pose.pose.position.x == pytest.approx(0.4, abs=0.08), "odometry begins where it was spawned"
    assert (odometry[-1].header.frame_id, odometry[-1].child_frame_id) == ("scout/odom", "scout/base_footprint")
    frames = {transform.child_frame_id for msg in tf for transform in msg.transforms}
    assert {"scout/base_footprint", "left_wheel"} <= frames
    assert scans and joints and imu[-1].header.frame_id == "scout/base_footprint/imu"
    assert (pictures[-1].width, pictures[-1].header.frame_id) == (64, "camera_link")


def test_a_robot_that_is_a_model_in_a_folder_of_models(launch, friend):
    started = launch("burger_gazebo", "world.launch.py")
    friend.spin(5.0)
    assert "Traceback" not in started.output and "process has died" not in started.output, started.output
    kinds = (Clock, "/clock"), (Odometry, "/odom"), (LaserScan, "/scan"), (JointState, "/joint_states")
    clock, odometry, scans, joints = (friend.hear(*type_and_topic) for type_and_topic in kinds)
    drive(friend, TwistStamped, "/cmd_vel")
    assert odometry[-1].pose.pose.position.x == pytest.approx(0.4, abs=0.1) and clock
    ahead = scans[-1].ranges[0]
    assert ahead == pytest.approx(1.5 - 0.15 + 0.032 - 0.4, abs=0.1), "the pillar of model://"
    assert set(joints[-1].name) == {"wheel_left_joint", "wheel_right_joint"}


def test_a_robot_with_the_older_names_under_long_topics(launch, friend):
    started = launch("rover_ignition", "ignition.launch.py")
    friend.spin(5.0)
    assert "Traceback" not in started.output and "process has died" not in started.output, started.output
    odometry, scans = friend.hear(Odometry, "/odom"), friend.hear(LaserScan, "/scan")
    drive(friend, Twist, "/cmd_vel")
    assert odometry[-1].pose.pose.position.x == pytest.approx(0.4, abs=0.08)
    assert scans[-1].header.frame_id == "rover/base_footprint/scanner"


def test_an_arm_with_fake_hardware_is_launched_and_moved(launch, friend):
    started = launch("arm_bringup", "arm.launch.py")
    friend.spin(5.0)
    assert "Traceback" not in started.output and "process has died" not in started.output, started.output
    states = friend.hear(JointState, "/joint_states")
    names = [f"joint_{n}" for n in range(1, 7)]
    goal = FollowJointTrajectory.Goal(trajectory=trajectory(([0.3] * 6, 2), joints=names))
    result, status = send(friend, FollowJointTrajectory, "/joint_trajectory_controller/follow_joint_trajectory", goal)
    assert (result.error_code, status) == (0, 4)
    grip = GripperCommand.Goal()
    grip.command.position = 0.02
    assert send(friend, GripperCommand, "/gripper_controller/gripper_cmd", grip)[1] == 4
    friend.spin(0.3)
    at = dict(zip(states[-1].name, states[-1].position, strict=True))
    assert [at[name] for name in names] == pytest.approx([0.3] * 6) and at["gripper_mimic"] == pytest.approx(0.02)
