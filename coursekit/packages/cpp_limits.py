"""Whether a C++ build failed because coursekit lacks something that a robot has, not because of an author's mistake."""

from __future__ import annotations

import re
from collections.abc import Collection

_PACKAGE = re.compile(r'(?:configuration file provided by|not providing) "(?:Find)?([\w.+-]+?)(?:\.cmake)?"')
_HEADER = re.compile(r"fatal error: '?([\w./+-]+)'?(?::| file)")
_NOT_YET = re.compile(
    r"(tf2_bullet|image_transport|laser_geometry|rmw_\w+|diagnostic_updater|image_geometry|interactive_markers|urdf"
    r"|camera_info_manager|rosbag2_transport|message_filters|rclcpp_components"
    r"|opencv2|Eigen|rcl|rcl_\w+|rcpputils|rclcpp/(wait_set\w*|guard_condition"
    r"|parameter_client|parameter_event_\w+|serialization|loaned_message|node_interfaces|executors|strategies|experimental|topic_\w+"
    r"|contexts|graph_listener|message_info|parameter_events_filter|subscription_\w+|waitable|type_support_decl|detail)"
    r"|nav2_util/costmap|nav2_lifecycle_manager/lifecycle_manager\."
    r"|rosbag2_cpp/(converter_interfaces|typesupport_helpers)|hardware_interface/resource_manager"
    r"|controller_manager/controller_manager|joint_trajectory_controller|diff_drive_controller|robot_state_publisher"
    r"|control_toolbox/(dither|limited_proxy|sine_sweep|sinusoid)|realtime_tools/realtime_helpers"
    r"|rcutils/(configuration_flags|qsort|stdatomic_helper|testing"
    r"|types/(array_list|hash_map|string_map))|rosidl_typesupport_introspection_c"
    r"|nav2_core/behavior_tree_navigator|nav2_costmap_2d/(clear_costmap_service|costmap_2d_publisher|costmap_filters"
    r"|denoise|observation|obstacle_layer|range_sensor_layer|static_layer|voxel_layer)\w*"
    r"|nav2_behaviors/plugins|nav2_behavior_tree/(plugins|bt_action_server\w*)|nav2_map_server|nav_2d_utils|bondcpp|behaviortree_cpp"
    r"|gazebo|gazebo_ros|gazebo_plugins|ignition|sdf"
    r"|behaviortree_cpp_v3/(controls/manual_node|decorators/timer_queue|flatbuffers|loggers/bt_(file|minitrace|zmq)_\w+"
    r"|utils/(any|simple_string))"
    r"|rmw/(allocators|event_callback_type|features|get_\w+|impl|init|init_options|message_sequence|names_and_types"
    r"|network_flow_endpoint|subscription_content_filter_options|validate_\w+))(/|\.hpp|\.h)"
)
"""Headers of Humble that coursekit does not have."""
_OTHER_VERSION = {"behaviortree_cpp": "that of Humble is behaviortree_cpp_v3, version 3.8"}
"""Packages of another version than Humble's tutorials have, and what is here."""
NO_EIGEN = "there is no Eigen for C++ here: `pip install cmeel-eigen` brings it"
_GAZEBO = {"gazebo", "gazebo_dev"}
"""Gazebo's own library, which came with gazebo_ros on a robot; plugins for it cannot be compiled here."""

_OF_THE_SYSTEM = re.compile(r"([\w+-]+) is not\s+here:\s+(sudo\s+apt\s+install(?:(?: |\n {2})[\w+-]+)+)")
"""The message of our CMake files about a library that only the system can provide; CMake breaks its lines."""


def reason(text: str, depends: Collection[str], stood_for: bool) -> str:
    """Return why a package's C++ is skipped, from the output of CMake and the compiler; '' if the mistake is the author's.

    `depends` are the dependencies in its package.xml; `stood_for` means that coursekit has programs that replace it.

    >>> reason("a.cpp:1:10: fatal error: tf2_bullet/tf2_bullet.hpp: No such file or directory", [], False)
    'tf2_bullet/tf2_bullet.hpp is not among what C++ has here'
    >>> reason("a.cpp:1:10: fatal error: rmw/features.h: No such file or directory", [], False)
    'rmw/features.h is not among what C++ has here'
    >>> reason("a.cpp:1:10: fatal error: nav2_util/costmap.hpp: No such file or directory", ["nav2_util"], False)
    'nav2_util/costmap.hpp is not among what C++ has here'
    >>> reason("a.cpp:1:10: fatal error: rclcpp/rclcp.hpp: No such file or directory", ["rclcpp"], False)
    ''
    >>> reason("a.cpp:1:10: fatal error: behaviortree_cpp/bt_factory.h: No such file or directory", [], False)
    'behaviortree_cpp/bt_factory.h is not among what C++ has here: that of Humble is behaviortree_cpp_v3, version 3.8'
    >>> reason("kdl_parser: orocos_kdl is not here: sudo apt install\\n  liborocos-kdl-dev\\nCall Stack", [], False)
    'there is no orocos_kdl for C++ here: `sudo apt install liborocos-kdl-dev` brings it, on Debian and Ubuntu'
    >>> reason('By not providing "FindEigen3.cmake" in CMAKE_MODULE_PATH', ["eigen"], False) == NO_EIGEN
    True
    >>> reason('By not providing "Findgazebo.cmake" in CMAKE_MODULE_PATH', ["gazebo_ros"], False)
    'C++ has no gazebo here'
    """
    if missing := _OF_THE_SYSTEM.search(text):
        command = " ".join(missing[2].split())
        return f"there is no {missing[1]} for C++ here: `{command}` brings it, on Debian and Ubuntu"
    for name in _PACKAGE.findall(text):
        if name == "Eigen3":
            return NO_EIGEN
        if name in depends or name in _GAZEBO or stood_for:
            return f"C++ has no {name} here{_instead(name)}"
    for name in _HEADER.findall(text):
        if _NOT_YET.match(name):
            return f"{name} is not among what C++ has here{_instead(name.partition('/')[0])}"
    return ""


def _instead(package: str) -> str:
    return f": {_OTHER_VERSION[package]}" if package in _OTHER_VERSION else ""
