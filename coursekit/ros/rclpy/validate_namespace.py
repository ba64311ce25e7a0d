"""Validate a namespace. In ROS 2: rclpy.validate_namespace."""

from __future__ import annotations

from coursekit.rcl import names
from rclpy.exceptions import InvalidNamespaceException


def validate_namespace(namespace: str) -> bool:
    """Return True, or raise InvalidNamespaceException.

    >>> validate_namespace("/robot")
    True
    """
    reason = names.validate_namespace(namespace)
    if reason is None:
        return True
    raise InvalidNamespaceException(namespace, *reason)
