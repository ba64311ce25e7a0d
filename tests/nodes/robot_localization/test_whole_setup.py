"""A robot as people launch it: odometry without tf, ekf_node, twist_mux, a gamepad and nav2; in a namespace too."""

import math
from pathlib import Path

import pytest

from coursekit.cli.parser import run as run_cli
from coursekit.nav.map_file import save_map
from coursekit.nodes.gazebo.simulators import simulators
from tests.nodes.nav2_stage import true_map
from tests.nodes.robot_localization.conftest import mask

URDF = Path(__file__).with_name("diff_drive.urdf")
LAUNCH = """
from pathlib import Path
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node

TF = [("/tf", "tf"), ("/tf_static", "tf_static")]
SPACE = "{space}"
BRINGUP = get_package_share_directory("nav2_bringup") + "/launch/bringup_launch.py"


def node(package, executable, *remappings, **parameters):
    return Node(package=package, executable=executable, namespace=SPACE, remappings=TF + list(remappings),
                parameters=[{{"use_sim_time": True}}, parameters])


def generate_launch_description():
    true, false = True, False  # as parameters write them
    told = {{"namespace": SPACE, "use_namespace": str(bool(SPACE)), "use_sim_time": "True", "map": {map!r},
            "slam": "{slam}"}}
    ekf = {{"two_d_mode": True, "odom0": "odom", "odom0_config": {wheels}, "imu0": "imu", "imu0_config": {gyroscope}}}
    topics = {{"nav": {{"topic": "nav_vel", "timeout": 0.5, "priority": 10}},
              "joy": {{"topic": "joy_vel", "timeout": 0.5, "priority": 100}}}}
    return LaunchDescription([
        ExecuteProcess(cmd=["gzserver", "robot_world"]),
        node("robot_state_publisher", "robot_state_publisher", robot_description=Path({urdf!r}).read_text()),
        Node(package="gazebo_ros", executable="spawn_entity.py",
             arguments=["-entity", "car", "-file", {urdf!r}] + (["-robot_namespace", SPACE] if SPACE else [])),
        node("robot_localization", "ekf_node", **ekf),
        node("twist_mux", "twist_mux", ("cmd_vel_out", "mux_vel"), topics=topics),
        node("joy", "joy_node"),
        node("teleop_twist_joy", "teleop_node", ("cmd_vel", "joy_vel")),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(BRINGUP), launch_arguments=told.items()),
    ])
"""


def tour(space, slam):
    import rclpy
    from geometry_msgs.msg import PoseStamped
    from nav2_simple_commander.robot_navigator import BasicNavigator

    def pose(x, y):
        stamped = PoseStamped()
        stamped.header.frame_id, stamped.pose.position.x, stamped.pose.position.y = "map", x, y
        stamped.pose.orientation.w = 1.0
        return stamped

    rclpy.init()
    robot = BasicNavigator(namespace=space)
    if not slam:
        robot.setInitialPose(pose(0.0, 0.0))
        robot.waitUntilNav2Active()
    robot.goToPose(pose(1.3, 0.3))
    while not robot.isTaskComplete():
        pass
    print("ended", robot.getResult().name)


@pytest.mark.slow
@pytest.mark.parametrize("space, slam", [("", False), ("bot", False), ("", True)])
def test_navigation_drives_on_the_filters_odometry(session, tmp_path, space, slam):
    map_file = save_map(tmp_path / "map", true_map("robot_world"))[0]
    file = tmp_path / "user.launch.py"
    wheels, gyroscope = mask("vx", "vy", "vyaw"), mask("vyaw")
    told = {"space": space, "map": str(map_file), "slam": slam, "urdf": str(URDF), "wheels": wheels, "gyroscope": gyroscope}
    file.write_text(LAUNCH.format(**told))
    launched = session.start(lambda: run_cli(["launch", str(file)]), name="ros2", argv=["launch"])
    session.clock.sleep(8.0)
    tourist = session.start(lambda: tour(space, slam), name="tour")
    tourist.wait(120.0)
    place = simulators.running(session)[0].simulation.robots["car"].place
    assert "ended SUCCEEDED" in tourist.output, launched.output[-3000:]
    assert math.hypot(place.x - 1.3, place.y - 0.3) < 0.4
