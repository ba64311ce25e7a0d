"""Nothing to start: a notebook draws the world. The arguments of Gazebo's window are accepted."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument


def generate_launch_description():
    """Return the arguments."""
    names = ("gui", "verbose", "extra_gazebo_args")
    return LaunchDescription([DeclareLaunchArgument(name, default_value="") for name in names])
