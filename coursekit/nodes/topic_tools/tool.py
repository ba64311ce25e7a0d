"""The common parts of the tools: subscription to a topic of any type as bytes, and publication of these bytes."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.utilities import remove_ros_args
from rosidl_runtime_py.utilities import get_message

from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import spin_to_the_end

DISCOVERY_SECONDS = 0.1
"""The period of the search for a topic that does not exist yet."""


class Tool(Node):
    """Subscribes to `input_topic` once it has publishers, with their type and QoS; `take` gets the bytes.

    With `lazy` it is subscribed only while its output has subscribers.
    """

    def __init__(self, name: str, given: dict[str, Any]) -> None:
        super().__init__(name)
        self._words = given
        self.input_topic = str(self.wanted("input_topic", ""))
        if not self.input_topic:
            raise ValueError(f"{name} needs a topic: ros2 run topic_tools {name} TOPIC, or -p input_topic:=TOPIC")
        self.output_topic = str(self.wanted("output_topic", f"{self.input_topic}_{name}"))
        self.lazy = bool(self.wanted("lazy", False))
        self._ear: Any = None
        self._mouth: Any = None
        self.create_timer(DISCOVERY_SECONDS, self._look)

    def wanted(self, name: str, default: Any) -> Any:
        """A parameter; a word on the command line replaces its default."""
        return declare(self, {name: self._words.get(name, default)})[name]

    def take(self, data: bytes) -> None:
        """Process a message; subclasses override it."""
        self.say(data)

    def say(self, data: bytes) -> None:
        """Publish a message."""
        self._mouth.publish(data)

    def _look(self) -> None:
        """Create or destroy the subscription as topics and subscribers come and go."""
        if self._mouth is None:
            self._open()
        elif self.lazy and self._ear is not None and not self._mouth.get_subscription_count():
            self.destroy_subscription(self._ear)
            self._ear = None
        elif self._ear is None and (not self.lazy or self._mouth.get_subscription_count()):
            self._ear = self.create_subscription(self._kind, self.input_topic, self.take, self._qos, raw=True)

    def _open(self) -> None:
        source = source_of(self, self.input_topic)
        if source is not None:
            self._kind, self._qos = source
            self._mouth = self.create_publisher(self._kind, self.output_topic, self._qos)
            self._look()


def source_of(node: Node, topic: str) -> tuple[Any, QoSProfile] | None:
    """The type of a topic, and a QoS that is compatible with all its publishers; None without a publisher."""
    about = node.get_publishers_info_by_topic(node.resolve_topic_name(topic))
    if not about:
        return None
    profiles = [info.qos_profile for info in about]
    reliable = all(profile.reliability == ReliabilityPolicy.RELIABLE for profile in profiles)
    kept = all(profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for profile in profiles)
    qos = QoSProfile(
        depth=max(*(profile.depth for profile in profiles), 10),
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if kept else DurabilityPolicy.VOLATILE,
    )
    return get_message(about[0].topic_type), qos


def run_tool(make: Callable[[list[str]], Node], args: list[str] | None) -> int:
    """Run the tool that `make` creates from the command line until Ctrl-C; return 1 for invalid arguments."""
    rclpy.init(args=args)
    try:
        node = make(remove_ros_args(args=sys.argv if args is None else args)[1:])
    except (ValueError, IndexError) as fault:
        print(str(fault), file=sys.stderr)
        rclpy.try_shutdown()
        return 1
    return spin_to_the_end(node)
