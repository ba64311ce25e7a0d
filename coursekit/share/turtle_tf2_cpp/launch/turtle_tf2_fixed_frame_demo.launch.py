"""The turtle demo, following a frame that is fixed to turtle1."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    """Return the demo and the frame's broadcaster."""
    folder = os.path.join(get_package_share_directory("turtle_tf2_cpp"), "launch")
    demo = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(os.path.join(folder, "turtle_tf2_demo.launch.py")),
        launch_arguments={"target_frame": "carrot1"}.items(),
    )
    name = "fixed_frame_tf2_broadcaster"
    return LaunchDescription([demo, Node(package="turtle_tf2_cpp", executable=name, name="fixed_broadcaster")])
