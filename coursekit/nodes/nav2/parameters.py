"""Declare parameters of nav2's servers, whose plugins have parameters of their own."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

_ANY = ParameterDescriptor(dynamic_typing=True)


def declare(node: Node, defaults: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Declare missing parameters under `prefix.` and return all values by name. Integers are accepted for floats.

    A value's type must match its default, otherwise ValueError is raised.
    """
    values, asked = {}, getattr(node, "asked_for", {})
    for name, default in defaults.items():
        full = f"{prefix}.{name}" if prefix else name
        if not node.has_parameter(full):
            node.declare_parameter(full, default, _ANY)
        values[name] = _checked(f"{node.get_name()}: {full}", asked.get(full, node.get_parameter(full).value), default)
    return values


class Obedience:
    """Applies `ros2 param set` to a running node: `read()` reads everything from `declare` again.

    A change for which `read()` raises ValueError is rejected with that message.
    """

    def __init__(self, node: Any, read: Callable[[], None]) -> None:
        self._node, self._read = node, read
        node.asked_for = {}
        node.add_on_set_parameters_callback(self._asked)

    def _asked(self, parameters: list[Parameter]) -> SetParametersResult:
        self._node.asked_for = {parameter.name: parameter.value for parameter in parameters}
        try:
            self._read()
        except ValueError as fault:
            self._node.get_logger().error(str(fault))
            return SetParametersResult(successful=False, reason=str(fault))
        finally:
            self._node.asked_for = {}
        return SetParametersResult(successful=True)

    def end(self) -> None:
        """Stop applying parameter changes."""
        self._node.remove_on_set_parameters_callback(self._asked)


def _checked(name: str, value: Any, default: Any) -> Any:
    if isinstance(default, float) and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if isinstance(default, list) and not isinstance(value, (str, bytes)) and hasattr(value, "__iter__"):
        return list(value)
    if type(value) is not type(default):
        raise ValueError(f"{name} is {value!r}: give a value like {default!r}")
    return value


class NoPlugin(ValueError):
    """A plugin that cannot be made; the message is nav2's."""


def no_such_plugin(what: str, kind: str, base: str, known: Iterable[str]) -> str:
    """Return nav2's error message for a missing plugin.

    >>> no_such_plugin("global planner", "Astar", "nav2_core::GlobalPlanner", ["a/B", "c/D"])[-68:]
    'nav2_core::GlobalPlanner does not exist. Declared types are  a/B c/D'
    """
    return (
        f"Failed to create {what}. Exception: According to the loaded plugin descriptions the class {kind} with base class "
        f"type {base} does not exist. Declared types are  {' '.join(known)}"
    )
