"""The packages that find_package() finds along with another, as on a robot: those that its headers need."""

from __future__ import annotations

import re
from pathlib import Path

from coursekit.files import read_text

_TF2 = "builtin_interfaces geometry_msgs rclcpp tf2"
EXPORTED = {
    "rclcpp": "ament_index_cpp libstatistics_collector rcl rcl_interfaces rcl_yaml_param_parser rcpputils rcutils rmw "
    "builtin_interfaces rosgraph_msgs statistics_msgs rosidl_runtime_cpp rosidl_typesupport_cpp tracetools",
    "rcutils": "ament_cmake",
    "rclcpp_action": "action_msgs rclcpp",
    "rclcpp_components": "ament_index_cpp class_loader composition_interfaces rclcpp rcpputils",
    "rclcpp_lifecycle": "lifecycle_msgs rclcpp",
    "tf2": "builtin_interfaces console_bridge geometry_msgs rcutils",
    "tf2_ros": f"{_TF2} message_filters rcl_interfaces rclcpp_action rclcpp_components tf2_msgs",
    "tf2_geometry_msgs": f"{_TF2} tf2_ros",
    "tf2_eigen": f"{_TF2} tf2_ros",
    "tf2_kdl": f"{_TF2} tf2_ros",
    "kdl_parser": "urdf urdfdom_headers",
    "tf2_sensor_msgs": f"{_TF2} sensor_msgs tf2_ros",
    "filters": "pluginlib rclcpp",
    "message_filters": "rclcpp std_msgs",
    "laser_geometry": "rclcpp sensor_msgs tf2",
    "pcl_conversions": "message_filters pcl_msgs rclcpp sensor_msgs std_msgs",
    "pcl_ros": "geometry_msgs pcl_conversions rclcpp sensor_msgs tf2 tf2_geometry_msgs tf2_ros",
    "cv_bridge": "sensor_msgs",
    "image_transport": "message_filters pluginlib rclcpp sensor_msgs",
    "image_geometry": "sensor_msgs",
    "image_tools": "rclcpp sensor_msgs std_msgs",
    "camera_calibration_parsers": "rclcpp sensor_msgs",
    "camera_info_manager": "camera_calibration_parsers rclcpp rclcpp_lifecycle sensor_msgs",
    "interactive_markers": "rclcpp tf2 tf2_geometry_msgs tf2_ros visualization_msgs",
    "diagnostic_updater": "diagnostic_msgs rclcpp std_msgs",
    "realtime_tools": "rclcpp rclcpp_action",
    "control_toolbox": "control_msgs rclcpp rcutils realtime_tools",
    "controller_interface": "hardware_interface rclcpp_lifecycle sensor_msgs",
    "controller_manager": "controller_interface controller_manager_msgs hardware_interface pluginlib rclcpp",
    "hardware_interface": "control_msgs lifecycle_msgs pluginlib rclcpp_lifecycle rcpputils rcutils",
    "nav2_behavior_tree": "behaviortree_cpp_v3 geometry_msgs nav2_msgs nav2_util nav_msgs rclcpp rclcpp_action "
    "rclcpp_lifecycle sensor_msgs std_msgs std_srvs tf2 tf2_geometry_msgs tf2_ros",
    "nav2_behaviors": "geometry_msgs nav2_core nav2_costmap_2d nav2_msgs nav2_util nav_msgs pluginlib rclcpp rclcpp_action "
    "rclcpp_lifecycle std_msgs tf2 tf2_geometry_msgs tf2_ros",
    "nav2_core": "geometry_msgs lifecycle_msgs nav2_costmap_2d nav2_util nav_msgs pluginlib rclcpp rclcpp_lifecycle "
    "std_msgs tf2_ros",
    "nav2_costmap_2d": "geometry_msgs laser_geometry map_msgs message_filters nav2_msgs nav2_util nav_msgs pluginlib rclcpp "
    "rclcpp_lifecycle sensor_msgs std_msgs std_srvs tf2 tf2_geometry_msgs tf2_ros tf2_sensor_msgs visualization_msgs",
    "nav2_util": "action_msgs geometry_msgs lifecycle_msgs nav2_msgs nav_msgs rcl_interfaces rclcpp rclcpp_action "
    "rclcpp_lifecycle std_srvs tf2 tf2_geometry_msgs tf2_ros",
    "transmission_interface": "hardware_interface pluginlib rclcpp",
    "generate_parameter_library": "parameter_traits rclcpp rclcpp_lifecycle rsl tcb_span tl_expected",
    "behaviortree_cpp_v3": "ament_index_cpp",
    "class_loader": "console_bridge rcpputils",
    "pluginlib": "ament_index_cpp class_loader rcpputils rcutils",
    "urdf": "pluginlib urdf_parser_plugin urdfdom urdfdom_headers",
    "rosbag2_cpp": "pluginlib rclcpp rcpputils rcutils rosbag2_storage",
    "rosbag2_compression": "rcpputils rcutils rosbag2_cpp rosbag2_storage",
    "rosbag2_transport": "rclcpp rosbag2_compression rosbag2_cpp rosbag2_interfaces rosbag2_storage",
}
"""The exports of upstream's packages; an interface package exports the dependencies in its package.xml."""
HUMBLE = "16.0.11"
"""The version of rclcpp and its companions."""
VERSIONS = dict.fromkeys(("rclcpp", "rclcpp_action", "rclcpp_components", "rclcpp_lifecycle"), HUMBLE) | {
    "OpenCV": "4.5.4",
    "behaviortree_cpp_v3": "3.8.7",
}
"""The versions of packages without a folder in the underlay's share, for find_package() with a version."""


def exported_by(name: str, share: Path) -> list[str]:
    """Return the packages that are found along with one.

    >>> from coursekit.interfaces.find import UNDERLAY
    >>> exported_by("nav_msgs", UNDERLAY / "share")
    ['builtin_interfaces', 'geometry_msgs', 'std_msgs']
    """
    text = _manifest(name, share)
    of_interfaces = re.findall(r"<depend>([^<]+)<", text) if "rosidl_interface_packages" in text else []
    return of_interfaces or EXPORTED.get(name, "").split()


def version_of_package(name: str, share: Path) -> str:
    """Return the version of a package; '' if it is not specified.

    >>> version_of_package("OpenCV", Path("share"))
    '4.5.4'
    """
    match = re.search(r"<version>([^<]+)<", _manifest(name, share))
    return VERSIONS.get(name) or (match[1] if match else "")


def _manifest(name: str, share: Path) -> str:
    path = share / name / "package.xml"
    return read_text(path) if path.is_file() else ""
