"""The dummy robot: its map, its joints, its frames and its scan."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Return the four nodes."""
    urdf = Path(get_package_share_directory("dummy_robot_bringup"), "launch", "single_rrbot.urdf").read_text(encoding="utf-8")
    return LaunchDescription(
        [
            Node(package="dummy_map_server", executable="dummy_map_server", output="screen"),
            Node(
                package="robot_state_publisher", executable="robot_state_publisher", name="robot_state_publisher",
                output="screen", parameters=[{"robot_description": urdf}],
            ),
            Node(package="dummy_sensors", executable="dummy_joint_states", output="screen"),
            Node(package="dummy_sensors", executable="dummy_laser", output="screen"),
        ]
    )
