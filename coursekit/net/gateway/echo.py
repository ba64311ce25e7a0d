"""Tells what ROS's nodes say from what the gateway said for others: rclpy hears both, and cannot leave one out."""

from __future__ import annotations

import threading
import time
from collections import deque

REMEMBERED_SECONDS = 2.0
"""How long a message that the gateway published may take to come back [s]."""


class Echo:
    """The gateway's own messages on one topic, until they are heard.

    >>> echo = Echo()
    >>> echo.said(b"a")
    >>> echo.is_own(b"a"), echo.is_own(b"a")
    (True, False)
    """

    def __init__(self) -> None:
        self._said: deque[tuple[int, float]] = deque(maxlen=1000)
        self._lock = threading.Lock()

    def said(self, data: bytes) -> None:
        """The gateway is about to publish this."""
        with self._lock:
            self._said.append((hash(data), time.monotonic()))

    def is_own(self, data: bytes) -> bool:
        """Whether this is one of those that were said; each comes back once."""
        with self._lock:
            while self._said and time.monotonic() - self._said[0][1] > REMEMBERED_SECONDS:
                self._said.popleft()
            found = next((one for one in self._said if one[0] == hash(data)), None)
            if found is not None:
                self._said.remove(found)
        return found is not None
