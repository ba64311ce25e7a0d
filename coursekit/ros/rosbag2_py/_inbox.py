"""Work that comes to a node from outside of its executor: keys, Ctrl-C, other threads."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any


class Inbox:
    """Does what it is given one after the other, where the node's callbacks run."""

    def __init__(self, node: Any) -> None:
        self._acts: deque[Callable[[], Any]] = deque()
        self._guard = node.create_guard_condition(self._work)

    def put(self, act: Callable[[], Any]) -> None:
        """Have `act()` done; safe from any thread."""
        self._acts.append(act)
        self._guard.trigger()

    def _work(self) -> None:
        while self._acts:
            self._acts.popleft()()
