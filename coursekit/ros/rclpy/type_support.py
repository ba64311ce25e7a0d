"""Checks that a class is an interface of the expected kind."""

from __future__ import annotations

from typing import Any

from rclpy.exceptions import NoTypeSupportImportedException


def check_for_type_support(msg_or_srv_type: Any) -> None:
    """Raise unless `msg_or_srv_type` was generated from a .msg, .srv or .action file."""
    try:
        support = msg_or_srv_type.__class__._TYPE_SUPPORT
    except AttributeError as error:
        error.args = (
            error.args[0]
            + " This might be a ROS 1 message type but it should be a ROS 2 message type."
            + " Make sure to source your ROS 2 workspace after your ROS 1 workspace.",
        )
        raise
    if support is None:
        msg_or_srv_type.__class__.__import_type_support__()
    if msg_or_srv_type.__class__._TYPE_SUPPORT is None:
        raise NoTypeSupportImportedException()


def check_is_valid_msg_type(msg_type: type[Any]) -> None:
    """Raise unless `msg_type` is a message class."""
    check_for_type_support(msg_type)
    if not hasattr(msg_type, "SLOT_TYPES"):
        raise RuntimeError(
            f"The message type provided is not valid ({msg_type}), this might be a service or action"
        )


def check_is_valid_srv_type(srv_type: type[Any]) -> None:
    """Raise unless `srv_type` is a service class."""
    check_for_type_support(srv_type)
    if not (hasattr(srv_type, "Request") and hasattr(srv_type, "Response")):
        raise RuntimeError(
            f"The service type provided is not valid ({srv_type}), this might be a message or action"
        )
