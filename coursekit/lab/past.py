"""A panel's last minutes, in a bounded part of the memory, and the time that all panels show."""

from __future__ import annotations

import threading
import weakref
from bisect import bisect_right
from collections import deque
from collections.abc import Callable
from typing import Any

from coursekit.processes.session import Session

SECONDS = 300.0
"""How far back one can go [s]."""
LARGEST = 64_000_000
"""The memory for one panel's past [bytes]; with large messages it reaches less far back."""
EVERY_SECONDS = 0.2
"""A moment of a scene is kept so often [s]."""


class Past:
    """Moments with their times [ns] and sizes [bytes].

    >>> past = Past()
    >>> for second in range(3):
    ...     past.keep(second * 10**9, f"moment {second}", 100)
    >>> past.at(1_500_000_000), past.at(-1), past.span()
    ('moment 1', 'moment 0', (0, 2000000000))
    """

    def __init__(self, seconds: float = SECONDS, largest: int = LARGEST) -> None:
        self._reach, self._largest = round(seconds * 1e9), largest
        self._times: deque[int] = deque()
        self._moments: deque[tuple[Any, int]] = deque()
        self._size = 0
        self._lock = threading.Lock()

    def keep(self, time: int, moment: Any, size: int) -> None:
        """Keep what is shown from now on, and forget what is too old, or too much."""
        with self._lock:
            self._times.append(time)
            self._moments.append((moment, size))
            self._size += size
            while len(self._times) > 1 and (time - self._times[0] > self._reach or self._size > self._largest):
                self._times.popleft()
                self._size -= self._moments.popleft()[1]

    def at(self, time: int) -> Any:
        """The state at a time: the oldest moment for earlier ones, None when nothing is kept."""
        with self._lock:
            if not self._times:
                return None
            return self._moments[max(0, bisect_right(self._times, time) - 1)][0]

    def span(self) -> tuple[int, int] | None:
        """The times of the oldest and the newest moment; None when nothing is kept."""
        with self._lock:
            return (self._times[0], self._times[-1]) if self._times else None


class Cursor:
    """The time that the panels of a session show: one of the past, or None for what happens now."""

    def __init__(self) -> None:
        self.time: int | None = None
        self.watchers: list[Callable[[], None]] = []
        """Called when it has moved, by whoever has moved it."""

    def go(self, time: int | None) -> None:
        """Have all panels show this time; None is now."""
        self.time = time
        for tell in list(self.watchers):
            tell()


_cursors: weakref.WeakKeyDictionary[Session, Cursor] = weakref.WeakKeyDictionary()


def cursor_of(session: Session) -> Cursor:
    """The session's cursor."""
    return _cursors.setdefault(session, Cursor())


__all__ = ["EVERY_SECONDS", "SECONDS", "Cursor", "Past", "cursor_of"]
