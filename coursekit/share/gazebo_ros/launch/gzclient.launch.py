"""Gazebo's window: a notebook opens it. Its arguments are accepted."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    """Return the arguments and the window."""
    names = ("gui", "verbose", "extra_gazebo_args")
    declared = [DeclareLaunchArgument(name, default_value="") for name in names]
    return LaunchDescription([*declared, Node(package="gazebo_ros", executable="gzclient", output="screen")])
