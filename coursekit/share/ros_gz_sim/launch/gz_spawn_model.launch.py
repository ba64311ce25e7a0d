"""Puts a model into the newer Gazebo's world."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

TEXTS = {"world": "World name", "file": "SDF filename", "model_string": "XML string", "topic": "Topic of the description"}
TEXTS |= {"entity_name": "Name of the entity", "allow_renaming": "Whether a name that is taken is changed"}
NUMBERS = ("x", "y", "z", "roll", "pitch", "yaw")
OPTIONS = {"model_string": "string", "entity_name": "name", "roll": "R", "pitch": "P", "yaw": "Y"}


def generate_launch_description():
    """Return the arguments and who spawns."""
    usual = {"allow_renaming": "False"} | dict.fromkeys(NUMBERS, "0.0")
    declared = [
        DeclareLaunchArgument(name, default_value=usual.get(name, ""), description=TEXTS.get(name, "Of its place"))
        for name in (*TEXTS, *NUMBERS)
    ]
    words = []
    for name in (*TEXTS, *NUMBERS):
        words += [f"-{OPTIONS.get(name, name)}", LaunchConfiguration(name)]
    return LaunchDescription([*declared, Node(package="ros_gz_sim", executable="create", arguments=words, output="screen")])
