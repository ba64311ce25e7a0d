"""The bridge, by a YAML file."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

ARGUMENTS = {
    "bridge_name": ("ros_gz_bridge", "Name of ros_gz_bridge node"),
    "config_file": ("", "YAML config file"),
    "container_name": ("ros_gz_container", "Accepted: the bridge is a process of its own."),
    "create_own_container": ("False", "Accepted."),
    "namespace": ("", "Top-level namespace"),
    "use_composition": ("False", "Accepted."),
    "use_respawn": ("False", "Accepted."),
    "log_level": ("info", "log level"),
    "bridge_params": ("", "Accepted."),
}


def generate_launch_description():
    """Return the arguments and the bridge."""
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=text) for name, (default, text) in ARGUMENTS.items()
    ]
    bridge = Node(
        package="ros_gz_bridge",
        executable="bridge_node",
        name=LaunchConfiguration("bridge_name"),
        namespace=LaunchConfiguration("namespace"),
        output="screen",
        parameters=[{"config_file": LaunchConfiguration("config_file")}],
        arguments=["--ros-args", "--log-level", LaunchConfiguration("log_level")],
    )
    return LaunchDescription([*declared, bridge])
