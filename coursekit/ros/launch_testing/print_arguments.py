"""The listing of a launch test's arguments."""

from __future__ import annotations

from launch import LaunchDescription
from launch.utilities.arguments import arguments_text


def print_arguments_of_launch_description(*, launch_description: LaunchDescription) -> None:
    """Print the arguments as `ros2 launch --show-args` does."""
    print(arguments_text(launch_description))
