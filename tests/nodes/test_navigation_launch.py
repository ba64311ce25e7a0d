"""Launch files as users of nav2 write them, on the virtual clock: namespaces, components, remapped tf."""

from pathlib import Path

import pytest

from coursekit.cli.parser import run as run_cli
from coursekit.nav.map_file import save_map
from coursekit.nodes.gazebo.simulators import simulators
from tests.nodes.nav2_stage import ROBOT, true_map

TWO_ROBOTS = """
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, GroupAction, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

TF = [("/tf", "tf"), ("/tf_static", "tf_static")]
BRINGUP = os.path.join(get_package_share_directory("nav2_bringup"), "launch", "bringup_launch.py")


def robot(name, x):
    text = open({urdf!r}).read()
    return GroupAction([
        Node(package="robot_state_publisher", executable="robot_state_publisher", namespace=name, remappings=TF,
             parameters=[{{"use_sim_time": True, "robot_description": text}}]),
        Node(package="gazebo_ros", executable="spawn_entity.py",
             arguments=["-entity", name, "-file", {urdf!r}, "-robot_namespace", name, "-x", x]),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(BRINGUP), launch_arguments={{
            "namespace": name, "use_namespace": "True", "map": LaunchConfiguration("map"), "use_sim_time": "True",
        }}.items()),
    ])


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("map"),
        ExecuteProcess(cmd=["gzserver", "-s", "libgazebo_ros_factory.so", "tec_warehouse"]),
        robot("one", "0.0"), robot("two", "3.0"),
    ])
"""
COMPONENTS = """
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import LoadComposableNodes, Node
from launch_ros.descriptions import ComposableNode, ParameterFile
from nav2_common.launch import RewrittenYaml

TF = [("/tf", "tf"), ("/tf_static", "tf_static")]
PARTS = [
    ("nav2_map_server", "nav2_map_server::MapServer", "map_server", []),
    ("nav2_amcl", "nav2_amcl::AmclNode", "amcl", []),
    ("nav2_controller", "nav2_controller::ControllerServer", "controller_server", [("cmd_vel", "cmd_vel_nav")]),
    ("nav2_planner", "nav2_planner::PlannerServer", "planner_server", []),
    ("nav2_behaviors", "behavior_server::BehaviorServer", "behavior_server", []),
    ("nav2_bt_navigator", "nav2_bt_navigator::BtNavigator", "bt_navigator", []),
    ("nav2_velocity_smoother", "nav2_velocity_smoother::VelocitySmoother", "velocity_smoother",
     [("cmd_vel", "cmd_vel_nav"), ("cmd_vel_smoothed", "cmd_vel")]),
]


def generate_launch_description():
    source = get_package_share_directory("nav2_bringup") + "/params/nav2_params.yaml"
    rewrites = {"use_sim_time": "True", "yaml_filename": LaunchConfiguration("map")}
    given = ParameterFile(
        RewrittenYaml(source_file=source, root_key="", param_rewrites=rewrites, convert_types=True), allow_substs=True
    )
    parts = [ComposableNode(package=p, plugin=c, name=n, parameters=[given], remappings=TF + r) for p, c, n, r in PARTS]
    names = [name for _, _, name, _ in PARTS]
    manager = {"use_sim_time": True, "autostart": True, "node_names": names}
    parts.append(ComposableNode(package="nav2_lifecycle_manager", plugin="nav2_lifecycle_manager::LifecycleManager",
                                name="lifecycle_manager", parameters=[manager]))
    return LaunchDescription([
        DeclareLaunchArgument("map"),
        Node(name="nav2_container", package="rclcpp_components", executable="component_container_isolated",
             parameters=[given, {"autostart": True}], remappings=TF),
        LoadComposableNodes(target_container="nav2_container", composable_node_descriptions=parts),
    ])
"""
PROGRAM = """
import rclpy
from geometry_msgs.msg import PoseStamped
from nav2_simple_commander.robot_navigator import BasicNavigator


def pose(x):
    made = PoseStamped()
    made.header.frame_id, made.pose.position.x, made.pose.orientation.w = "map", x, 1.0
    return made


rclpy.init()
robots = [BasicNavigator(namespace=name) for name in NAMES]
for robot, x in zip(robots, STARTS):
    robot.setInitialPose(pose(x))
    robot.waitUntilNav2Active()
for robot, x in zip(robots, STARTS):
    robot.goToPose(pose(x + 1.0))
while not all(robot.isTaskComplete() for robot in robots):
    pass
print("ended", *(robot.getResult().name for robot in robots))
"""


@pytest.fixture
def launch(session, tmp_path):
    """launch(text) starts a launch file with the warehouse's map."""
    file = save_map(tmp_path / "map", true_map("tec_warehouse"))[0]

    def start(text):
        path = tmp_path / "user.launch.py"
        path.write_text(text)
        words = ["launch", str(path), f"map:={file.as_posix()}"]  # in files with substitutions "\\" is Humble's escape
        return session.start(lambda: run_cli(words), name="ros2", argv=words)

    return start


@pytest.fixture
def program(session):
    """program(names, starts) sends each robot a metre on; what was said in the end."""

    def drive(*robots):
        given = {"NAMES": [name for name, _ in robots], "STARTS": [x for _, x in robots]}
        process = session.start(lambda: exec(compile(PROGRAM, "program.py", "exec"), given), name="program")
        process.wait(60.0)
        return process.output.splitlines()[-1]

    return drive


def test_two_robots_in_namespaces_go_their_own_ways(session, launch, program, tmp_path):
    urdf = Path(tmp_path) / "robot.urdf"
    own_tf = "<remapping>odom:=odom</remapping><remapping>/tf:=tf</remapping>"
    urdf.write_text(ROBOT.read_text().replace("<remapping>odom:=odom</remapping>", own_tf))
    launch(TWO_ROBOTS.format(urdf=str(urdf)))
    session.clock.sleep(3.0)
    assert program(("one", 0.0), ("two", 3.0)) == "ended SUCCEEDED SUCCEEDED"
    places = {name: robot.place.x for name, robot in simulators.running(session)[0].simulation.robots.items()}
    assert places == {"one": pytest.approx(1.0, abs=0.35), "two": pytest.approx(4.0, abs=0.35)}


def test_components_in_a_container_drive_through_the_velocity_smoother(session, run, launch, program):
    run("gazebo_ros", "gzserver", "tec_warehouse")
    session.clock.sleep(0.2)
    run("robot_state_publisher", "robot_state_publisher", str(ROBOT), "--ros-args", "-p", "use_sim_time:=true")
    run("gazebo_ros", "spawn_entity.py", "-entity", "rdk", "-file", str(ROBOT)).wait(20.0)
    launch(COMPONENTS)
    session.clock.sleep(3.0)
    assert program(("", 0.0)) == "ended SUCCEEDED"
    assert simulators.running(session)[0].simulation.robots["rdk"].place.x == pytest.approx(1.0, abs=0.35)


def test_the_bringup_composes_its_nodes_in_one_process_when_asked(session, run, program, tmp_path):
    file = save_map(tmp_path / "map", true_map("tec_warehouse"))[0]
    run("gazebo_ros", "gzserver", "tec_warehouse")
    session.clock.sleep(0.2)
    run("robot_state_publisher", "robot_state_publisher", str(ROBOT), "--ros-args", "-p", "use_sim_time:=true")
    run("gazebo_ros", "spawn_entity.py", "-entity", "rdk", "-file", str(ROBOT)).wait(20.0)
    words = ["launch", "nav2_bringup", "bringup_launch.py", f"map:={file}", "use_sim_time:=True", "use_composition:=True"]
    launch = session.start(lambda: run_cli(words), name="ros2", argv=words)
    session.clock.sleep(3.0)
    assert program(("", 0.0)) == "ended SUCCEEDED"
    assert launch.output.count("process started with pid") == 1
    assert launch.output.count("in container '/nav2_container'") == 11
    launch.interrupt()
    assert launch.wait(20.0) == 0
