"""Messages that nodes of one process hand on themselves, as rclcpp does with a std::unique_ptr; rclpy gives copies."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

from rclpy.publisher import Publisher

KEPT = 10
"""How many messages wait at most until their subscription takes them."""


class Handover:
    """Messages between nodes of one process: the first subscriber that takes one has the publisher's own.

    Who comes later has the copy that came through the graph, and so has who hears of messages from elsewhere.
    `key` tells messages apart.
    """

    def __init__(self, key: Callable[[Any], Any]) -> None:
        self._key = key
        self._given: dict[str, deque[tuple[Any, Any]]] = {}

    def publish(self, publisher: Publisher, msg: Any) -> None:
        """Publish a message that its publisher gives away."""
        self._given.setdefault(publisher.topic_name, deque(maxlen=KEPT)).append((self._key(msg), msg))
        publisher.publish(msg)

    def take(self, topic: str, copy: Any) -> Any:
        """Return the message that was given away, if this is the first to ask for it; else the copy of it."""
        given = self._given.get(topic, deque())
        key = self._key(copy)
        for place, (known, msg) in enumerate(given):
            if known == key:
                del given[place]
                return msg
        return copy
