"""A robot in the viewer: `ros2 launch urdf_tutorial display.launch.py model:=FILE gui:=false`."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return the arguments, the two publishers and the viewer."""
    share = FindPackageShare("urdf_tutorial")
    gui = LaunchConfiguration("gui")
    description = ParameterValue(Command(["xacro ", LaunchConfiguration("model")]), value_type=str)
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
                description="Absolute path to robot urdf file",
            ),
            DeclareLaunchArgument(
                "rvizconfig",
                default_value=PathJoinSubstitution([share, "rviz", "urdf.rviz"]),
                description="Absolute path to rviz config file",
            ),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description}],
            ),
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
