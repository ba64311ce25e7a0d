"""The wait set that waitables fill and query."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from coursekit.core.ready_queue import Source
from coursekit.processes.session import current


class WaitSet:
    """Replaces rcl's wait set: a waitable adds its handles and asks which of them are ready."""

    def __init__(self, *_sizes: Any) -> None:
        self.handles: dict[str, list[Any]] = {}

    def clear_entities(self) -> None:
        """Remove all entities."""
        self.handles.clear()

    def _add(self, kind: str, handle: Any) -> int:
        handles = self.handles.setdefault(kind, [])
        handles.append(handle)
        return len(handles) - 1

    def add_subscription(self, handle: Any) -> int:
        """Wait for a message."""
        return self._add("subscription", handle)

    def add_guard_condition(self, handle: Any) -> int:
        """Wait for a flag."""
        return self._add("guard_condition", handle)

    def add_timer(self, handle: Any) -> int:
        """Wait for a timer."""
        return self._add("timer", handle)

    def add_client(self, handle: Any) -> int:
        """Wait for a response."""
        return self._add("client", handle)

    def add_service(self, handle: Any) -> int:
        """Wait for a request."""
        return self._add("service", handle)

    def add_event(self, handle: Any) -> int:
        """Wait for a QoS event."""
        return self._add("event", handle)

    def is_ready(self, kind: str, index: int) -> bool:
        """Whether the entity at an index is ready."""
        handle = self.handles[kind][index]
        if kind == "guard_condition":
            return handle.core.take()
        return handle.core.has_work()

    def wait(self, timeout_nsec: int) -> None:
        """Wait until an entity is ready, for at most `timeout_nsec` (negative: no limit). Others may wait for it too."""
        clock = current().clock
        deadline = None if timeout_nsec < 0 else clock.steady() + timeout_nsec
        while not any(source.has_work() for source in self.sources()):
            if deadline is not None and clock.steady() >= deadline:
                return
            clock.sleep(0.001)

    def sources(self) -> Iterator[Source]:
        """The sources of all entities that were added."""
        for handles in self.handles.values():
            for handle in handles:
                yield handle.core
