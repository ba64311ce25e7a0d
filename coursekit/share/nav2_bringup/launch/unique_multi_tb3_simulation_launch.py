"""Two robots in one simulated world, each with a navigation of its own: `robot1` and `robot2` are their namespaces.

Their parameters may differ: `robot1_params_file` and `robot2_params_file` name the files.
"""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, LogInfo
from launch.substitutions import LaunchConfiguration

NAV2 = Path(get_package_share_directory("nav2_bringup"))
POSES = {"robot1": {"x_pose": "0.0", "y_pose": "0.5"}, "robot2": {"x_pose": "0.0", "y_pose": "-0.5"}}
ARGUMENTS = {
    "world": (str(NAV2 / "worlds" / "world_only.model"), "Full path to world file to load"),
    "map": (str(NAV2 / "maps" / "turtlebot3_world.yaml"), "Full path to map file to load"),
    **{
        f"{robot}_params_file": (
            str(NAV2 / "params" / "nav2_params.yaml"),
            f"Full path to the ROS2 parameters file to use for {robot} launched nodes",
        )
        for robot in POSES
    },
    "autostart": ("false", "Automatically startup the stacks"),
    "rviz_config": (str(NAV2 / "rviz" / "nav2_namespaced_view.rviz"), "Full path to the RVIZ config file to use."),
    "use_robot_state_pub": ("True", "Whether to start the robot state publisher"),
    "use_rviz": ("True", "Whether to start RVIZ"),
}
SHARED = ("map", "autostart", "use_robot_state_pub")


def generate_launch_description():
    """Return the world, and for each robot RViz and navigation."""
    given = {name: LaunchConfiguration(name) for name in ARGUMENTS}
    gazebo = Path(get_package_share_directory("gazebo_ros"))
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=text) for name, (default, text) in ARGUMENTS.items()
    ]
    world = IncludeLaunchDescription(
        str(gazebo / "launch" / "gzserver.launch.py"), launch_arguments={"world": given["world"]}.items()
    )
    return LaunchDescription([*declared, world, *(robot(name, pose, given) for name, pose in POSES.items())])


def robot(name, pose, given):
    """One robot, in its namespace."""
    arguments = {
        **{shared: given[shared] for shared in SHARED}, **pose, "z_pose": "0.01",
        "namespace": name, "use_namespace": "True", "robot_name": name, "params_file": given[f"{name}_params_file"],
        "rviz_config_file": given["rviz_config"], "use_rviz": given["use_rviz"], "use_simulator": "False",
    }  # fmt: skip
    return GroupAction(
        [
            LogInfo(msg=["Launching ", name]),
            IncludeLaunchDescription(str(NAV2 / "launch" / "tb3_simulation_launch.py"), launch_arguments=arguments.items()),
        ]
    )
