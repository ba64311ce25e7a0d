"""Two turtles' frames, and points of turtle3 that a message filter can take into turtle1's frame."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    """Return the simulator, the frames and the points."""
    package = "turtle_tf2_py"

    def frame(number, turtle):
        name = f"broadcaster{number}"
        given = [{"turtlename": turtle}]
        return Node(package=package, executable="turtle_tf2_broadcaster", name=name, parameters=given)

    return LaunchDescription(
        [
            DeclareLaunchArgument("target_frame", default_value="turtle1", description="Target frame name."),
            Node(package="turtlesim", executable="turtlesim_node", name="sim", output="screen"),
            frame(1, "turtle1"),
            frame(2, "turtle3"),
            Node(package=package, executable="turtle_tf2_message_broadcaster", name="message_broadcaster"),
        ]
    )
