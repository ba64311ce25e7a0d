"""Headers that only include another: upstream has one file per class, coursekit fewer."""

from __future__ import annotations

from pathlib import Path

FORWARDED = {
    "rclcpp/rclcpp.hpp": (
        "allocator/allocator_deleter contexts/default_context create_client "
        "create_generic_publisher create_generic_subscription create_publisher create_service create_subscription "
        "create_timer executor_options executors/multi_threaded_executor executors/single_threaded_executor "
        "executors/static_executor_entities_collector executors/static_single_threaded_executor generic_publisher "
        "generic_subscription init_options intra_process_buffer_type intra_process_setting is_ros_compatible_type "
        "loaned_message message_info node_impl node_interfaces/get_node_base_interface "
        "node_interfaces/get_node_parameters_interface node_interfaces/get_node_timers_interface "
        "node_interfaces/get_node_topics_interface node_interfaces/node_base node_interfaces/node_clock "
        "node_interfaces/node_clock_interface node_interfaces/node_graph node_interfaces/node_graph_interface "
        "node_interfaces/node_logging node_interfaces/node_logging_interface node_interfaces/node_parameters "
        "node_interfaces/node_parameters_interface node_interfaces/node_services node_interfaces/node_services_interface "
        "node_interfaces/node_time_source node_interfaces/node_time_source_interface node_interfaces/node_timers "
        "node_interfaces/node_timers_interface node_interfaces/node_topics node_interfaces/node_topics_interface "
        "node_interfaces/node_waitables node_interfaces/node_waitables_interface parameter_service publisher_base "
        "qos_overriding_options serialization subscription_base subscription_content_filter_options "
        "subscription_options subscription_traits subscription_wait_set_mask topic_statistics_state "
        "type_support_decl wait_result wait_result_kind wait_set_policies/dynamic_storage "
        "wait_set_policies/sequential_synchronization wait_set_policies/static_storage "
        "wait_set_policies/thread_safe_synchronization wait_set_template"
    ),
    "rclcpp/exceptions.hpp": "exceptions/exceptions",
    "rclcpp/memory_strategy.hpp": "memory_strategies",
    "coursekit/visibility.hpp": (
        "/ament_index_cpp/visibility_control.h /message_filters/visibility_control.h /rclcpp_action/visibility_control.hpp "
        "/rclcpp_components/visibility_control.hpp /rcpputils/visibility_control.hpp /rcutils/visibility_control.h "
        "/rcl/visibility_control.h /rcl_yaml_param_parser/visibility_control.h /rmw/visibility_control.h "
        "/kdl_parser/visibility_control.hpp /tf2/visibility_control.h /tf2_ros/visibility_control.h "
        "/urdf/visibility_control.hpp /libstatistics_collector/visibility_control.hpp "
        "/image_geometry/visibility_control.hpp /image_transport/visibility_control.hpp "
        "/laser_geometry/visibility_control.hpp /cv_bridge/cv_bridge_export.h "
        "/rosbag2_cpp/visibility_control.hpp /rosbag2_storage/visibility_control.hpp "
        "/rosbag2_transport/visibility_control.hpp /transmission_interface/visibility_control.h "
        "/rcutils/visibility_control_macros.h "
        "/rosidl_typesupport_cpp/visibility_control.h /rosidl_runtime_c/visibility_control.h"
    ),
    "image_transport/simple_publisher_plugin.hpp": "publisher_plugin",
    "image_transport/simple_subscriber_plugin.hpp": "subscriber_plugin",
    "rcutils/types.h": (
        "/rcl/macros.h types/char_array.h types/string_array.h types/uint8_array.h"
    ),
    "rosidl_runtime_c/primitives_sequence.h": "primitives_sequence_functions.h",
    "rosidl_runtime_c/string.h": "string_functions.h u16string.h u16string_functions.h",
    "rcutils/types/rcutils_ret.h": "/rmw/ret_types.h",
    "rcutils/format_string.h": "snprintf.h",
    "rcutils/env.h": "get_env.h",
    "rcutils/macros.h": "/rmw/macros.h",
    "rcpputils/env.hpp": "get_env",
    "rmw/types.h": "qos_policy_kind.h time.h",
    "rcl/wait.h": "client.h event.h guard_condition.h service.h subscription.h timer.h",
    "rcl/init_options.h": "init.h",
    "rclcpp_action/types.hpp": "qos",
    "rcl_action/types.h": "action_client.h action_server.h goal_handle.h rcl_action.h wait.h",
    "rcl_lifecycle/data_types.h": "default_state_machine.h rcl_lifecycle.h transition_map.h",
    "rclcpp/qos_event.hpp": (
        "/rmw/event.h /rmw/incompatible_qos_events_statuses.h /rmw/events_statuses/events_statuses.h "
        "/rmw/events_statuses/incompatible_qos.h /rmw/events_statuses/liveliness_changed.h "
        "/rmw/events_statuses/liveliness_lost.h /rmw/events_statuses/message_lost.h "
        "/rmw/events_statuses/offered_deadline_missed.h /rmw/events_statuses/requested_deadline_missed.h"
    ),
    "rclcpp/topic_endpoint_info.hpp": "/rmw/topic_endpoint_info.h",
    "rosidl_typesupport_cpp/message_type_support.hpp": (
        "/rosidl_runtime_cpp/message_type_support_decl.hpp /rosidl_runtime_cpp/service_type_support_decl.hpp"
    ),
    "rosidl_typesupport_introspection_cpp/message_introspection.hpp": "field_types identifier message_type_support_decl",
    "rosidl_typesupport_introspection_cpp/service_introspection.hpp": "service_type_support_decl",
    "tf2/LinearMath/Quaternion.h": "LinearMath/QuadWord.h",
    "tf2/buffer_core_interface.h": "buffer_core_interface.hpp",
    "tf2/time_cache.h": "time_cache.hpp",
    "tf2_kdl/tf2_kdl.hpp": "tf2_kdl.h",
    "ament_index_cpp/get_package_prefix.hpp": "get_search_paths",
    "libstatistics_collector/moving_average_statistics/moving_average.hpp": "moving_average_statistics/types",
    "libstatistics_collector/collector/collector.hpp": "collector/metric_details_interface",
    "libstatistics_collector/topic_statistics_collector/topic_statistics_collector.hpp": (
        "topic_statistics_collector/constants topic_statistics_collector/received_message_age "
        "topic_statistics_collector/received_message_period"
    ),
    "pluginlib/class_loader.hpp": "class_desc class_loader_base",
    "transmission_interface/exception.hpp": "transmission_interface_exception",
    "transmission_interface/transmission_loader.hpp": (
        "simple_transmission_loader differential_transmission_loader four_bar_linkage_transmission_loader"
    ),
    "parameter_traits/parameter_traits.hpp": "comparison validators",
    "realtime_tools/realtime_box.h": "realtime_box.hpp",
    "realtime_tools/realtime_buffer.h": "realtime_buffer.hpp",
    "realtime_tools/realtime_clock.h": "realtime_clock.hpp",
    "realtime_tools/realtime_publisher.h": "realtime_publisher.hpp",
    "realtime_tools/realtime_server_goal_handle.h": "realtime_server_goal_handle.hpp",
    "tl_expected/expected.hpp": "/tl/expected.hpp",
    "sensor_msgs/point_cloud2_iterator.hpp": "impl/point_cloud2_iterator",
}
"""Humble's header names by the header with their content; without a folder they are in its package."""


def write_forwarded(folder: Path) -> None:
    """Write `folder/package/name.hpp` for each of them: a file that includes the header with the content."""
    for target, names in FORWARDED.items():
        package = target.partition("/")[0]
        for name in names.split():
            file = name if "." in name else f"{name}.hpp"
            path = folder / file[1:] if file.startswith("/") else folder / package / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f'#pragma once\n#include "{target}"\n', encoding="utf-8")
