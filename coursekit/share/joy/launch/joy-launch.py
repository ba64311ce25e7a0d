"""joy_node with the parameters of config/joy-params.yaml."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Return the node."""
    file = Path(get_package_share_directory("joy")) / "config" / "joy-params.yaml"
    return LaunchDescription(
        [Node(package="joy", executable="joy_node", name="joy_node", output="both", parameters=[str(file)])]
    )
