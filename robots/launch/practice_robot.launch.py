"""All that runs on the practice robot's computer.

ros2 launch coursekit_robots practice_robot.launch.py world:=robot_world
"""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, Shutdown
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return the base, the state publisher, a screen that shows what is said on /py_str_topic, and a meter of messages."""
    file = PathJoinSubstitution([FindPackageShare("coursekit_robots"), "urdf", "robot_lidar.urdf"])
    description = ParameterValue(Command(["xacro ", file]), value_type=str)
    return LaunchDescription(
        [
            DeclareLaunchArgument("world", default_value="robot_world", description="a world of coursekit_maps"),
            Node(
                package="coursekit_robots",
                executable="practice_base",
                parameters=[{"world": LaunchConfiguration("world")}],
                output="screen",
                on_exit=Shutdown(),  # a robot without wheels is none
            ),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description}],
            ),
            Node(package="coursekit_robots", executable="practice_meter"),
            Node(
                package="demo_nodes_py",
                executable="listener",
                name="screen",
                remappings=[("chatter", "py_str_topic")],
                output="screen",
            ),
        ]
    )
