"""Separates messages of ROS nodes from those that the gateway published itself: rclpy receives both and cannot filter."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable

REMEMBERED_SECONDS = 10.0
"""Time within which a message published by the gateway comes back [s]."""
ROUNDING_NS = 1000
"""Rounding error of the middleware's stamps, which are binary fractions of a second [ns]."""


class Published:
    """A message published by the gateway: its hash, and the start and end of the publish call."""

    def __init__(self, data: bytes) -> None:
        self.words = hash(data)
        self.begin_ns = time.time_ns() - ROUNDING_NS
        self.end_ns: int | None = None
        """Set after publishing: the message may be received before."""

    def has(self, data: bytes, stamp_ns: int) -> bool:
        """Whether the data may be this message; a stamp of 0 means none, as some middlewares send it."""
        in_time = self.begin_ns <= stamp_ns and (self.end_ns is None or stamp_ns <= self.end_ns)
        return self.words == hash(data) and (in_time or not stamp_ns)


class Echo:
    """The gateway's own messages on one topic that have not come back yet.

    The content alone does not identify them: a robot may send the same content, and messages sent before the middleware
    has matched both endpoints never come back. The source time of the gateway's own messages lies within the publish call.

    >>> echo = Echo()
    >>> echo.publish(print, b"a")
    b'a'
    >>> echo.is_own(b"a", time.time_ns() + 1_000_000_000), echo.is_own(b"a", 0), echo.is_own(b"a", 0)
    (False, True, False)
    """

    def __init__(self) -> None:
        self._said: deque[Published] = deque(maxlen=1000)
        self._lock = threading.Lock()

    def publish(self, publish: Callable[[bytes], None], data: bytes) -> None:
        """Publish a message through `publish` and remember it."""
        published = Published(data)
        with self._lock:
            self._said.append(published)
        publish(data)
        published.end_ns = time.time_ns() + ROUNDING_NS

    def is_own(self, data: bytes, stamp_ns: int) -> bool:
        """Whether a message sent at this time is one of the gateway's own; each comes back once."""
        oldest = time.time_ns() - int(REMEMBERED_SECONDS * 1e9)
        with self._lock:
            while self._said and self._said[0].begin_ns < oldest:
                self._said.popleft()
            own = next((sent for sent in self._said if sent.has(data, stamp_ns)), None)
            if own is not None:
                self._said.remove(own)
        return own is not None
