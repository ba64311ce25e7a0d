"""The functions of rclpy's C module that programs call: thin faces over what `rclpy` does in Python.

In ROS 2: rclpy._rclpy_pybind11. `node` is a node's handle, as in C++.
"""

from __future__ import annotations

from typing import Any

from coursekit.rcl import names
from rclpy._node_graph import NamesAndTypes, NodeGraph
from rclpy.expand_topic_name import expand_topic_name
from rclpy.logging import get_logging_directory
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.utilities import get_rmw_implementation_identifier, remove_ros_args

rclpy_expand_topic_name = expand_topic_name
rclpy_get_rmw_implementation_identifier = get_rmw_implementation_identifier
rclpy_get_validation_error_for_full_topic_name = names.validate_full_topic_name
rclpy_get_validation_error_for_namespace = names.validate_namespace
rclpy_get_validation_error_for_node_name = names.validate_node_name
rclpy_get_validation_error_for_topic_name = names.validate_topic_name
rclpy_remove_ros_args = remove_ros_args


class _Seen(NodeGraph):
    """The graph as one node sees it."""

    def __init__(self, node: Any) -> None:
        self.handle, self._rclpy_graph_node = node, node.core


def rclpy_serialize(message: Any, message_type: Any) -> bytes:
    """Return the message as CDR bytes."""
    return serialize_message(message)


def rclpy_deserialize(buffer: bytes, message_type: Any) -> Any:
    """Return the message of the given class from its CDR bytes; RMWError if they contain none."""
    return deserialize_message(buffer, message_type)


def rclpy_logging_get_logging_directory() -> str:
    """The folder of log files."""
    return str(get_logging_directory())


def rclpy_remap_topic_name(node: Any, name: str) -> str:
    """The name that the node's rules give to a full name; without a rule, and for any other name, the name itself."""
    remapped: str = node.resolve(name, "topic") if names.validate_full_topic_name(name) is None else name
    return remapped


def rclpy_resolve_name(node: Any, name: str, only_expand: bool, is_service: bool) -> str:
    """The full name of a node's topic or service, remapped unless `only_expand`; RCLError for an invalid name."""
    resolved: str = node.resolve(name, "service" if is_service else "topic", only_expand)
    return resolved


def rclpy_get_topic_names_and_types(node: Any, no_demangle: bool) -> NamesAndTypes:
    """All topics."""
    return _Seen(node).get_topic_names_and_types(no_demangle)


def rclpy_get_service_names_and_types(node: Any) -> NamesAndTypes:
    """All services."""
    return _Seen(node).get_service_names_and_types()


def rclpy_get_publisher_names_and_types_by_node(node: Any, no_demangle: bool, name: str, namespace: str) -> NamesAndTypes:
    """Topics that a node publishes; NodeNameNonExistentError if there is no such node, here and below."""
    return _Seen(node).get_publisher_names_and_types_by_node(name, namespace, no_demangle)


def rclpy_get_subscriber_names_and_types_by_node(node: Any, no_demangle: bool, name: str, namespace: str) -> NamesAndTypes:
    """Topics that a node subscribes to."""
    return _Seen(node).get_subscriber_names_and_types_by_node(name, namespace, no_demangle)


def rclpy_get_service_names_and_types_by_node(node: Any, name: str, namespace: str) -> NamesAndTypes:
    """Services that a node serves."""
    return _Seen(node).get_service_names_and_types_by_node(name, namespace)


def rclpy_get_client_names_and_types_by_node(node: Any, name: str, namespace: str) -> NamesAndTypes:
    """Services that a node calls."""
    return _Seen(node).get_client_names_and_types_by_node(name, namespace)
