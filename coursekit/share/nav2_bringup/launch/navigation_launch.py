"""Planner, controller, behaviours and navigator, and who brings them up."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, SetEnvironmentVariable
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from nav2_common.launch import RewrittenYaml

SERVERS = {
    "controller_server": "nav2_controller",
    "smoother_server": "nav2_smoother",
    "planner_server": "nav2_planner",
    "behavior_server": "nav2_behaviors",
    "bt_navigator": "nav2_bt_navigator",
    "waypoint_follower": "nav2_waypoint_follower",
    "velocity_smoother": "nav2_velocity_smoother",
}
TF = [("/tf", "tf"), ("/tf_static", "tf_static")]
MORE = {
    "controller_server": [("cmd_vel", "cmd_vel_nav")],
    "velocity_smoother": [("cmd_vel", "cmd_vel_nav"), ("cmd_vel_smoothed", "cmd_vel")],
}


def generate_launch_description():
    """Return the servers and their manager."""
    here = Path(get_package_share_directory("nav2_bringup"))
    given = {
        name: LaunchConfiguration(name)
        for name in ("namespace", "use_sim_time", "autostart", "params_file", "use_respawn", "log_level")
    }
    parameters = RewrittenYaml(
        source_file=given["params_file"],
        root_key=given["namespace"],
        param_rewrites={"use_sim_time": given["use_sim_time"], "autostart": given["autostart"]},
        convert_types=True,
    )
    arguments = ["--ros-args", "--log-level", given["log_level"]]
    servers = [
        Node(
            package=package, executable=name, name=name, output="screen",
            respawn=given["use_respawn"], respawn_delay=2.0,
            parameters=[parameters], arguments=arguments, remappings=TF + MORE.get(name, []),
        )
        for name, package in SERVERS.items()
    ]
    manager = Node(
        package="nav2_lifecycle_manager", executable="lifecycle_manager", name="lifecycle_manager_navigation",
        output="screen", arguments=arguments,
        parameters=[
            {"use_sim_time": given["use_sim_time"]}, {"autostart": given["autostart"]}, {"node_names": list(SERVERS)},
        ],
    )
    return LaunchDescription(
        [
            SetEnvironmentVariable("RCUTILS_LOGGING_BUFFERED_STREAM", "1"),
            DeclareLaunchArgument("namespace", default_value="", description="Top-level namespace"),
            DeclareLaunchArgument("use_sim_time", default_value="false", description="Use simulation (Gazebo) clock if true"),
            DeclareLaunchArgument(
                "params_file", default_value=str(here / "params" / "nav2_params.yaml"),
                description="Full path to the ROS2 parameters file to use for all launched nodes",
            ),
            DeclareLaunchArgument("autostart", default_value="true", description="Automatically startup the nav2 stack"),
            DeclareLaunchArgument("use_composition", default_value="False", description="Accepted; nodes run on their own here"),
            DeclareLaunchArgument("container_name", default_value="nav2_container", description="Accepted, for use_composition"),
            DeclareLaunchArgument("use_respawn", default_value="False", description="Start a node again when it crashes"),
            DeclareLaunchArgument("log_level", default_value="info", description="log level"),
            *servers,
            manager,
        ]
    )
