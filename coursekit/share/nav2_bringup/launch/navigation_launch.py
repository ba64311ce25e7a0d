"""Planner, controller, behaviours and navigator, and who brings them up."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, SetEnvironmentVariable
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import LoadComposableNodes, Node
from launch_ros.descriptions import ComposableNode
from nav2_common.launch import RewrittenYaml

SERVERS = {
    "controller_server": ("nav2_controller", "nav2_controller::ControllerServer"),
    "smoother_server": ("nav2_smoother", "nav2_smoother::SmootherServer"),
    "planner_server": ("nav2_planner", "nav2_planner::PlannerServer"),
    "behavior_server": ("nav2_behaviors", "behavior_server::BehaviorServer"),
    "bt_navigator": ("nav2_bt_navigator", "nav2_bt_navigator::BtNavigator"),
    "waypoint_follower": ("nav2_waypoint_follower", "nav2_waypoint_follower::WaypointFollower"),
    "velocity_smoother": ("nav2_velocity_smoother", "nav2_velocity_smoother::VelocitySmoother"),
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
        for name in (
            "namespace", "use_sim_time", "autostart", "params_file", "use_composition", "container_name", "use_respawn",
            "log_level",
        )
    }
    alone = UnlessCondition(given["use_composition"])
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
            parameters=[parameters], arguments=arguments, remappings=TF + MORE.get(name, []), condition=alone,
        )
        for name, (package, _) in SERVERS.items()
    ]
    managed = {
        "package": "nav2_lifecycle_manager", "name": "lifecycle_manager_navigation",
        "parameters": [
            {"use_sim_time": given["use_sim_time"]}, {"autostart": given["autostart"]}, {"node_names": list(SERVERS)},
        ],
    }
    manager = Node(executable="lifecycle_manager", output="screen", arguments=arguments, condition=alone, **managed)
    composed = LoadComposableNodes(
        condition=IfCondition(given["use_composition"]),
        target_container=[given["namespace"], "/", given["container_name"]],
        composable_node_descriptions=[
            *(
                ComposableNode(
                    package=package, plugin=plugin, name=name, parameters=[parameters],
                    remappings=TF + MORE.get(name, []),
                )
                for name, (package, plugin) in SERVERS.items()
            ),
            ComposableNode(plugin="nav2_lifecycle_manager::LifecycleManager", **managed),
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
            DeclareLaunchArgument("use_composition", default_value="False", description="Use composed bringup if True"),
            DeclareLaunchArgument("container_name", default_value="nav2_container",
                                  description="The container's name, if nodes are composed; it must run already"),
            DeclareLaunchArgument("use_respawn", default_value="False", description="Start a node again when it crashes"),
            DeclareLaunchArgument("log_level", default_value="info", description="log level"),
            *servers,
            manager,
            composed,
        ]
    )
