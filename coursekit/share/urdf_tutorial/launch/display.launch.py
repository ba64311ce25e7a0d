"""A robot in the viewer: `ros2 launch urdf_tutorial display.launch.py model:=FILE gui:=false`."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def _robot_state_publisher(context):
    """A model that is not there is looked for in the tutorial's package, as `model:=urdf/06-flexible.urdf`."""
    model = LaunchConfiguration("model").perform(context)
    if not os.path.exists(model):
        model = os.path.join(get_package_share_directory("urdf_tutorial"), model)
    description = ParameterValue(Command(["xacro ", model]), value_type=str)
    package = "robot_state_publisher"
    return [Node(package=package, executable=package, parameters=[{"robot_description": description}])]


def generate_launch_description():
    """Return the arguments, the two publishers and the viewer."""
    share = FindPackageShare("urdf_tutorial")
    gui = LaunchConfiguration("gui")
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "gui",
                default_value="true",
                choices=["true", "false"],
                description="Flag to enable joint_state_publisher_gui",
            ),
            DeclareLaunchArgument(
                "model",
                default_value=PathJoinSubstitution([share, "urdf", "01-myfirst.urdf"]),
                description="Path to robot urdf file, absolute or in the package urdf_tutorial",
            ),
            DeclareLaunchArgument(
                "rvizconfig",
                default_value=PathJoinSubstitution([share, "rviz", "urdf.rviz"]),
                description="Absolute path to rviz config file",
            ),
            OpaqueFunction(function=_robot_state_publisher),
            Node(
                package="joint_state_publisher", executable="joint_state_publisher", condition=UnlessCondition(gui)
            ),
            Node(
                package="joint_state_publisher_gui",
                executable="joint_state_publisher_gui",
                condition=IfCondition(gui),
            ),
            Node(
                package="rviz2",
                executable="rviz2",
                name="rviz2",
                output="screen",
                arguments=["-d", LaunchConfiguration("rvizconfig")],
            ),
        ]
    )
