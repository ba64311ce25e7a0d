"""explore with the parameters of config/params.yaml; nav2 and a map that grows run beside it."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    """Return the node and its argument."""
    file = Path(get_package_share_directory("explore_lite")) / "config" / "params.yaml"
    use_sim_time = LaunchConfiguration("use_sim_time")
    return LaunchDescription(
        [
            DeclareLaunchArgument("use_sim_time", default_value="true", description="Use simulation/Gazebo clock"),
            Node(
                package="explore_lite",
                name="explore_node",
                executable="explore",
                parameters=[str(file), {"use_sim_time": use_sim_time}],
                output="screen",
            ),
        ]
    )
