"""Conversion of an interface's name to its class."""

from __future__ import annotations

from typing import Any

from rosidl_parser.definition import NamespacedType

from rosidl_runtime_py.import_message import import_message_from_namespaced_type


def get_namespaced_type(identifier: str) -> NamespacedType:
    """Return the type named 'package/kind/Name'; raises ValueError for any other form."""
    parts = identifier.split("/")
    if len(parts) != 3 or not all(parts):
        raise ValueError(f"Expected an interface in the form 'package/kind/Name', got '{identifier}'")
    return NamespacedType(parts[:2], parts[2])


def _of_kind(identifier: str, kind: str) -> NamespacedType:
    parts = identifier.split("/")
    return get_namespaced_type("/".join([parts[0], kind, parts[1]]) if len(parts) == 2 else identifier)


def get_message_namespaced_type(identifier: str) -> NamespacedType:
    """Return the type of 'package/msg/Name' or 'package/Name'."""
    return _of_kind(identifier, "msg")


def get_service_namespaced_type(identifier: str) -> NamespacedType:
    """Return the type of 'package/srv/Name' or 'package/Name'."""
    return _of_kind(identifier, "srv")


def get_action_namespaced_type(identifier: str) -> NamespacedType:
    """Return the type of 'package/action/Name' or 'package/Name'."""
    return _of_kind(identifier, "action")


def get_interface(identifier: str) -> Any:
    """Return the class of a message, a service or an action by its full name."""
    return import_message_from_namespaced_type(get_namespaced_type(identifier))


def is_message(interface: Any) -> bool:
    """Return whether a class is a message."""
    return hasattr(interface, "get_fields_and_field_types")


def is_service(interface: Any) -> bool:
    """Return whether a class is a service."""
    return hasattr(interface, "Request") and hasattr(interface, "Response")


def is_action(interface: Any) -> bool:
    """Return whether a class is an action."""
    return all(hasattr(interface, part) for part in ("Goal", "Result", "Feedback"))


def get_message(identifier: str) -> Any:
    """Return a message class; raises ValueError if the name is not that of a message.

    >>> get_message('std_msgs/msg/String')
    <class 'std_msgs.msg._string.String'>
    """
    message_class = import_message_from_namespaced_type(get_message_namespaced_type(identifier))
    if not is_message(message_class):
        raise ValueError(f"Expected the full name of a message, got '{identifier}'")
    return message_class


def get_service(identifier: str) -> Any:
    """Return a service class; raises ValueError if the name is not that of a service."""
    service_class = import_message_from_namespaced_type(get_service_namespaced_type(identifier))
    if not is_service(service_class):
        raise ValueError(f"Expected the full name of a service, got '{identifier}'")
    return service_class


def get_action(identifier: str) -> Any:
    """Return an action class; raises ValueError if the name is not that of an action."""
    action_class = import_message_from_namespaced_type(get_action_namespaced_type(identifier))
    if not is_action(action_class):
        raise ValueError(f"Expected the full name of an action, got '{identifier}'")
    return action_class
