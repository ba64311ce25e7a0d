"""Checks of an object's class."""

from __future__ import annotations

from typing import Any


def isclassinstance(obj: Any) -> bool:
    """Return whether `obj` is an instance of a class, which is true of everything in Python."""
    return hasattr(obj, "__class__")


def is_a(obj: Any, entity_type: type) -> bool:
    """Return whether `obj` is an instance of `entity_type`."""
    return isinstance(obj, entity_type)


def is_a_subclass(obj: Any, entity_type: type) -> bool:
    """Return whether `obj` is an instance, or a subclass, of `entity_type`.

    >>> is_a_subclass(1, int), is_a_subclass(bool, int), is_a_subclass(1, str)
    (True, True, False)
    """
    return isinstance(obj, entity_type) or (isinstance(obj, type) and issubclass(obj, entity_type))
