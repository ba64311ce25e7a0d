"""ROS packages that are not part of coursekit are told with the reason and with what to type instead."""

import importlib
import re

import pytest
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from launch import LaunchContext
from launch.substitutions import SubstitutionFailure
from launch_ros.substitutions import ExecutableInPackage

from coursekit.processes import executables
from coursekit.processes.executables import ExecutableNotFound, PackageNotFound, find
from coursekit.processes.session import Session
from coursekit.processes.unavailable_packages import remark
from coursekit.urdf import UrdfError, load


@pytest.mark.parametrize(
    "package",
    [
        *("cartographer_ros", "spacenav", "moveit_configs_utils", "ros_gz_sim_demos", "aruco_ros", "moveit_servo"),
        *("laser_scan_matcher", "mapviz", "ublox_gps", "web_video_server", "ira_laser_tools", "multirobot_map_merge"),
        *("behaviortree_cpp", "behaviortree_ros2", "pcl_ros", "camera_calibration", "move_base", "openslam_gmapping"),
        *("ros2_orbslam3", "fast_lio", "ur_robot_driver", "rviz_common", "nav2_rviz_plugins"),
        *(
            "micro_ros_agent",
            "imu_bno055",
            "mpu6050_driver",
            "camera_ros",
            "livox_ros_driver2",
            "PyKDL",
            "tf2_kdl",
            "RPi",
            "smbus",
            "sound_play",
        ),
    ],
)
def test_a_known_package_has_a_reason_and_a_way_out(package):
    assert remark(package).startswith(f"{package} is not part of coursekit: it ") and "; " in remark(package)


@pytest.mark.parametrize(
    ("package", "command"),
    [
        ("py_trees_ros", "clone py_trees_ros and py_trees_ros_interfaces"),
        ("rosbridge_server", "clone rosbridge_suite of RobotWebTools"),
        ("joy_teleop", "clone teleop_tools of ros-teleop"),
        ("nmea_navsat_driver", "clone branch ros2 of nmea_navsat_driver of ros-drivers"),
        ("smach_ros", "clone executive_smach of ros"),
        ("urdf_parser_py", "`pip install urdf-parser-py`"),
        ("serial", "`pip install pyserial`"),
        ("skimage", "`pip install scikit-image`"),
        ("paho", "`pip install paho-mqtt`"),
    ],
)
def test_a_python_package_is_told_with_where_it_comes_from(package, command):
    assert f"{package} is not part of coursekit, but" in remark(package) and command in remark(package)


@pytest.mark.parametrize(("module", "instead"), [("rospy", "rclpy"), ("tf", "tf2_ros"), ("actionlib", "rclpy.action")])
def test_a_program_for_ros_1_is_told_what_ros_2_has(module, instead):
    told = pytest.raises(ModuleNotFoundError, match=f"No module named '{module}': .* belongs to ROS 1; .*{instead}")
    with Session(virtual=True).use(), told:
        importlib.import_module(module)


def test_a_check_of_files_that_is_not_here_is_told_with_those_that_are():
    why, those_here = remark("ament_xmllint").rsplit(":", 1)
    assert why.endswith("leave its test out")
    assert re.findall(r"ament_\w+", those_here) == ["ament_copyright", "ament_flake8", "ament_pep257"]


def test_nothing_is_said_of_what_the_underlay_has():
    nodes = [name for name in executables.packages() if not name.endswith(("_msgs", "_interfaces"))]
    assert [name for name in nodes if remark(name)] == []


def test_a_camera_driver_is_told_with_one_that_is_here():
    driver = re.search(r"`ros2 run (\S+) (\S+)`", remark("gscam"))
    assert find(*driver.groups())


def test_run_and_the_index_tell_it():
    with pytest.raises(PackageNotFound, match="not found; robot_pose_ekf is not part"):
        find("robot_pose_ekf", "robot_pose_ekf")
    with pytest.raises(PackageNotFoundError, match="searching: .*; rplidar_ros is not part of coursekit: it is the driver"):
        get_package_share_directory("rplidar_ros")


def test_an_executable_that_cannot_be_here_is_told_too():
    with pytest.raises(ExecutableNotFound, match="It has: .*; it counts what C"):
        find("demo_nodes_cpp", "allocator_tutorial")
    with pytest.raises(SubstitutionFailure, match="the package has: .*; it counts what C"):
        ExecutableInPackage("allocator_tutorial", "demo_nodes_cpp").perform(LaunchContext())


def test_an_import_tells_it_and_stays_an_import_error():
    with Session(virtual=True).use():
        with pytest.raises(ModuleNotFoundError, match="No module named 'moveit_configs_utils': .*C"):
            importlib.import_module("moveit_configs_utils")
        with pytest.raises(ModuleNotFoundError, match="^No module named 'no_such_module'$"):
            importlib.import_module("no_such_module")


@pytest.mark.parametrize(
    ("package", "where"),
    [
        ("irobot_create_description", "clone create3_sim of iRobotEducation into the src folder"),
        ("turtlebot3_gazebo", "turtlebot3_simulations"),
        ("ur_description", "Universal_Robots_ROS2_Description"),
        ("moveit_msgs", "clone branch ros2 of moveit_msgs of moveit"),
        ("mavros_msgs", "clone branch ros2 of mavros of mavlink"),
        ("mavros_msgs", "`colcon build --packages-up-to mavros_msgs`"),
        ("ros2_aruco_interfaces", "clone ros2_aruco of JMU"),
        ("somebodys_description", "put it into the src folder of your workspace"),
    ],
)
def test_a_description_that_is_missing_is_told_with_what_to_fetch(tmp_path, package, where):
    assert where in remark(package)
    file = tmp_path / "robot.urdf.xacro"
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    file.write_text(f'{head}<xacro:include filename="$(find {package})/urdf/x.xacro"/></robot>')
    with pytest.raises(UrdfError, match=where):
        load(file)
    assert "clone" not in remark("turtlebot3_node")


def test_the_older_name_of_a_navigator_s_result_is_known():
    from nav2_simple_commander.robot_navigator import NavigationResult, TaskResult

    assert NavigationResult is TaskResult
