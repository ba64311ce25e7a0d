"""One of the course's robots in one of its worlds, with its description, and SLAM if it is wanted.

ros2 launch coursekit_robots simulation.launch.py world:=tec_warehouse slam:=true
"""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare

ARGUMENTS = {
    "world": ("robot_world", "a world of coursekit_maps, or a file: yaml, SDF, a map"),
    "robot": ("rdk_x3_robot", "a robot of coursekit_robots"),
    "x": ("0.0", "where it stands [m]"),
    "y": ("0.0", "where it stands [m]"),
    "yaw": ("0.0", "where it looks [rad]"),
    "slam": ("false", "whether a map is made"),
}


def included(package, file, condition=None, **arguments):
    """Another package's launch file."""
    source = PythonLaunchDescriptionSource(PathJoinSubstitution([FindPackageShare(package), "launch", file]))
    return IncludeLaunchDescription(source, launch_arguments=arguments.items(), condition=condition)


def generate_launch_description():
    """Return simulator, robot_state_publisher, the robot in the world, and SLAM."""
    given = {name: LaunchConfiguration(name) for name in ARGUMENTS}
    file = PathJoinSubstitution([FindPackageShare("coursekit_robots"), "urdf", [given["robot"], ".urdf"]])
    description = ParameterValue(Command(["xacro ", file]), value_type=str)
    place = ["-x", given["x"], "-y", given["y"], "-Y", given["yaw"]]
    spawn = ["-topic", "robot_description", "-entity", given["robot"], *place]
    declared = [DeclareLaunchArgument(name, default_value=one, description=text) for name, (one, text) in ARGUMENTS.items()]
    return LaunchDescription(
        [
            *declared,
            included("gazebo_ros", "gazebo.launch.py", world=given["world"]),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description, "use_sim_time": True}],
            ),
            Node(package="gazebo_ros", executable="spawn_entity.py", arguments=spawn, output="screen"),
            included("slam_toolbox", "online_async_launch.py", IfCondition(given["slam"]), use_sim_time="true"),
        ]
    )
