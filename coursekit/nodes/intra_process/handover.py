"""Hands messages over between nodes in one process, as rclcpp does with a std::unique_ptr; rclpy makes copies."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

from rclpy.publisher import Publisher

KEPT = 10
"""The maximum number of messages waiting for their subscription."""


class Handover:
    """Messages between nodes in one process: the first subscriber to take one gets the publisher's own object.

    Later subscribers, and messages from other processes, use the copy that came through the graph.
    `key` identifies a message.
    """

    def __init__(self, key: Callable[[Any], Any]) -> None:
        self._key = key
        self._given: dict[str, deque[tuple[Any, Any]]] = {}

    def publish(self, publisher: Publisher, msg: Any) -> None:
        """Publish a message and hand over its ownership."""
        self._given.setdefault(publisher.topic_name, deque(maxlen=KEPT)).append((self._key(msg), msg))
        publisher.publish(msg)

    def take(self, topic: str, copy: Any) -> Any:
        """Return the original message to the first caller that asks for it, otherwise the copy."""
        given = self._given.get(topic, deque())
        key = self._key(copy)
        for place, (known, msg) in enumerate(given):
            if known == key:
                del given[place]
                return msg
        return copy
