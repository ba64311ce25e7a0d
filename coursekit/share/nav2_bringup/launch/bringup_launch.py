"""Navigation as a whole: localisation in a map (or SLAM), and all that drives the robot to its goals."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, SetEnvironmentVariable
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node, PushRosNamespace
from nav2_common.launch import RewrittenYaml

PASSED_ON = ("namespace", "use_sim_time", "autostart", "params_file", "use_composition", "use_respawn", "log_level")
TF = [("/tf", "tf"), ("/tf_static", "tf_static")]


def generate_launch_description():
    """Return the three parts."""
    here = Path(get_package_share_directory("nav2_bringup"))
    slam, use_namespace = LaunchConfiguration("slam"), LaunchConfiguration("use_namespace")
    given = {name: LaunchConfiguration(name) for name in PASSED_ON}

    rewrites = {"use_sim_time": given["use_sim_time"], "yaml_filename": LaunchConfiguration("map")}
    parameters = RewrittenYaml(
        source_file=given["params_file"], root_key=given["namespace"], param_rewrites=rewrites, convert_types=True
    )

    def part(name, more=(), condition=None):
        return IncludeLaunchDescription(
            PythonLaunchDescriptionSource(str(here / "launch" / name)), condition=condition,
            launch_arguments={**given, **dict(more)}.items(),
        )

    return LaunchDescription(
        [
            SetEnvironmentVariable("RCUTILS_LOGGING_BUFFERED_STREAM", "1"),
            DeclareLaunchArgument("namespace", default_value="", description="Top-level namespace"),
            DeclareLaunchArgument("use_namespace", default_value="false", description="Whether to apply a namespace"),
            DeclareLaunchArgument("slam", default_value="False", description="Whether run a SLAM"),
            DeclareLaunchArgument("map", default_value="", description="Full path to map yaml file to load (not with slam)"),
            DeclareLaunchArgument("use_sim_time", default_value="false", description="Use simulation (Gazebo) clock if true"),
            DeclareLaunchArgument(
                "params_file", default_value=str(here / "params" / "nav2_params.yaml"),
                description="Full path to the ROS2 parameters file to use for all launched nodes",
            ),
            DeclareLaunchArgument("autostart", default_value="true", description="Automatically startup the nav2 stack"),
            DeclareLaunchArgument("use_composition", default_value="False", description="Whether to use composed bringup"),
            DeclareLaunchArgument("use_respawn", default_value="False", description="Start a node again when it crashes"),
            DeclareLaunchArgument("log_level", default_value="info", description="log level"),
            GroupAction(
                [
                    PushRosNamespace(condition=IfCondition(use_namespace), namespace=given["namespace"]),
                    Node(
                        name="nav2_container", package="rclcpp_components", executable="component_container_isolated",
                        condition=IfCondition(given["use_composition"]), output="screen", remappings=TF,
                        parameters=[parameters, {"autostart": given["autostart"]}],
                        arguments=["--ros-args", "--log-level", given["log_level"]],
                    ),
                    part("slam_launch.py", condition=IfCondition(slam)),
                    part(
                        "localization_launch.py", {"map": LaunchConfiguration("map")},
                        IfCondition(PythonExpression(["not ", slam])),
                    ),
                    part("navigation_launch.py"),
                ]
            ),
        ]
    )
