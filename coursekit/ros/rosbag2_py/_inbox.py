"""Work for a node from outside its executor: keys, Ctrl-C, other threads."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy.node import Node


class Inbox:
    """A queue of actions that run one after the other in the thread of the node's callbacks."""

    def __init__(self, node: Node) -> None:
        self._acts: deque[Callable[[], Any]] = deque()
        self._guard = node.create_guard_condition(self._work)

    def put(self, act: Callable[[], Any]) -> None:
        """Queue a call of `act()`; thread-safe."""
        self._acts.append(act)
        self._guard.trigger()

    def _work(self) -> None:
        while self._acts:
            self._acts.popleft()()
