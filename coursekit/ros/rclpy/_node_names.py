"""The part of Node that reads its arguments and resolves names."""

from __future__ import annotations

from typing import Any

from coursekit.rcl import names
from coursekit.rcl.arguments import RosArgumentsError, UnknownRosArguments, merge, parse_ros_arguments
from rclpy import _rclpy_pybind11 as _rclpy
from rclpy.expand_topic_name import expand_topic_name
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_topic_name import validate_topic_name


class NodeNames:
    """A node's remappings, and the full names of its topics and services."""

    _context: Any
    _rclpy_arguments: Any
    _rclpy_graph_node: Any
    handle: Any

    def get_name(self) -> str:
        """The name, for example 'camera'."""
        return self.handle.get_node_name()

    def get_namespace(self) -> str:
        """The namespace, for example '/robot1'."""
        return self.handle.get_namespace()

    def get_fully_qualified_name(self) -> str:
        """Namespace and name, for example '/robot1/camera'."""
        return self.handle.get_fully_qualified_name()

    def _rclpy_read_arguments(self, cli_args: list[str] | None, use_global: bool) -> Any:
        try:
            own = parse_ros_arguments(cli_args or [])
        except UnknownRosArguments as error:
            raise _rclpy.UnknownROSArgsError(str(error)) from None
        except RosArgumentsError as error:
            raise _rclpy.RCLInvalidROSArgsError(f"Failed to parse ROS arguments: {error}") from None
        return merge(own, self._context.handle.arguments) if use_global else own

    def _rclpy_remap(self, full_name: str, kind: str) -> str:
        return self._rclpy_arguments.remap(kind, full_name, self._rclpy_graph_node.name, self._rclpy_graph_node.namespace)

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """The full name of a topic, after remapping.

        >>> node.resolve_topic_name("scan"), node.resolve_topic_name("~/pose")
        ('/scan', '/robot/pose')
        """
        return self._rclpy_resolve(topic, "topic", only_expand)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """The full name of a service, after remapping."""
        return self._rclpy_resolve(service, "service", only_expand)

    def _rclpy_resolve(self, name: str, kind: str, only_expand: bool = False) -> str:
        try:
            full = names.expand(name, self.get_name(), self.get_namespace())
        except names.InvalidName as error:
            raise _rclpy.RCLError(f"failed to resolve name: {error.message}") from None
        resolved = full if only_expand else self._rclpy_remap(full, kind)
        if reason := names.validate_full_topic_name(resolved):
            raise _rclpy.RCLError(f"failed to resolve name: {reason[0]}")
        return resolved

    def _rclpy_checked(self, name: str, kind: str) -> str:
        """The full name, after the checks in ROS's order."""
        validate_topic_name(name, is_service=kind == "service")
        full = expand_topic_name(name, self.get_name(), self.get_namespace())
        validate_full_topic_name(full, is_service=kind == "service")
        return full
