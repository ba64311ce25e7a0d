"""The newer Gazebo's server, with a world that runs at once."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.actions import ExecuteProcess
from launch.substitutions import LaunchConfiguration

ARGUMENTS = {
    "world_sdf_file": ("", "Path to the SDF world file"),
    "world_sdf_string": ("", "Accepted: give a file."),
    "container_name": ("ros_gz_container", "Accepted."),
    "create_own_container": ("False", "Accepted."),
    "use_composition": ("False", "Accepted."),
}


def _server(context):
    world = LaunchConfiguration("world_sdf_file").perform(context)
    return [ExecuteProcess(cmd=["gz", "sim", "-r", "-s", *([world] if world else [])], output="screen")]


def generate_launch_description():
    """Return the arguments and the server."""
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=text) for name, (default, text) in ARGUMENTS.items()
    ]
    return LaunchDescription([*declared, OpaqueFunction(function=_server)])
