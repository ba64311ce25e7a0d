"""The recent history of a panel, in bounded memory, and the time shown by all panels."""

from __future__ import annotations

import threading
import weakref
from bisect import bisect_right
from collections import deque
from collections.abc import Callable
from typing import Any

from coursekit.processes.session import Session

SECONDS = 300.0
"""The length of the history [s]."""
LARGEST = 64_000_000
"""The memory limit of one panel's history [bytes]; with large messages it is shorter than `SECONDS`."""
EVERY_SECONDS = 0.2
"""The recording period of a scene [s]."""


class PanelHistory:
    """Moments with their times [ns] and sizes [bytes].

    >>> past = PanelHistory()
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
        """Record the content shown from now on; drop moments that are too old or exceed the memory limit."""
        with self._lock:
            self._times.append(time)
            self._moments.append((moment, size))
            self._size += size
            while len(self._times) > 1 and (time - self._times[0] > self._reach or self._size > self._largest):
                self._times.popleft()
                self._size -= self._moments.popleft()[1]

    def at(self, time: int) -> Any:
        """Return the state at a time: the oldest moment for earlier times, None when nothing is recorded."""
        with self._lock:
            if not self._times:
                return None
            return self._moments[max(0, bisect_right(self._times, time) - 1)][0]

    def span(self) -> tuple[int, int] | None:
        """Return the times of the oldest and the newest moment; None when nothing is recorded."""
        with self._lock:
            return (self._times[0], self._times[-1]) if self._times else None


class Cursor:
    """The time shown by a session's panels: a past time, or None for live."""

    def __init__(self) -> None:
        self.time: int | None = None
        self.watchers: list[Callable[[], None]] = []
        """Callbacks after a move, called in the thread that moved the cursor."""

    def go(self, time: int | None) -> None:
        """Show this time in all panels; None is live."""
        self.time = time
        for tell in list(self.watchers):
            tell()


_cursors: weakref.WeakKeyDictionary[Session, Cursor] = weakref.WeakKeyDictionary()


def cursor_of(session: Session) -> Cursor:
    """Return the session's cursor."""
    return _cursors.setdefault(session, Cursor())


__all__ = ["EVERY_SECONDS", "SECONDS", "Cursor", "PanelHistory", "cursor_of"]
