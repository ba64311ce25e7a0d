"""The common parts of all controllers."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Set
from typing import TYPE_CHECKING, Any

from builtin_interfaces.msg import Time
from rclpy.action import ActionServer
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.timer import Timer

if TYPE_CHECKING:
    from rclpy.executors import Executor


class ControlError(Exception):
    """A controller that cannot do what is requested; the message goes to its log."""


class Interfaces:
    """The commands that a controller has claimed, and all states."""

    def __init__(
        self,
        commands: Mapping[str, dict[str, float]],
        states: Mapping[str, dict[str, float]],
        closed: Callable[[], Set[str]] = frozenset,
    ) -> None:
        """`closed` returns the names of those that are not available now."""
        self._commands, self._states, self._closed = commands, states, closed

    def state(self, name: str) -> float:
        """Return a state by its full name; nan if there is none."""
        table = self._states.get(name)
        return math.nan if table is None else table[name]

    def command(self, name: str, value: float) -> None:
        """Write a command."""
        self._commands[name][name] = value

    def commanded(self, name: str) -> float:
        """Return the current command."""
        return self._commands[name][name]

    def states(self) -> list[str]:
        """The full names of all states."""
        return list(self._states)

    def available_states(self) -> list[str]:
        """The full names of the states of hardware that is at least configured."""
        closed = self._closed()
        return [name for name in self._states if name not in closed]

    def commands(self) -> list[str]:
        """The full names of all commands."""
        return list(self._commands)


class Controller:
    """A controller: its node has its name; the manager calls `configure`, `activate`, `update` and `deactivate`."""

    chainable = False
    """Whether other controllers may command it: `configure` then fills `references`."""
    chained = False
    """Whether one does."""

    def __init__(self, node: Node, interfaces: Interfaces, rate: float) -> None:
        self.node, self.interfaces, self.rate = node, interfaces, rate
        self.log = node.get_logger()
        self.references: dict[str, float] = {}
        """What other controllers may command, by full names; nan until they do."""
        self.now_ns = 0
        """The time of the current or last step [ns]."""
        self._born_with = [id(handle) for handle in self._opened()]

    def parameter(self, name: str, usual: Any) -> Any:
        """Return a parameter, declared on first use; ControlError for a wrong type."""
        try:
            if not self.node.has_parameter(name):
                if usual == []:
                    from rclpy.parameter import Parameter

                    self.node.declare_parameter(name, Parameter.Type.STRING_ARRAY)
                else:
                    self.node.declare_parameter(name, usual)
            value = self.node.get_parameter_or(name).value
        except Exception as error:  # a wrong type: rclpy has four exceptions for it
            raise ControlError(f"parameter '{name}': {error}") from None
        return usual if value is None else list(value) if isinstance(usual, list) else value

    def length(self, name: str) -> float:
        """Return a parameter in metres; ControlError unless it is more than 0."""
        metres = float(self.parameter(name, 0.0))
        if metres <= 0:
            raise ControlError(f"{name} must be more than 0: give metres")
        return metres

    def command_names(self) -> list[str]:
        """Return the full names of the commands that it claims."""
        return []

    def state_names(self) -> list[str]:
        """Return the full names of the states that it needs."""
        return []

    def configure(self) -> None:
        """Read parameters, create topics. Raises ControlError."""

    def set_chained(self, chained: bool) -> bool:
        """Take the references instead of what the topic says, or no longer; whether it does."""
        self.chained = chained
        return True

    def activate(self) -> None:
        """Start. Raises ControlError."""

    def deactivate(self) -> None:
        """Stop."""

    def update(self, now_ns: int, dt: float) -> None:
        """Do one step."""

    def cleanup(self) -> None:
        """Close what `configure` created, so that the controller can be configured again."""
        for handle in [each for each in self._opened() if id(each) not in self._born_with]:
            if isinstance(handle, Publisher):
                self.node.destroy_publisher(handle)
            elif isinstance(handle, Subscription):
                self.node.destroy_subscription(handle)
            elif isinstance(handle, Service):
                self.node.destroy_service(handle)
            elif isinstance(handle, Timer):
                self.node.destroy_timer(handle)
            elif isinstance(handle, ActionServer):
                handle.destroy()

    def _opened(self) -> list[Any]:
        node = self.node
        return [*node.publishers, *node.subscriptions, *node.services, *node.timers, *node.waitables]

    def leave(self, executor: Executor) -> None:
        """Handle the unloading."""
        executor.remove_node(self.node)
        self.close()

    def close(self) -> None:
        """Destroy the node."""
        self.node.destroy_node()


def stamp(now_ns: int) -> Time:
    """Convert nanoseconds to a message.

    >>> stamp(1_500_000_000)
    builtin_interfaces.msg.Time(sec=1, nanosec=500000000)
    """
    return Time(sec=now_ns // 1_000_000_000, nanosec=now_ns % 1_000_000_000)


Maker = Callable[[Node, Interfaces, float], Controller]
__all__ = ["ControlError", "Controller", "Interfaces", "Maker", "stamp"]
