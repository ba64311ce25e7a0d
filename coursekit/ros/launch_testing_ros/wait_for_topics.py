"""Waits until something is published."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Any

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node


class WaitForTopics:
    """Waits until a message has come on every topic, at most `timeout` seconds.

    `with WaitForTopics([("/chatter", String)], timeout=5.0) as waiting:` raises when one is missing then;
    `wait()` returns whether all have come, after which `shutdown()` is to be called.
    """

    def __init__(self, topic_tuples: Sequence[tuple[str, Any]], timeout: float = 5.0) -> None:
        self.topic_tuples = topic_tuples
        self.timeout = timeout
        self._context = rclpy.Context()
        rclpy.init(context=self._context)
        self._node = _Listener(self._context)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self._running = True
        self._thread = threading.Thread(target=self._spin)
        self._thread.start()

    def _spin(self) -> None:
        while self._running:
            self._executor.spin_once(1.0)

    def wait(self) -> bool:
        """Listen, and return whether all topics have had a message."""
        self._node.listen(self.topic_tuples)
        return self._node.all_received.wait(self.timeout)

    def shutdown(self) -> None:
        """Listen no more."""
        self._running = False
        self._executor.wake()
        self._thread.join()
        self._node.destroy_node()
        rclpy.shutdown(context=self._context)

    def topics_received(self) -> set[str]:
        """Return the topics that have had a message."""
        return self._node.received

    def topics_not_received(self) -> set[str]:
        """Return the topics that have had none."""
        return self._node.expected - self._node.received

    def __enter__(self) -> WaitForTopics:
        if not self.wait():
            self.shutdown()
            raise RuntimeError("Did not receive messages on these topics: ", self.topics_not_received())
        return self

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        self.shutdown()
        if kind is not None:
            raise Exception("Exception occured, value: ", error)


class _Listener(Node):
    """The node that subscribes to the topics."""

    def __init__(self, context: Any) -> None:
        super().__init__("test_node", context=context)
        self.all_received = threading.Event()
        self.expected: set[str] = set()
        self.received: set[str] = set()

    def listen(self, topics: Sequence[tuple[str, Any]]) -> None:
        """Subscribe to the topics."""
        self.expected = {name for name, _ in topics}
        self.received = set()
        for name, kind in topics:
            self.create_subscription(kind, name, self._callback_for(name), 10)

    def _callback_for(self, topic: str) -> Callable[[Any], None]:
        def receive(_: Any) -> None:
            if topic not in self.received:
                self.get_logger().debug(f"Message received for {topic}")
                self.received.add(topic)
            if self.received == self.expected:
                self.all_received.set()

        return receive
