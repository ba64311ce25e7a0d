"""The simulator's server."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node

ARGUMENTS = {
    "world": ("", "Specify world file name"),
    "pause": ("false", 'Set "true" to start the server in a paused state.'),
    "verbose": ("false", 'Set "true" to list what of a file is not simulated.'),
    "seed": ("0", "Seed of all that is random: noise and drift."),
    "params_file": ("", "Path to ROS 2 yaml parameter file"),
    "gui": ("true", "Accepted: the world is drawn where a notebook asks for it."),
    "server": ("true", "Accepted: there is always a server."),
    "init": ("true", "Accepted: time, reset and pause are always there."),
    "factory": ("true", "Accepted: spawning is always there."),
    "force_system": ("true", "Accepted."),
    "debug": ("false", "Accepted."),
    "extra_gazebo_args": ("", "Accepted."),
    "physics": ("", "Accepted: there is one engine."),
}


def _choice(name, yes, no):
    """One word where an argument says true, the other where it does not."""
    return PythonExpression([f"'{yes}' if '", LaunchConfiguration(name), f"' in ('true', 'True', '1') else '{no}'"])


def generate_launch_description():
    """Return the arguments and the server."""
    paused, words = _choice("pause", "--pause", "--play"), _choice("verbose", "--verbose", "--brief")
    arguments = [LaunchConfiguration("world"), paused, words, "--seed", LaunchConfiguration("seed")]
    return LaunchDescription(
        [
            *(
                DeclareLaunchArgument(name, default_value=default, description=text)
                for name, (default, text) in ARGUMENTS.items()
            ),
            Node(package="gazebo_ros", executable="gzserver", output="screen", arguments=arguments),
        ]
    )
