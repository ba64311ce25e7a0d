"""Validate a parameter name. In ROS 2: rclpy.validate_parameter_name."""

from __future__ import annotations

from rclpy.exceptions import InvalidParameterException


def validate_parameter_name(name: str) -> bool:
    """Return True, or raise InvalidParameterException: any non-empty text is valid."""
    if name:
        return True
    raise InvalidParameterException(name)
