"""A subscription that exists only while the node's output has subscribers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy

LOOK_SECONDS = 0.1


class LazySubscription:
    """Subscribes, best effort, while `out` has subscribers; logs when that changes."""

    def __init__(self, node: Node, out: Any, kind: Any, topic: str, hear: Callable[[Any], None], depth: int = 5) -> None:
        self._node, self._out = node, out
        self._ear: Any = None
        self._qos = QoSProfile(depth=max(depth, 1), reliability=ReliabilityPolicy.BEST_EFFORT)
        self._make = lambda: node.create_subscription(kind, topic, hear, self._qos)
        self.words = ("", "")
        node.create_timer(LOOK_SECONDS, self.look)

    def look(self) -> None:
        """Create or destroy the subscription, as needed."""
        wanted = self._out.get_subscription_count() > 0
        if wanted == (self._ear is not None):
            return
        if self.words[0]:
            self._node.get_logger().info(self.words[0 if wanted else 1])
        if wanted:
            self._ear = self._make()
        else:
            self._node.destroy_subscription(self._ear)
            self._ear = None
