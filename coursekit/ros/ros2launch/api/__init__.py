"""Launch files found, shown and run by programs, as `ros2 launch` does."""

from launch import InvalidLaunchFileError
from launch.launch_description_sources import InvalidPythonLaunchFileError

from .api import (
    LaunchFileNameCompleter,
    MultipleLaunchFilesError,
    get_launch_file_paths,
    get_share_file_path_from_package,
    is_launch_file,
    launch_a_launch_file,
    parse_launch_arguments,
    print_a_launch_file,
    print_arguments_of_launch_description,
    print_arguments_of_launch_file,
)

__all__ = [
    "InvalidLaunchFileError",
    "InvalidPythonLaunchFileError",
    "LaunchFileNameCompleter",
    "MultipleLaunchFilesError",
    "get_launch_file_paths",
    "get_share_file_path_from_package",
    "is_launch_file",
    "launch_a_launch_file",
    "parse_launch_arguments",
    "print_a_launch_file",
    "print_arguments_of_launch_description",
    "print_arguments_of_launch_file",
]
