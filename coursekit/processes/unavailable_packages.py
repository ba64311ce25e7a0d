"""ROS packages that are not part of coursekit: the reason, and the alternative here."""

from __future__ import annotations

import re

_DRIVER = "is the driver of a device"
_SENSORS = "the simulator's sensors stand in: `ros2 launch gazebo_ros gazebo.launch.py`, then spawn a robot"
_CPP = "is written in C++ with libraries that are not here"
_GAZEBO = "belongs to a part of the newer Gazebo that is not simulated"
_SLAM = "to make a map: `ros2 launch slam_toolbox online_async_launch.py use_sim_time:=true`"
_DRIVE = "to drive: `ros2 run teleop_twist_keyboard teleop_twist_keyboard`, or pad() in a notebook"

_REPOSITORIES = {
    "create3_sim of iRobotEducation": r"irobot_create_\w+",
    "turtlebot4 and turtlebot4_simulator of turtlebot": r"turtlebot4_(?!node$|base$)\w+",
    "turtlebot3 and turtlebot3_simulations of ROBOTIS-GIT": r"turtlebot3_(?!node$|manipulation)\w+",
    "turtlebot3_manipulation of ROBOTIS-GIT": r"turtlebot3_manipulation\w*|open_manipulator\w*",
    "Universal_Robots_ROS2_Description of UniversalRobots": r"ur_description",
    "moveit_resources of moveit": r"moveit_resources\w*",
    "branch ros2 of moveit_msgs of moveit": r"moveit_msgs",
    "branch ros2 of nmea_navsat_driver of ros-drivers": r"nmea_navsat_driver|libnmea_navsat_driver",
    "ros2_aruco of JMU-ROBOTICS-VIVA": r"ros2_aruco\w*",
    "realsense-ros of IntelRealSense": r"realsense2_description",
    "andino of Ekumen-OS": r"andino_\w+",
    "linorobot2 of linorobot": r"linorobot2_\w+",
    "rosbot_ros of husarion": r"rosbot_\w+",
    "py_trees_ros and py_trees_ros_interfaces of splintered-reality": r"py_trees_ros\w*",
    "executive_smach of ros": r"smach\w*",
    "rosbridge_suite of RobotWebTools": r"rosbridge_\w+|rosapi\w*",
    "rospy_message_converter of DFKI-NI": r"rclpy_message_converter\w*",
    "ros2_numpy of Box-Robotics": r"ros2_numpy",
    "teleop_tools of ros-teleop": r"(joy|key|mouse)_teleop|teleop_tools\w*",
    "simple_launch of oKermorgant": r"simple_launch",
    "examples of ros2": r"examples_rclcpp_(async_client|minimal_(action_\w+|composition)|cbg_executor"
    r"|multithreaded_executor|wait_set)",
    "demos of ros2": r"demo_nodes_cpp_native|pendulum_control|topic_statistics_demo",
    "aws-robomaker-small-house-world of aws-robotics": r"aws_robomaker_small_house_world",
    "aws-robomaker-small-warehouse-world of aws-robotics": r"aws_robomaker_small_warehouse_world",
}
"""GitHub repositories with packages that are often used and build here."""
_PARTS = {
    "branch ros2 of mavros of mavlink": r"mavros_msgs",
    "micro_ros_msgs of micro-ROS": r"micro_ros_msgs",
    "realsense-ros of IntelRealSense": r"realsense2_camera_msgs",
    "yolo_ros of mgonzs13": r"yolo_msgs",
}
"""GitHub repositories with a package of interfaces that builds here, beside others that do not."""
_ON_PIP = {
    "py_trees": "py_trees", "urdf_parser_py": "urdf-parser-py", "rospkg": "rospkg", "serial": "pyserial",
    "skimage": "scikit-image", "sklearn": "scikit-learn", "paho": "paho-mqtt", "pynput": "pynput", "pygame": "pygame",
    "flask": "flask", "pyproj": "pyproj", "utm": "utm",
}  # fmt: skip
"""Python packages that a robot has from ROS or from its system, and their names for pip, which may be others."""
_CAMERA = "`ros2 run v4l2_camera v4l2_camera_node` publishes a webcam, or what the simulated robot sees, on image_raw"
_QT = "needs Qt for windows of its own"
_FAMILIES: tuple[tuple[str, str, str], ...] = (
    (r"rospy|roscpp|roslib|roslaunch|rosgraph|rosparam|rosbag|actionlib|dynamic_reconfigure|tf|catkin|message_generation",
     "belongs to ROS 1", "ROS 2 has rclpy with parameters and rclpy.action, tf2_ros, launch, rosbag2_py and ament_cmake"),
    (r"map_server|amcl|move_base|robot_pose_publisher|joint_state_controller|ar_track_alvar", "belongs to ROS 1",
     "ROS 2 has nav2_map_server, nav2_amcl, nav2_bringup, joint_state_broadcaster and apriltag_ros"),
    (r"ament_(xmllint|mypy|pycodestyle|pyflakes|black|clang_format|clang_tidy|cppcheck|cpplint|uncrustify|lint_cmake)",
     "checks files with a program that is not here",
     "leave its test out: ament_copyright, ament_flake8 and ament_pep257 are the checks that are here"),
    (r"\w+_description", "describes a robot", "its source builds here: put it into the src folder of your workspace, then "
     "`colcon build`"),
    (r"\w+_(msgs|interfaces)", "holds interfaces", "its source builds here: put it into the src folder of your workspace, "
     "then `colcon build`"),
    (r"cartographer\w*|\w*gmapping|hector_\w+|rtabmap\w*|\w*orb_?slam\d?|lio_sam\w*|fast_lio\w*|(open_)?karto", _CPP, _SLAM),
    (r"(imu_)?bno055\w*|\w*mpu(6050|9250)\w*|wit\w*imu|witmotion_ros|xsens_\w+|phidgets_\w+", _DRIVER, _SENSORS),
    (r"imu_(?!sensor_broadcaster$|tools$|filter_madgwick$|complementary_filter$)\w+|robot_pose_ekf", _CPP,
     "robot_localization's ekf_node takes an IMU's messages as they are"),
    (r"camera_calibration", "asks in a window while a board is held before a camera",
     "`ros2 topic echo /camera/camera_info` has a simulated camera's numbers; cv2.calibrateCamera finds those of another"),
    (r"(ur|xarm|franka|kuka|abb|fanuc)_\w*(driver|bringup|control|hardware|moveit|simulation)\w*", "is the driver of an arm",
     "ros2_control's mock_components/GenericSystem moves its joints as they are told, gazebo_ros2_control in a world"),
    (r"spacenav|wiimote", _DRIVER, f"`ros2 run joy joy_node` reads a gamepad; {_DRIVE}"),
    (r"moveit\w*|pymoveit2", "belongs to MoveIt, whose planners are C++ libraries that are not here",
     "to move an arm: goals for its joint_trajectory_controller, or the sliders of joint_state_publisher_gui"),
    (r"ros_gz_(sim_demos|point_cloud)|ros_ign_(gazebo_demos|point_cloud)|(gz|ign)_(?!ros2_control$)\w+", _GAZEBO,
     "there are ros_gz_sim, ros_gz_bridge, ros_gz_image, ros_gz_interfaces and gz_ros2_control"),
    (r"webots_ros2\w*|ignition\w*|isaac\w*|carla\w*|stage_ros2", "needs a simulator of its own",
     "`ros2 launch gazebo_ros gazebo.launch.py`"),
    (r"rplidar_ros|sllidar_ros2|ydlidar\w*|ldlidar\w*|ld08_driver|hls_lfcd_lds_driver|urg_node2?|velodyne\w*|lslidar\w*"
     r"|livox_\w+|rslidar_\w+|ouster_ros|xv_11_driver|sick_\w+", _DRIVER, _SENSORS),
    (r"camera_ros|gscam2?|cv_camera|opencv_cam", _DRIVER, _CAMERA),
    (r"realsense2_\w+|depthai\w*|astra_camera|orbbec_camera|zed_\w+", _DRIVER, _SENSORS),
    (r"micro_ros_\w+|rosserial\w*", "passes on the topics of a microcontroller", _SENSORS),
    (r"turtlebot3_node|diffdrive_arduino|serial_driver|mavros|dynamixel\w*", _DRIVER, _SENSORS),
    (r"rqt_(?!(graph|console|gui|plot|image_view|publisher|reconfigure|robot_steering|service_caller|tf_tree|topic)$)\w+|plotjuggler\w*|foxglove\w*",
     "opens windows or ports of its own",
     "look at topics with `ros2 topic echo TOPIC` and `ros2 topic hz TOPIC`, or viewer() in a notebook"),
    (r"rviz_(?!2$)\w+|nav2_rviz_plugins", _QT, "viewer() in a notebook, or `ros2 run rviz2 rviz2` with the displays it has"),
    (r"python_qt_binding|qt_gui\w*|qt_dotgraph", _QT, "a panel of ipywidgets in a notebook shows and asks as well"),
    (r"ublox\w*|sound_play|audio_(capture|play)", _DRIVER, _SENSORS),
    (r"RPi|Jetson|smbus2?|spidev|pigpio|gpiozero|lgpio", "talks to the pins of a board", _SENSORS),
    (r"PyKDL|tf2_kdl|kdl_parser_py", _CPP,
     "tf_transformations turns and multiplies rotations, and a tf2_ros Buffer transforms poses"),
    (r"ira_laser_tools|\w*laser_(scan_)?merger|multirobot_map_merge", _CPP, "leave it out, or write the node in Python"),
    (r"(ros2_)?laser_scan_matcher", _CPP,
     "odometry from scans: `ros2 launch rf2o_laser_odometry rf2o_laser_odometry.launch.py`"),
    (r"mapviz\w*|swri_\w+|multires_image", _QT, "viewer() in a notebook, or `ros2 run rviz2 rviz2`"),
    (r"web_video_server", "opens a port of its own", "windows() in a notebook, or `ros2 run image_view image_view`"),
    (r"pcl_(ros|conversions)", "has only its headers for C++ here, not its programs",
     "write a node that filters clouds in C++ with PCL, or in Python with sensor_msgs_py.point_cloud2"),
    (r"behaviortree_(cpp|ros2)|btcpp_ros2_\w+", "belongs to version 4 of BehaviorTree.CPP",
     "Humble's is behaviortree_cpp_v3, version 3.8, which C++ has here"),
    (r"image_pipeline|stereo_image_proc|aruco\w*|octomap\w*|pcl_\w+|ros1_bridge"
     r"|nav2_mppi_controller", _CPP,
     "leave it out, or write the node in Python"),
)  # fmt: skip


def remark(package: str) -> str:
    """Return why a package is not here and the alternative; empty for an unknown package.

    >>> remark("moveit")
    'moveit is not part of coursekit: it belongs to MoveIt, whose planners are C++ libraries that are not here; to move ...'
    >>> remark("my_package")
    ''
    >>> remark("py_trees")
    'py_trees is not part of coursekit, but pip has it: `pip install py_trees`'
    >>> remark("irobot_create_description")
    'irobot_create_description is not part of coursekit, but builds here: clone create3_sim of iRobotEducation into ...'
    """
    for repositories, options in ((_REPOSITORIES, ""), (_PARTS, f" --packages-up-to {package}")):
        for repository, pattern in repositories.items():
            if re.fullmatch(pattern, package):
                where = f"clone {repository} into the src folder of your workspace, then `colcon build{options}`"
                return f"{package} is not part of coursekit, but builds here: {where}"
    if package in _ON_PIP:
        return f"{package} is not part of coursekit, but pip has it: `pip install {_ON_PIP[package]}`"
    for pattern, why, instead in _FAMILIES:
        if re.fullmatch(pattern, package):
            return f"{package} is not part of coursekit: it {why}; {instead}"
    return ""


_EXECUTABLES = {
    ("demo_nodes_cpp", "allocator_tutorial"): "it counts what C++ allocates, and Python programs do not choose their memory",
}


def remark_on_executable(package: str, executable: str) -> str:
    """Return why a package of coursekit lacks an executable, with the alternative; empty if that is unknown.

    >>> remark_on_executable("demo_nodes_cpp", "allocator_tutorial")
    'it counts what C++ allocates, and Python programs do not choose their memory'
    """
    return _EXECUTABLES.get((package, executable), "")
