"""Tells what ROS's nodes say from what the gateway said for others: rclpy hears both, and cannot leave one out."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable

REMEMBERED_SECONDS = 10.0
"""How long a message that the gateway published may take to come back [s]."""
ROUNDING_NS = 1000
"""By how much the middleware's stamps may be off: they are binary fractions of a second [ns]."""


class Published:
    """A message that the gateway published: its words, and when that began and ended."""

    def __init__(self, data: bytes) -> None:
        self.words = hash(data)
        self.begin_ns = time.time_ns() - ROUNDING_NS
        self.end_ns: int | None = None
        """Known when it is published: it may be heard before."""

    def has(self, data: bytes, stamp_ns: int) -> bool:
        """Whether it may be this one; a stamp of 0 is none, as some middlewares send it."""
        in_time = self.begin_ns <= stamp_ns and (self.end_ns is None or stamp_ns <= self.end_ns)
        return self.words == hash(data) and (in_time or not stamp_ns)


class Echo:
    """The gateway's own messages on one topic, until they are heard.

    The words alone do not tell them from a robot's: the same words may be said on both sides, and what was said before the
    middleware had joined both ends is never heard. The time at which it was sent lies within the call that published it.

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
        """Call `publish` with a message, whose echo is known from now on."""
        one = Published(data)
        with self._lock:
            self._said.append(one)
        publish(data)
        one.end_ns = time.time_ns() + ROUNDING_NS

    def is_own(self, data: bytes, stamp_ns: int) -> bool:
        """Whether a message that was sent at this time is one of those that were published; each comes back once."""
        oldest = time.time_ns() - int(REMEMBERED_SECONDS * 1e9)
        with self._lock:
            while self._said and self._said[0].begin_ns < oldest:
                self._said.popleft()
            found = next((one for one in self._said if one.has(data, stamp_ns)), None)
            if found is not None:
                self._said.remove(found)
        return found is not None
