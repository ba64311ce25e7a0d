"""Checks that a class is an interface of the expected kind."""

from __future__ import annotations

from typing import Any

from rclpy.exceptions import NoTypeSupportImportedException


def check_for_type_support(interface: Any) -> None:
    """Raise unless `interface` was generated from a .msg, .srv or .action file."""
    try:
        support = interface.__class__._TYPE_SUPPORT
    except AttributeError as error:
        error.args = (
            error.args[0]
            + " This might be a ROS 1 message type but it should be a ROS 2 message type."
            + " Make sure to source your ROS 2 workspace after your ROS 1 workspace.",
        )
        raise
    if support is None:
        interface.__class__.__import_type_support__()
    if interface.__class__._TYPE_SUPPORT is None:
        raise NoTypeSupportImportedException()


def check_is_valid_msg_type(interface: Any) -> None:
    """Raise unless `interface` is a message class."""
    check_for_type_support(interface)
    if not hasattr(interface, "SLOT_TYPES"):
        raise RuntimeError(
            f"The message type provided is not valid ({interface}), this might be a service or action"
        )


def check_is_valid_srv_type(interface: Any) -> None:
    """Raise unless `interface` is a service class."""
    check_for_type_support(interface)
    if not (hasattr(interface, "Request") and hasattr(interface, "Response")):
        raise RuntimeError(
            f"The service type provided is not valid ({interface}), this might be a message or action"
        )
