"""Declaring parameters of nav2's servers, whose plugins bring parameters of their own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

_ANY = ParameterDescriptor(dynamic_typing=True)


def declare(node: Node, defaults: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Declare what is not declared yet, below `prefix.`; the values by their names. Whole numbers may stand for real ones.

    The kind of a value must be that of its default, else ValueError.
    """
    found = {}
    for name, default in defaults.items():
        full = f"{prefix}.{name}" if prefix else name
        if not node.has_parameter(full):
            node.declare_parameter(full, default, _ANY)
        found[name] = _checked(f"{node.get_name()}: {full}", node.get_parameter(full).value, default)
    return found


def _checked(name: str, value: Any, default: Any) -> Any:
    if isinstance(default, float) and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if isinstance(default, list) and not isinstance(value, (str, bytes)) and hasattr(value, "__iter__"):
        return list(value)
    if type(value) is not type(default):
        raise ValueError(f"{name} is {value!r}: give a value like {default!r}")
    return value
