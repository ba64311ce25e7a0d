"""A republisher of messages on another topic."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.node import Node


class DataRepublisher:
    """Applies `transform_fn` to each message of a topic and publishes the result on another topic, unless it is None."""

    def __init__(
        self,
        node: Node,
        listen_topic: str,
        publish_topic: str,
        msg_type: Any,
        transform_fn: Callable[[Any], Any],
    ) -> None:
        self._node = node
        self._transform = transform_fn
        self._received = 0
        self._republished: list[Any] = []
        self._publisher = node.create_publisher(msg_type, publish_topic, 10)
        self._subscription = node.create_subscription(msg_type, listen_topic, self._pass_on, 10)

    def shutdown(self) -> None:
        """Stop republishing."""
        self._node.destroy_subscription(self._subscription)
        self._node.destroy_publisher(self._publisher)

    def get_num_received(self) -> int:
        """Return the number of received messages."""
        return self._received

    def get_num_republished(self) -> int:
        """Return the number of republished messages."""
        return len(self._republished)

    def get_republished(self) -> list[Any]:
        """Return the republished messages as they were received."""
        return self._republished

    def _pass_on(self, message: Any) -> None:
        self._received += 1
        changed = self._transform(message)
        if changed:
            self._republished.append(message)
            self._publisher.publish(changed)
