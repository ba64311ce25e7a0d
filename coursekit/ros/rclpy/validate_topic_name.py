"""Validate a topic or service name. In ROS 2: rclpy.validate_topic_name."""

from __future__ import annotations

from coursekit.rcl import names
from rclpy.exceptions import InvalidServiceNameException, InvalidTopicNameException

TOPIC_SEPARATOR_STRING = "/"


def validate_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True, or raise InvalidTopicNameException (InvalidServiceNameException when is_service).

    >>> validate_topic_name("/chatter")
    True
    """
    reason = names.validate_topic_name(name)
    if reason is None:
        return True
    if is_service:
        raise InvalidServiceNameException(name, *reason)
    raise InvalidTopicNameException(name, *reason)
