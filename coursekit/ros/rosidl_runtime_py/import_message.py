"""Conversion of a field's type to its class."""

from __future__ import annotations

import warnings
from importlib import import_module
from typing import Any, cast

from rosidl_parser.definition import AbstractNestedType, NamespacedType


def import_message_from_namespaced_type(message_type: NamespacedType | AbstractNestedType) -> Any:
    """Return the class of a message type. An array or sequence type, which was once allowed, gives a warning.

    Raises ModuleNotFoundError or AttributeError if there is no class.
    """
    if isinstance(message_type, AbstractNestedType):
        warnings.warn("pass the type of the items, not that of the array or sequence", DeprecationWarning, stacklevel=2)
        message_type = cast(NamespacedType, message_type.value_type)
    return getattr(import_module(".".join(message_type.namespaces)), message_type.name)
