"""The simulator: its server; the world is drawn where a notebook asks for it."""

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import ThisLaunchFileDir


def generate_launch_description():
    """Return the server, with all its arguments."""
    server = PythonLaunchDescriptionSource([ThisLaunchFileDir(), "/gzserver.launch.py"])
    return LaunchDescription([IncludeLaunchDescription(server)])
