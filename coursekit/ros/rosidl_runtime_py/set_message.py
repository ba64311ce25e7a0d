"""Setting the fields of a message from a dictionary, as `ros2 topic pub` does."""

from __future__ import annotations

import array
from collections.abc import Callable
from functools import partial
from typing import Any

from rosidl_parser.definition import AbstractNestedType, NamespacedType

from rosidl_runtime_py.convert import get_message_slot_types
from rosidl_runtime_py.import_message import import_message_from_namespaced_type

Setter = Callable[[Any], None]


def set_message_fields(
    msg: Any, values: dict[str, Any], expand_header_auto: bool = False, expand_time_now: bool = False
) -> list[Setter]:
    """Set the fields of a message from a dictionary; return functions that set times to "now".

    With `expand_header_auto`, 'auto' for a header defers its stamp to these functions;
    with `expand_time_now`, 'now' defers a time.
    Raises AttributeError for an unknown field and TypeError or ValueError for a value that does not fit.

    >>> from geometry_msgs.msg import Vector3
    >>> vector = Vector3()
    >>> set_message_fields(vector, {'x': 1})
    []
    >>> vector.x
    1.0
    """
    setters: list[Setter] = []
    _Filler(expand_header_auto, expand_time_now, setters).fill(msg, values)
    return setters


class _Filler:
    """Carries the two switches and the setters through nested messages."""

    def __init__(self, header_auto: bool, time_now: bool, setters: list[Setter]) -> None:
        self.header_auto, self.time_now, self.setters = header_auto, time_now, setters

    def fill(self, msg: Any, values: Any) -> None:
        if not isinstance(values, dict):
            kind = type(values).__name__
            raise TypeError(f"Value '{values}' is expected to be a dictionary but is a {kind}")
        for name, value in values.items():
            if not self._later(msg, name, value):
                setattr(msg, name, self._converted(msg, name, value))

    def _later(self, msg: Any, name: str, value: Any) -> bool:
        current = getattr(msg, name)
        kind = getattr(type(current), "_TYPE_NAME", "")
        if self.header_auto and kind == "std_msgs/msg/Header" and value == "auto":
            self.setters.append(partial(setattr, current, "stamp"))
            return True
        if self.time_now and kind == "builtin_interfaces/msg/Time" and value == "now":
            self.setters.append(partial(setattr, msg, name))
            return True
        return False

    def _converted(self, msg: Any, name: str, value: Any) -> Any:
        current = getattr(msg, name)
        kind = get_message_slot_types(msg)[name]
        if isinstance(current, array.array):
            return array.array(current.typecode, value)
        if type(current).__name__ == "ndarray":
            import numpy  # only for messages that hold numpy arrays already

            return numpy.array(value, dtype=current.dtype)
        if isinstance(kind, AbstractNestedType) and isinstance(kind.value_type, NamespacedType):
            return self._messages(kind.value_type, value)
        if type(value) is type(current):
            return value
        if isinstance(kind, NamespacedType):
            return self._message(type(current), value)
        return type(current)(value)

    def _messages(self, kind: NamespacedType, values: Any) -> list[Any]:
        cls = import_message_from_namespaced_type(kind)
        return [value if isinstance(value, cls) else self._message(cls, value) for value in list(values)]

    def _message(self, cls: Any, value: Any) -> Any:
        message = cls()
        self.fill(message, value)
        return message
