"""The metaclass of interface classes, and the functions shared by all messages."""

from __future__ import annotations

from typing import Any


class InterfaceType(type):
    """The metaclass of message, service and action classes; no type support has to be imported."""

    _TYPE_SUPPORT: Any = "coursekit"
    _CREATE_ROS_MESSAGE: Any = "coursekit"
    _CONVERT_FROM_PY: Any = "coursekit"
    _CONVERT_TO_PY: Any = "coursekit"
    _DESTROY_ROS_MESSAGE: Any = "coursekit"

    @classmethod
    def __import_type_support__(cls) -> None:
        """Do nothing: there is no compiled type support."""


def text_of(message: Any) -> str:
    """Return the repr of a message, with arrays shown as lists.

    >>> from geometry_msgs.msg import Point
    >>> Point(x=1.0)
    geometry_msgs.msg.Point(x=1.0, y=0.0, z=0.0)
    """
    cls = type(message)
    module = cls.__module__.rpartition(".")[0]
    parts = []
    for name, blocks in zip(cls._fields_and_field_types, cls._BLOCKS, strict=True):
        value = getattr(message, name)
        parts.append(f"{name}={value.tolist()!r}" if blocks else f"{name}={value!r}")
    return f"{module}.{cls.__name__}({', '.join(parts)})"


def reject_unknown(cls: Any, kwargs: dict[str, Any]) -> None:
    """Raise AssertionError for constructor arguments that are not field names."""
    unknown = sorted(set(kwargs) - cls._fields_and_field_types.keys())
    if unknown:
        raise AssertionError(f"Invalid arguments passed to constructor: {', '.join(unknown)}")
