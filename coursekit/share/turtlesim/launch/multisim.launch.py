"""Two simulators, each in a namespace of its own."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Return the two nodes."""
    return LaunchDescription(
        [
            Node(namespace=name, package="turtlesim", executable="turtlesim_node", output="screen")
            for name in ("turtlesim1", "turtlesim2")
        ]
    )
