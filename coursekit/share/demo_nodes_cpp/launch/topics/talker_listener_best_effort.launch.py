"""A talker and a listener that may miss messages."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Return the two nodes."""
    names = ("talker", "listener_best_effort")
    return LaunchDescription([Node(package="demo_nodes_cpp", executable=name, output="screen") for name in names])
