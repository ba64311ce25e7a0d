"""The newer Gazebo: its server; the world is drawn where a notebook asks for it."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, OpaqueFunction, Shutdown
from launch.substitutions import LaunchConfiguration

from coursekit.systems.command_lines import split_words

ARGUMENTS = {
    "gz_args": ("", "Arguments to be passed to Gazebo Sim"),
    "gz_version": ("6", "Gazebo Sim's major version"),
    "ign_args": ("", "Deprecated: Arguments to be passed to Gazebo Sim"),
    "ign_version": ("", "Deprecated: Gazebo Sim's major version"),
    "debugger": ("false", "Accepted."),
    "on_exit_shutdown": ("false", "Shutdown on gz-sim exit"),
}


def _server(context):
    told = {name: LaunchConfiguration(name).perform(context) for name in ARGUMENTS}
    words = split_words(told["gz_args"] or told["ign_args"])
    ending = Shutdown() if told["on_exit_shutdown"].lower() in ("true", "1") else None
    return [ExecuteProcess(cmd=["gz", "sim", *words], output="screen", on_exit=ending)]


def generate_launch_description():
    """Return the arguments and the server."""
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=text) for name, (default, text) in ARGUMENTS.items()
    ]
    return LaunchDescription([*declared, OpaqueFunction(function=_server)])
