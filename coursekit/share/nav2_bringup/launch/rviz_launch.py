"""RViz with navigation's view; when its window is closed, the launch ends."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, EmitEvent, RegisterEventHandler
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import OnProcessExit
from launch.events import Shutdown
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from nav2_common.launch import ReplaceString


def generate_launch_description():
    """Return rviz2, with its topics in a namespace if that is wanted."""
    views = Path(get_package_share_directory("nav2_bringup")) / "rviz"
    namespace, use_namespace = LaunchConfiguration("namespace"), LaunchConfiguration("use_namespace")
    config = LaunchConfiguration("rviz_config")
    plain = Node(
        condition=UnlessCondition(use_namespace), package="rviz2", executable="rviz2", output="screen",
        arguments=["-d", config],
    )  # fmt: skip
    named = ReplaceString(source_file=config, replacements={"<robot_namespace>": ("/", namespace)})
    spaced = Node(
        condition=IfCondition(use_namespace), package="rviz2", executable="rviz2", namespace=namespace, output="screen",
        arguments=["-d", named],
        remappings=[
            ("/tf", "tf"), ("/tf_static", "tf_static"), ("/map", "map"), ("/scan", "scan"), ("/goal_pose", "goal_pose"),
            ("/clicked_point", "clicked_point"), ("/initialpose", "initialpose"),
        ],
    )  # fmt: skip
    ends = [
        RegisterEventHandler(
            condition=condition,
            event_handler=OnProcessExit(target_action=node, on_exit=EmitEvent(event=Shutdown(reason="rviz exited"))),
        )
        for node, condition in ((plain, UnlessCondition(use_namespace)), (spaced, IfCondition(use_namespace)))
    ]
    return LaunchDescription(
        [
            DeclareLaunchArgument("namespace", default_value="navigation", description="Top-level namespace"),
            DeclareLaunchArgument("use_namespace", default_value="false", description="Whether to apply a namespace"),
            DeclareLaunchArgument(
                "rviz_config", default_value=str(views / "nav2_default_view.rviz"),
                description="Full path to the RVIZ config file to use",
            ),
            plain,
            spaced,
            *ends,
        ]
    )
