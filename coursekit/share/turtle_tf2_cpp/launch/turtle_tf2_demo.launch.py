"""A simulator, two turtles' broadcasters, and a turtle that follows `target_frame`."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    """Return the four nodes."""
    return LaunchDescription(
        [
            Node(package="turtlesim", executable="turtlesim_node", name="sim"),
            DeclareLaunchArgument("target_frame", default_value="turtle1", description="frame to follow"),
            *(
                Node(
                    package="turtle_tf2_cpp",
                    executable="turtle_tf2_broadcaster",
                    name=f"broadcaster{number}",
                    parameters=[{"turtlename": f"turtle{number}"}],
                )
                for number in (1, 2)
            ),
            Node(
                package="turtle_tf2_cpp",
                executable="turtle_tf2_listener",
                name="listener",
                parameters=[{"target_frame": LaunchConfiguration("target_frame")}],
            ),
        ]
    )
