"""The simulator's server."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

from coursekit.systems.command_lines import split_words

ARGUMENTS = {
    "world": ("", "Specify world file name"),
    "params_file": ("", "Path to ROS 2 yaml parameter file"),
    "pause": ("false", 'Set "true" to start the server in a paused state.'),
    "verbose": ("false", 'Set "true" to list what of a file is not simulated.'),
    "seed": ("0", "Seed of all that is random: noise and drift."),
    "extra_gazebo_args": ("", "Further words for the server's command line"),
    "gui": ("true", "Accepted: the world is drawn where a notebook asks for it."),
    "server": ("true", "Accepted: there is always a server."),
    "init": ("true", "Accepted: time, reset and pause are always there."),
    "factory": ("true", "Accepted: spawning is always there."),
    "force_system": ("true", "Accepted: pushing is always there."),
    "physics": ("", "Accepted: there is one engine."),
}
FURTHER = (
    "version", "lockstep", "help", "play", "record", "record_encoding", "record_path", "record_period", "record_filter",
    "iters", "minimal_comms", "profile", "gdb", "valgrind", "debug", "server_required",
)  # fmt: skip
"""More of gzserver's own arguments; they are accepted."""
ARGUMENTS.update(dict.fromkeys(FURTHER, ("", "Accepted.")))


def _server(context):
    """The server, as the arguments say."""
    told = {name: LaunchConfiguration(name).perform(context) for name in ARGUMENTS}
    paused, verbose = (told[name].lower() in ("true", "1") for name in ("pause", "verbose"))
    words = [told["world"], "--pause" if paused else "--play", "--verbose" if verbose else "--brief"]
    words += ["--seed", told["seed"] or "0", *split_words(told["extra_gazebo_args"])]
    parameters = [told["params_file"]] if told["params_file"] else []
    return [Node(package="gazebo_ros", executable="gzserver", output="screen", arguments=words, parameters=parameters)]


def generate_launch_description():
    """Return the arguments and the server."""
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=text) for name, (default, text) in ARGUMENTS.items()
    ]
    return LaunchDescription([*declared, OpaqueFunction(function=_server)])
