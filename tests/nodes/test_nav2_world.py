"""The world and the robot of nav2's pages, and launch files that start them."""

import math
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import rclpy
from ament_index_python.packages import get_package_share_directory
from geometry_msgs.msg import PoseStamped
from nav2_simple_commander.robot_navigator import BasicNavigator

from coursekit.cli.parser import run as run_cli
from coursekit.nav.map_file import load_map
from coursekit.nodes.gazebo.devices import RayDevice
from coursekit.nodes.gazebo.sdf_world import read_entity
from coursekit.nodes.gazebo.simulators import simulators
from coursekit.urdf import load
from tests.nodes.nav2_stage import true_map

BRINGUP = Path(get_package_share_directory("nav2_bringup"))
WORLD_OF_A_TURTLEBOT = """
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription
from launch_ros.actions import Node

BRINGUP = get_package_share_directory("nav2_bringup")
TF = [("/tf", "tf"), ("/tf_static", "tf_static")]


def generate_launch_description():
    with open(os.path.join(BRINGUP, "urdf", "turtlebot3_waffle.urdf")) as file:
        description = file.read()
    plugins = ["-s", "libgazebo_ros_init.so", "-s", "libgazebo_ros_factory.so"]
    navigation = {"map": os.path.join(BRINGUP, "maps", "turtlebot3_world.yaml"), "use_sim_time": "True", "namespace": "tb",
                  "use_namespace": "True"}
    return LaunchDescription([
        ExecuteProcess(cmd=["gzserver", *plugins, os.path.join(BRINGUP, "worlds", "world_only.model")], output="screen"),
        Node(package="robot_state_publisher", executable="robot_state_publisher", namespace="tb", remappings=TF,
             parameters=[{"use_sim_time": True, "robot_description": description}]),
        Node(package="gazebo_ros", executable="spawn_entity.py", output="screen",
             arguments=["-entity", "waffle", "-file", os.path.join(BRINGUP, "worlds", "waffle.model"),
                        "-robot_namespace", "tb", "-x", "-2.0", "-y", "-0.5", "-z", "0.01"]),
        IncludeLaunchDescription(os.path.join(BRINGUP, "launch", "bringup_launch.py"), launch_arguments=navigation.items()),
    ])
"""


def pose(x, y):
    stamped = PoseStamped()
    stamped.header.frame_id, stamped.pose.position.x, stamped.pose.position.y, stamped.pose.orientation.w = "map", x, y, 1.0
    return stamped


def across(namespace):
    """From the west of the world to its east, between the pillars."""
    drive(namespace, (-2.0, -0.5), (1.7, 0.5))


def drive(namespace, start, goal):
    """A program that drives a robot; what it prints ends with the goal's status."""
    rclpy.init()
    robot = BasicNavigator(namespace=namespace)
    robot.setInitialPose(pose(*start))
    robot.waitUntilNav2Active()
    robot.goToPose(pose(*goal))
    while not robot.isTaskComplete():
        pass
    print("ended", robot.getResult().name)


def arrived(session, name, namespace):
    """Drive across; whether the robot is there, in its own eyes and in truth."""
    process = session.start(lambda: across(namespace), name="program")
    process.wait(120.0)
    place = simulators.running(session)[0].simulation.robots[name].place
    return process.output.endswith("ended SUCCEEDED\n") and math.hypot(place.x - 1.7, place.y - 0.5) < 0.4


@pytest.mark.slow
def test_the_launch_file_of_nav2_s_pages_brings_up_a_world_a_robot_and_navigation(session):
    words = ["launch", "nav2_bringup", "tb3_simulation_launch.py", "use_rviz:=False"]
    launched = session.start(lambda: run_cli(words), name="ros2", argv=words)
    session.clock.sleep(3.0)
    assert arrived(session, "turtlebot3_waffle", "")
    launched.interrupt()
    assert launched.wait(10.0) == 0


@pytest.mark.slow
def test_a_launch_file_of_ones_own_drives_its_waffle_in_its_world(session, tmp_path):
    (tmp_path / "own.launch.py").write_text(WORLD_OF_A_TURTLEBOT)
    words = ["launch", str(tmp_path / "own.launch.py")]
    session.start(lambda: run_cli(words), name="ros2", argv=words)
    session.clock.sleep(3.0)
    assert arrived(session, "waffle", "tb")


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [
        ["unique_multi_tb3_simulation_launch.py"],
        ["cloned_multi_tb3_simulation_launch.py", "robots:=robot1={x: 0.0, y: 0.5}; robot2={x: 0.0, y: -0.5}"],
    ],
)
def test_two_robots_of_one_launch_file_drive_to_goals_of_their_own(session, words):
    words = ["launch", "nav2_bringup", *words, "use_rviz:=False", "autostart:=True"]
    launched = session.start(lambda: run_cli(words), name="ros2", argv=["ros2", *words])
    session.clock.sleep(3.0)
    routes = {"robot1": ((0.0, 0.5), (1.7, 0.5)), "robot2": ((0.0, -0.5), (-1.7, -0.5))}
    driven = [session.start(partial(drive, name, *routes[name]), name="program") for name in routes]
    for process, (name, (_, goal)) in zip(driven, routes.items(), strict=True):
        process.wait(120.0)
        place = simulators.running(session)[0].simulation.robots[name].place
        assert process.output.endswith("ended SUCCEEDED\n"), process.output + launched.output
        assert math.dist((place.x, place.y), goal) < 0.4


def test_nav2_s_page_takes_another_robot_and_another_world(session):
    robot = Path(get_package_share_directory("coursekit_robots")) / "urdf" / "rdk_x3_robot.urdf"
    words = ["launch", "nav2_bringup", "tb3_simulation_launch.py", "use_rviz:=False", "world:=robot_world", "x_pose:=0.0",
             "y_pose:=0.0", "robot_name:=car", f"robot_sdf:={robot.as_posix()}"]  # fmt: skip
    launched = session.start(lambda: run_cli(words), name="ros2", argv=words)
    session.clock.sleep(3.0)
    assert "car" in simulators.running(session)[0].simulation.robots
    assert "lidar" in run_cli_output(session, "param", "get", "/robot_state_publisher", "robot_description"), launched.output


def run_cli_output(session, *words):
    process = session.start(lambda: run_cli(list(words)), name="ros2", argv=words)
    process.wait(5.0)
    return process.output


def test_the_map_is_that_of_the_world():
    seen = true_map(str(BRINGUP / "worlds" / "world_only.model"), start=(-2.0, -0.5))
    kept = load_map(BRINGUP / "maps" / "turtlebot3_world.yaml")
    assert np.array_equal(kept.cells, seen.cells) and kept.origin == pytest.approx(seen.origin)


def test_the_laser_of_gazebo_s_waffle_is_where_its_frame_is():
    driven = read_entity((BRINGUP / "worlds" / "waffle.model").read_text())
    ray = next(device for device in driven.devices if isinstance(device, RayDevice))
    drawn = load(BRINGUP / "urdf" / "turtlebot3_waffle.urdf")
    x, _, z = np.sum([drawn.joint(name).origin.xyz for name in ("base_joint", "scan_joint")], axis=0)
    assert (ray.frame, ray.lidar.mount.x) == ("base_scan", pytest.approx(x)) and ray.lidar.height == pytest.approx(
        z, abs=0.011
    )
