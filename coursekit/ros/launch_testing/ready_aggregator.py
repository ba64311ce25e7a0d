"""A callback for the readiness of several parties."""

from __future__ import annotations

import threading
from collections.abc import Callable


class ReadyAggregator:
    """Calls `ready_fn` when its own `ready_fn` has been called `num_to_aggregate` times.

    >>> all_ready = ReadyAggregator(lambda: print("ready"), 2)
    >>> all_ready.ready_fn()
    >>> all_ready.ready_fn()
    ready
    """

    def __init__(self, ready_fn: Callable[[], object], num_to_aggregate: int) -> None:
        self._parent = ready_fn
        self._missing = num_to_aggregate
        self._lock = threading.Lock()

    def ready_fn(self) -> None:
        """Record that one party is ready; thread-safe."""
        with self._lock:
            self._missing -= 1
            complete = self._missing == 0
        if complete:
            self._parent()
