"""Serialization of messages. In ROS 2: rclpy.serialization."""

from __future__ import annotations

from typing import Any

from coursekit.interfaces import cdr
from coursekit.interfaces.errors import CdrError
from rclpy._rclpy_pybind11 import RMWError


def serialize_message(message: Any) -> bytes:
    """Return the message as CDR bytes, the wire format; AttributeError for anything but a message.

    >>> from std_msgs.msg import String
    >>> serialize_message(String(data="hi")).hex(" ")
    '00 01 00 00 03 00 00 00 68 69 00'
    """
    _check_type(type(message))
    return cdr.serialize(message)


def deserialize_message(serialized_message: bytes, message_type: Any) -> Any:
    """Return the message of the given class from its CDR bytes; RMWError if they contain none.

    >>> from std_msgs.msg import String
    >>> deserialize_message(serialize_message(String(data="hi")), String)
    std_msgs.msg.String(data='hi')
    """
    _check_type(message_type)
    if not isinstance(serialized_message, bytes):
        kind = type(serialized_message).__name__
        raise TypeError(f"deserialize_message takes bytes, not {kind}; write bytes(...) around it")
    try:
        return cdr.deserialize(serialized_message, message_type)
    except CdrError as error:
        raise RMWError(f"failed to deserialize ROS message: {error}") from error


def _check_type(message_type: Any) -> None:
    if hasattr(message_type, "_TYPE_SUPPORT"):
        return
    raise AttributeError(
        f"type object '{getattr(message_type, '__name__', message_type)}' has no attribute '_TYPE_SUPPORT' "
        "This might be a ROS 1 message type but it should be a ROS 2 message type. "
        "Make sure to source your ROS 2 workspace after your ROS 1 workspace."
    )
