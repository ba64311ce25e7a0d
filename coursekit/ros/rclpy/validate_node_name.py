"""Validate a node name. In ROS 2: rclpy.validate_node_name."""

from __future__ import annotations

from coursekit.rcl import names
from rclpy.exceptions import InvalidNodeNameException


def validate_node_name(node_name: str) -> bool:
    """Return True, or raise InvalidNodeNameException.

    >>> validate_node_name("talker")
    True
    """
    reason = names.validate_node_name(node_name)
    if reason is None:
        return True
    raise InvalidNodeNameException(node_name, *reason)
