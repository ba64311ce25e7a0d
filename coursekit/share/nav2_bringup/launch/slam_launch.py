"""A map that grows, instead of a saved one: slam_toolbox, and the server that saves its map."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition, UnlessCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from nav2_common.launch import HasNodeParams


def generate_launch_description():
    """Return slam_toolbox, map_saver_server and its manager."""
    here = Path(get_package_share_directory("nav2_bringup"))
    slam = Path(get_package_share_directory("slam_toolbox")) / "launch" / "online_sync_launch.py"
    given = {
        name: LaunchConfiguration(name) for name in ("namespace", "use_sim_time", "autostart", "params_file", "log_level")
    }
    has_own = HasNodeParams(source_file=given["params_file"], node_name="slam_toolbox")
    arguments = ["--ros-args", "--log-level", given["log_level"]]
    return LaunchDescription(
        [
            DeclareLaunchArgument("namespace", default_value="", description="Top-level namespace"),
            DeclareLaunchArgument("use_sim_time", default_value="True", description="Use simulation (Gazebo) clock if true"),
            DeclareLaunchArgument(
                "params_file", default_value=str(here / "params" / "nav2_params.yaml"),
                description="Full path to the ROS2 parameters file to use for all launched nodes",
            ),
            DeclareLaunchArgument("autostart", default_value="True", description="Automatically startup the nav2 stack"),
            DeclareLaunchArgument("use_respawn", default_value="False", description="Start a node again when it crashes"),
            DeclareLaunchArgument("log_level", default_value="info", description="log level"),
            Node(
                package="nav2_map_server", executable="map_saver_server", output="screen", arguments=arguments,
                parameters=[{"use_sim_time": given["use_sim_time"]}],
            ),
            Node(
                package="nav2_lifecycle_manager", executable="lifecycle_manager", name="lifecycle_manager_slam",
                output="screen", arguments=arguments,
                parameters=[
                    {"use_sim_time": given["use_sim_time"]}, {"autostart": given["autostart"]}, {"node_names": ["map_saver"]},
                ],
            ),
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(str(slam)), condition=UnlessCondition(has_own),
                launch_arguments={"use_sim_time": given["use_sim_time"]}.items(),
            ),
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(str(slam)), condition=IfCondition(has_own),
                launch_arguments={
                    "use_sim_time": given["use_sim_time"], "slam_params_file": given["params_file"],
                }.items(),
            ),
        ]
    )
