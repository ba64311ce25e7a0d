"""A server that adds two numbers, and a client that asks it."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Return the two nodes."""
    server = Node(package="demo_nodes_cpp", executable="add_two_ints_server", output="screen")
    client = Node(package="demo_nodes_cpp", executable="add_two_ints_client_async", output="screen")
    return LaunchDescription([server, client])
