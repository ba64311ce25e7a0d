"""A thread that spins a node during a test."""

from __future__ import annotations

import threading
from typing import Any

from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node


class MessagePump:
    """Calls a node's callbacks in a thread of its own, from `start` to `stop`."""

    def __init__(self, node: Node, timeout: float = 0.5, context: Any = None) -> None:
        self._node = node
        self._timeout = timeout
        self._executor = SingleThreadedExecutor(context=context or node.context)
        self._running = False
        self._thread = threading.Thread(target=self._pump, name="message_pump_thread")

    def start(self) -> None:
        """Start the thread; call this only once."""
        self._running = True
        self._thread.start()

    def stop(self) -> None:
        """Stop the thread, and wait until the last callback has returned.

        Raises:
            Exception: when it has not returned after five seconds.
        """
        self._running = False
        self._executor.wake()
        self._thread.join(timeout=5.0)
        if self._thread.is_alive():
            raise Exception("Timed out waiting for message pump to stop")

    def _pump(self) -> None:
        self._executor.add_node(self._node)
        while self._running:
            self._executor.spin_once(timeout_sec=self._timeout)
        self._executor.remove_node(self._node)
