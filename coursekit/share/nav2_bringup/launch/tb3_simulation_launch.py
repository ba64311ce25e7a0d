"""A robot in a simulated world with navigation and RViz: the launch file that nav2's pages begin with.

Robot and world have the names and sizes of TurtleBot 3's, in plain shapes; `robot_sdf`, `robot_name`, `world` and `map`
name others.
"""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, LaunchConfiguration, PythonExpression
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

NAV2 = Path(get_package_share_directory("nav2_bringup"))
ARGUMENTS = {
    "namespace": ("", "Top-level namespace"),
    "use_namespace": ("false", "Whether to apply a namespace to the navigation stack"),
    "slam": ("False", "Whether run a SLAM"),
    "map": (str(NAV2 / "maps" / "turtlebot3_world.yaml"), "Full path to map file to load"),
    "use_sim_time": ("true", "Use simulation (Gazebo) clock if true"),
    "params_file": (str(NAV2 / "params" / "nav2_params.yaml"), "Full path to the ROS2 parameters file to use"),
    "autostart": ("true", "Automatically startup the nav2 stack"),
    "use_composition": ("True", "Whether to use composed bringup"),
    "use_respawn": ("False", "Whether to respawn if a node crashes"),
    "rviz_config_file": (str(NAV2 / "rviz" / "nav2_default_view.rviz"), "Full path to the RVIZ config file to use"),
    "use_simulator": ("True", "Whether to start the simulator"),
    "use_robot_state_pub": ("True", "Whether to start the robot state publisher"),
    "use_rviz": ("True", "Whether to start RVIZ"),
    "headless": ("True", "Whether to execute gzclient)"),
    "world": (
        str(NAV2 / "worlds" / "world_only.model"),
        "Full path to world model file to load, or a world of coursekit_maps",
    ),
    "x_pose": ("-2.00", "Where the robot stands [m]"),
    "y_pose": ("-0.50", "Where the robot stands [m]"),
    "z_pose": ("0.01", "Where the robot stands [m]"),
    "roll": ("0.0", "How the robot stands [rad]"),
    "pitch": ("0.0", "How the robot stands [rad]"),
    "yaw": ("0.0", "Where the robot looks [rad]"),
    "robot_name": ("turtlebot3_waffle", "name of the robot"),
    "robot_sdf": (
        str(NAV2 / "worlds" / "waffle.model"),
        "Full path to robot sdf file to spawn the robot in gazebo, or to a URDF",
    ),
}
TO_NAVIGATION = (
    "namespace", "use_namespace", "slam", "map", "use_sim_time", "params_file", "autostart", "use_composition", "use_respawn",
)  # fmt: skip
TF = [("/tf", "tf"), ("/tf_static", "tf_static")]


def included(folder, name, arguments, condition=None):
    """Another launch file."""
    source = PythonLaunchDescriptionSource(str(Path(folder) / "launch" / name))
    return IncludeLaunchDescription(source, launch_arguments=arguments.items(), condition=condition)


def urdf_of(robot):
    """The file with the frames of a robot: itself, or the waffle's beside its SDF."""
    waffle = (NAV2 / "urdf" / "turtlebot3_waffle.urdf").as_posix()
    return PythonExpression(["r'", robot, "' if r'", robot, "'.endswith(('.urdf', '.xacro')) else '", waffle, "'"])


def generate_launch_description():
    """Return simulator, robot, RViz and navigation."""
    given = {name: LaunchConfiguration(name) for name in ARGUMENTS}
    gazebo = get_package_share_directory("gazebo_ros")
    simulated = IfCondition(given["use_simulator"])
    shown = IfCondition(PythonExpression([given["use_simulator"], " and not ", given["headless"]]))
    description = ParameterValue(Command(["xacro ", urdf_of(given["robot_sdf"])]), value_type=str)
    places = {"-x": "x_pose", "-y": "y_pose", "-z": "z_pose", "-R": "roll", "-P": "pitch", "-Y": "yaw"}
    words = [word for flag, name in places.items() for word in (flag, given[name])]
    words += ["-entity", given["robot_name"], "-file", given["robot_sdf"], "-robot_namespace", given["namespace"]]
    rviz = {
        "namespace": given["namespace"],
        "use_namespace": given["use_namespace"],
        "rviz_config": given["rviz_config_file"],
    }
    return LaunchDescription(
        [
            *(
                DeclareLaunchArgument(name, default_value=default, description=text)
                for name, (default, text) in ARGUMENTS.items()
            ),
            included(gazebo, "gzserver.launch.py", {"world": given["world"]}, simulated),
            included(gazebo, "gzclient.launch.py", {}, shown),
            Node(
                condition=IfCondition(given["use_robot_state_pub"]),
                package="robot_state_publisher",
                executable="robot_state_publisher",
                namespace=given["namespace"],
                output="screen",
                remappings=TF,
                parameters=[{"use_sim_time": given["use_sim_time"], "robot_description": description}],
            ),
            Node(package="gazebo_ros", executable="spawn_entity.py", output="screen", arguments=words),
            included(NAV2, "rviz_launch.py", rviz, IfCondition(given["use_rviz"])),
            included(NAV2, "bringup_launch.py", {name: given[name] for name in TO_NAVIGATION}),
        ]
    )
