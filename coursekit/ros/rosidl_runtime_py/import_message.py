"""From the type of a field to its class."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from rosidl_parser.definition import NamespacedType


def import_message_from_namespaced_type(message_type: NamespacedType) -> Any:
    """Return the class of a message type.

    Raises ModuleNotFoundError or AttributeError when there is none.
    """
    return getattr(import_module(".".join(message_type.namespaces)), message_type.name)
