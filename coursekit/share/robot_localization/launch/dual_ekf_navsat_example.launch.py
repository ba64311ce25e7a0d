"""A robot with GPS: a filter in odom without it, a filter in map with it, and what converts fixes between them."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    """Return the three nodes, with the parameters of params/dual_ekf_navsat_example.yaml."""
    file = Path(get_package_share_directory("robot_localization")) / "params" / "dual_ekf_navsat_example.yaml"

    def node(executable, name, **remapped):
        return Node(
            package="robot_localization",
            executable=executable,
            name=name,
            output="screen",
            parameters=[str(file)],
            remappings=list(remapped.items()),
        )

    return LaunchDescription(
        [
            DeclareLaunchArgument("output_final_position", default_value="false"),
            DeclareLaunchArgument("output_location", default_value="~/dual_ekf_navsat_example_debug.txt"),
            node("ekf_node", "ekf_filter_node_odom", **{"odometry/filtered": "odometry/local"}),
            node("ekf_node", "ekf_filter_node_map", **{"odometry/filtered": "odometry/global"}),
            node("navsat_transform_node", "navsat_transform", imu="imu/data", **{"odometry/filtered": "odometry/global"}),
        ]
    )
