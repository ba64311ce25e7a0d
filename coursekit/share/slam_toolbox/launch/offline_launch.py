"""sync_slam_toolbox_node with the parameters of a file."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    """Return the node and its two arguments."""
    file = Path(get_package_share_directory("slam_toolbox")) / "config" / "mapper_params_offline.yaml"
    return LaunchDescription(
        [
            DeclareLaunchArgument("use_sim_time", default_value="true", description="Use simulation/Gazebo clock"),
            DeclareLaunchArgument(
                "slam_params_file", default_value=str(file), description="Full path to the node's parameter file"
            ),
            Node(
                package="slam_toolbox",
                executable="sync_slam_toolbox_node",
                name="slam_toolbox",
                output="screen",
                parameters=[
                    LaunchConfiguration("slam_params_file"),
                    {"use_sim_time": LaunchConfiguration("use_sim_time")},
                ],
            ),
        ]
    )
