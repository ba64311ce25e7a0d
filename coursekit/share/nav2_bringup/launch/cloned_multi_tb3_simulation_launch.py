"""Several robots of one kind in one simulated world, each with a navigation of its own, in a namespace of its name.

The command line says which: robots:="robot1={x: 1.0, y: 1.0, yaw: 1.57}; robot2={x: -1.0, y: 0.5}".
"""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, LogInfo
from launch.substitutions import LaunchConfiguration
from nav2_common.launch import ParseMultiRobotPose

NAV2 = Path(get_package_share_directory("nav2_bringup"))
ARGUMENTS = {
    "world": (str(NAV2 / "worlds" / "world_only.model"), "Full path to world file to load"),
    "map": (str(NAV2 / "maps" / "turtlebot3_world.yaml"), "Full path to map file to load"),
    "params_file": (
        str(NAV2 / "params" / "nav2_params.yaml"),
        "Full path to the ROS2 parameters file to use for all launched nodes",
    ),
    "autostart": ("false", "Automatically startup the stacks"),
    "rviz_config": (str(NAV2 / "rviz" / "nav2_namespaced_view.rviz"), "Full path to the RVIZ config file to use."),
    "use_robot_state_pub": ("True", "Whether to start the robot state publisher"),
    "use_rviz": ("True", "Whether to start RVIZ"),
}
SHARED = ("map", "params_file", "autostart", "use_robot_state_pub", "use_rviz")
PLACES = {"x": "x_pose", "y": "y_pose", "z": "z_pose", "roll": "roll", "pitch": "pitch", "yaw": "yaw"}


def generate_launch_description():
    """Return the world, and for each robot RViz and navigation."""
    given = {name: LaunchConfiguration(name) for name in ARGUMENTS}
    gazebo = Path(get_package_share_directory("gazebo_ros"))
    robots = ParseMultiRobotPose("robots").value()
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=text) for name, (default, text) in ARGUMENTS.items()
    ]
    world = IncludeLaunchDescription(
        str(gazebo / "launch" / "gzserver.launch.py"), launch_arguments={"world": given["world"]}.items()
    )
    told = LogInfo(msg=f"number_of_robots={len(robots)}")
    return LaunchDescription([*declared, world, told, *(robot(name, pose, given) for name, pose in robots.items())])


def robot(name, pose, given):
    """One robot, in its namespace."""
    arguments = {
        **{shared: given[shared] for shared in SHARED}, **{place: str(pose[axis]) for axis, place in PLACES.items()},
        "namespace": name, "use_namespace": "True", "robot_name": name, "rviz_config_file": given["rviz_config"],
        "use_simulator": "False",
    }  # fmt: skip
    return GroupAction(
        [
            LogInfo(msg=f"Launching namespace={name} init_pose={pose}"),
            IncludeLaunchDescription(str(NAV2 / "launch" / "tb3_simulation_launch.py"), launch_arguments=arguments.items()),
        ]
    )
