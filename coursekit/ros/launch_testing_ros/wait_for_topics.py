"""Waiting for messages on topics."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

if TYPE_CHECKING:
    from rclpy.context import Context


class WaitForTopics:
    """Waits until a message has arrived on every topic, at most `timeout` seconds.

    `with WaitForTopics([("/chatter", String)], timeout=5.0) as waiting:` raises if a message is missing then.
    `wait()` returns whether all have arrived; call `shutdown()` afterwards. Of each topic the last
    `messages_received_buffer_length` messages are kept; None: all.
    """

    def __init__(
        self,
        topic_tuples: Sequence[tuple[str, Any]],
        timeout: float = 5.0,
        messages_received_buffer_length: int | None = None,
    ) -> None:
        self.topic_tuples = topic_tuples
        self.timeout = timeout
        self._context = rclpy.Context()
        rclpy.init(context=self._context)
        self._node = _Listener(self._context, messages_received_buffer_length)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self._running = True
        self._thread = threading.Thread(target=self._spin)
        self._thread.start()

    def _spin(self) -> None:
        while self._running:
            self._executor.spin_once(1.0)

    def wait(self) -> bool:
        """Subscribe and wait; return whether a message has arrived on all topics."""
        self._node.listen(self.topic_tuples)
        return self._node.all_received.wait(self.timeout)

    def shutdown(self) -> None:
        """Stop spinning and destroy the node."""
        self._running = False
        self._executor.wake()
        self._thread.join()
        self._node.destroy_node()
        rclpy.shutdown(context=self._context)

    def topics_received(self) -> set[str]:
        """Return the topics on which a message has arrived."""
        return self._node.received

    def topics_not_received(self) -> set[str]:
        """Return the topics on which no message has arrived."""
        return self._node.expected - self._node.received

    def received_messages(self, topic_name: str) -> deque[Any]:
        """Return the messages that have arrived on a topic, oldest first; KeyError if it is not one of the topics."""
        if topic_name not in self._node.messages:
            known = ", ".join(sorted(self._node.messages)) or "none before wait()"
            raise KeyError(f"'{topic_name}' is not one of the topics that are waited for ({known})")
        return self._node.messages[topic_name]

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

    def __init__(self, context: Context, most: int | None) -> None:
        super().__init__("test_node", context=context)
        self.most = most
        self.messages: dict[str, deque[Any]] = {}
        self.all_received = threading.Event()
        self.expected: set[str] = set()
        self.received: set[str] = set()

    def listen(self, topics: Sequence[tuple[str, Any]]) -> None:
        """Subscribe to the topics."""
        self.expected = {name for name, _ in topics}
        self.received = set()
        self.messages = {name: deque(maxlen=self.most) for name, _ in topics}
        for name, kind in topics:
            self.create_subscription(kind, name, self._callback_for(name), 10)

    def _callback_for(self, topic: str) -> Callable[[Any], None]:
        def receive(message: Any) -> None:
            self.messages[topic].append(message)
            if topic not in self.received:
                self.get_logger().debug(f"Message received for {topic}")
                self.received.add(topic)
            if self.received == self.expected:
                self.all_received.set()

        return receive
