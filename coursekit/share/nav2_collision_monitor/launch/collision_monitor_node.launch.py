"""The collision monitor, and who brings it up."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from nav2_common.launch import RewrittenYaml


def generate_launch_description():
    """Return the node and its manager."""
    here = Path(get_package_share_directory("nav2_collision_monitor"))
    namespace, use_sim_time = LaunchConfiguration("namespace"), LaunchConfiguration("use_sim_time")
    parameters = RewrittenYaml(
        source_file=LaunchConfiguration("params_file"), root_key=namespace,
        param_rewrites={"use_sim_time": use_sim_time}, convert_types=True,
    )  # fmt: skip
    managed = [{"use_sim_time": use_sim_time}, {"autostart": True}, {"node_names": ["collision_monitor"]}]
    return LaunchDescription([
        DeclareLaunchArgument("namespace", default_value="", description="Top-level namespace"),
        DeclareLaunchArgument("use_sim_time", default_value="true", description="Use the simulator's clock if true"),
        DeclareLaunchArgument(
            "params_file", default_value=str(here / "params" / "collision_monitor_params.yaml"),
            description="Full path to the parameters",
        ),
        Node(
            package="nav2_lifecycle_manager", executable="lifecycle_manager", name="lifecycle_manager_collision_monitor",
            namespace=namespace, output="screen", parameters=managed,
        ),
        Node(
            package="nav2_collision_monitor", executable="collision_monitor", name="collision_monitor",
            namespace=namespace, output="screen", parameters=[parameters],
        ),
    ])  # fmt: skip
