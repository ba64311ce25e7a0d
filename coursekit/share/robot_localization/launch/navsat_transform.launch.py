"""navsat_transform_node with the parameters of params/navsat_transform.yaml."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Return the node."""
    file = Path(get_package_share_directory("robot_localization")) / "params" / "navsat_transform.yaml"
    return LaunchDescription(
        [
            Node(
                package="robot_localization",
                executable="navsat_transform_node",
                name="navsat_transform_node",
                output="screen",
                parameters=[str(file)],
            ),
        ]
    )
