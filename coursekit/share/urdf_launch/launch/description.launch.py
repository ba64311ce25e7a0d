"""robot_state_publisher with the description of a URDF or xacro file."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return the arguments and the node."""
    path = PathJoinSubstitution(
        [FindPackageShare(LaunchConfiguration("urdf_package")), LaunchConfiguration("urdf_package_path")]
    )
    description = ParameterValue(Command(["xacro ", path]), value_type=str)
    return LaunchDescription(
        [
            DeclareLaunchArgument("urdf_package",
                description="The package where the robot description is located",
            ),
            DeclareLaunchArgument(
                "urdf_package_path", description="The path to the robot description relative to the package root"
            ),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description}],
            ),
        ]
    )
