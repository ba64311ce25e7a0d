"""A node that receives the events of its own parameters."""

from __future__ import annotations

from typing import Any

import rclpy
from rcl_interfaces.msg import ParameterEvent
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.qos import qos_profile_parameter_events

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run, to_the_end

EVENTS = 10  # four declared, four set, two set again
DECLARED: dict[str, Any] = {"foo": 0, "bar": "", "baz": 0.0, "foobar": False}
FIRST = [Parameter(name, value=value) for name, value in (("foo", 2), ("bar", "hello"), ("baz", 1.45), ("foobar", True))]
SECOND = [Parameter("foo", value=3), Parameter("bar", value="world")]


class EventsNode(CppNode):
    """Declares parameters, and logs each of their events."""

    def __init__(self) -> None:
        super().__init__("parameter_events")
        self.heard = 0
        self.client = AsyncParameterClient(self, "parameter_events")
        self.create_subscription(ParameterEvent, "/parameter_events", self._hear, qos_profile_parameter_events)
        for name, value in DECLARED.items():
            self.declare_parameter(name, value)

    def _hear(self, event: ParameterEvent) -> None:
        if event.node != self.get_fully_qualified_name():
            return
        kinds = (("new", event.new_parameters), ("changed", event.changed_parameters), ("deleted", event.deleted_parameters))
        lines = ["", "Parameter event:"]
        for kind, parameters in kinds:
            lines += [f" {kind} parameters:", *(f"  {parameter.name}" for parameter in parameters)]
        self.get_logger().info("\n".join(lines) + "\n")
        self.heard += 1


class AskingLater(EventsNode):
    """Requests its changes from a timer, continues with the response, and ends."""

    def __init__(self) -> None:
        super().__init__()
        self._timer = self.create_timer(0.2, self._begin)

    def _begin(self) -> None:
        self._timer.cancel()
        self.client.set_parameters(FIRST, self._go_on)

    def _go_on(self, _: Any) -> None:
        self.client.set_parameters(SECOND, self._end)

    def _end(self, _: Any) -> None:
        self._timer = self.create_timer(0.1, rclpy.shutdown)


def events(args: list[str] | None = None) -> int:
    """Change the parameters, wait for all events, and end."""
    rclpy.init(args=args)
    node = EventsNode()
    with to_the_end(node):
        for wanted in (FIRST, SECOND):
            rclpy.spin_until_future_complete(node, node.client.set_parameters(wanted))
        while node.heard < EVENTS:
            rclpy.spin_once(node)
    return 0


def events_async(args: list[str] | None = None) -> int:
    """Do the same from callbacks."""
    return run(AskingLater, args)
