"""ROS packages that programs ask for and that are not part of coursekit: why, and what does their work here."""

from __future__ import annotations

import re

_DRIVER = "is the driver of a device"
_SENSORS = "the simulator's sensors stand in: `ros2 launch gazebo_ros gazebo.launch.py`, then spawn a robot"
_CPP = "is written in C++, which is not compiled here"
_GAZEBO = "belongs to the newer Gazebo; coursekit has Gazebo Classic's names"
_SLAM = "to make a map: `ros2 launch slam_toolbox online_async_launch.py use_sim_time:=true`"
_DRIVE = "to drive: `ros2 run teleop_twist_keyboard teleop_twist_keyboard`, or pad() in a notebook"

_FAMILIES: tuple[tuple[str, str, str], ...] = (
    (r"\w+_(msgs|interfaces)", "holds interfaces", "its source builds here: put it into the src folder of your workspace, "
     "then `colcon build`"),
    (r"cartographer_ros|slam_gmapping|gmapping|hector_\w+|rtabmap\w*", _CPP, _SLAM),
    (r"imu_\w+|robot_pose_ekf", _CPP, "robot_localization's ekf_node takes an IMU's messages as they are"),
    (r"joy_linux|joy_teleop|spacenav|wiimote", _DRIVER, f"`ros2 run joy joy_node` reads a gamepad; {_DRIVE}"),
    (r"moveit\w*|pymoveit2", _CPP, "to move joints by hand: `ros2 run joint_state_publisher_gui joint_state_publisher_gui`"),
    (r"ros_gz\w*|ros_ign\w*|gz_\w+|ign_\w+", _GAZEBO, "`ros2 launch gazebo_ros gazebo.launch.py world:=FILE` and "
     "`ros2 run gazebo_ros spawn_entity.py`"),
    (r"webots_ros2\w*|ignition\w*|isaac\w*|carla\w*|stage_ros2", "needs a simulator of its own",
     "`ros2 launch gazebo_ros gazebo.launch.py`"),
    (r"rplidar_ros|sllidar_ros2|ydlidar\w*|ldlidar\w*|ld08_driver|hls_lfcd_lds_driver|urg_node|velodyne\w*|lslidar\w*",
     _DRIVER, _SENSORS),
    (r"v4l2_camera|usb_cam|camera_ros|realsense2_\w+|gscam|depthai\w*|astra_camera|zed_\w+", _DRIVER, _SENSORS),
    (r"turtlebot3_node|micro_ros_agent|rosserial\w*|diffdrive_arduino|serial_driver|mavros|dynamixel\w*", _DRIVER, _SENSORS),
    (r"interactive_markers", "is not part of the viewer", "to send numbers: `ros2 topic pub`, or pad() in a notebook"),
    (r"rqt|rqt_graph", "opens windows of its own", "in a notebook: graph(), or `ros2 node info NODE` in a terminal"),
    (r"rqt_console", "opens a window of its own", "what nodes log: `ros2 topic echo /rosout`, or the terminals they run in"),
    (r"rqt_\w+|plotjuggler\w*|foxglove\w*|rosbridge\w*", "opens windows or ports of its own",
     "look at topics with `ros2 topic echo TOPIC` and `ros2 topic hz TOPIC`, or viewer() in a notebook"),
    (r"rf2o_laser_odometry", _CPP, "odometry comes from the simulator's drive, or from robot_localization's ekf_node"),
    (r"pendulum_control|examples_rclcpp_(async_client|cbg_executor|minimal_(action_\w+|composition)|multithreaded_executor|wait_set)",
     _CPP,
     "packages with the same lessons: demo_nodes_cpp, composition, image_tools, examples_rclpy_executors"),
    (r"image_proc|image_pipeline|apriltag_ros|aruco\w*|octomap\w*|pcl_\w+|ros1_bridge|nav2_mppi_controller", _CPP,
     "leave it out, or write the node in Python"),
)  # fmt: skip


def remark(package: str) -> str:
    """Why a package is not here and what to type instead; empty for a package of which nothing is known.

    >>> remark("moveit")
    'moveit is not part of coursekit: it is written in C++, which is not compiled here; to move joints by hand: ...'
    >>> remark("my_package")
    ''
    """
    for pattern, why, instead in _FAMILIES:
        if re.fullmatch(pattern, package):
            return f"{package} is not part of coursekit: it {why}; {instead}"
    return ""


_EXECUTABLES = {
    ("demo_nodes_cpp", "allocator_tutorial"): "it counts what C++ allocates, and Python programs do not choose their memory",
    ("controller_manager", "ros2_control_node"): "it loads the C++ drivers of a robot's hardware; in simulation the robot's "
    "<gazebo> plugin libgazebo_ros2_control.so is the controller manager: spawn the robot with `ros2 run gazebo_ros "
    "spawn_entity.py -topic robot_description -entity ROBOT`",
}


def remark_on_executable(package: str, executable: str) -> str:
    """Why a package of coursekit lacks an executable, and what to type instead; empty when nothing is known.

    >>> remark_on_executable("controller_manager", "ros2_control_node")
    "it loads the C++ drivers of a robot's hardware; in simulation ..."
    """
    return _EXECUTABLES.get((package, executable), "")
