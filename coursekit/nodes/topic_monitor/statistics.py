"""The statistics of one monitored topic: whether it is alive, and the share of messages that arrive."""

from __future__ import annotations

from collections import deque

from coursekit.nodes.topic_monitor.data_publisher import LAST


class TopicStatistics:
    """Compares the received with the expected numbers, over the last `window` numbers. Times are in seconds.

    >>> topic = TopicStatistics(window=4, depth=10, period=1.0, latency=1.0, stale=1.5)
    >>> for at in range(4):
    ...     topic.heard(at, now=float(at))
    >>> topic.rate(now=4.0), topic.status(now=4.0), topic.status(now=5.0)
    (1.0, 'Alive', 'Stale')
    """

    def __init__(self, *, window: int, depth: int, period: float, latency: float, stale: float) -> None:
        self._window, self._depth, self._period = window, depth, period
        self._latency, self._stale = latency, stale
        self._numbers: deque[int] = deque(maxlen=4 * window)
        self._began: tuple[int, float] | None = None
        self._last = 0.0

    def heard(self, number: int, now: float) -> None:
        """Record a number; LAST ends the counting."""
        self._last = now
        if number == LAST:
            self._began = None
            return
        if self._began is None:
            self._began = (number, now)
            self._numbers.clear()
        self._numbers.append(number)

    def status(self, now: float) -> str:
        """'Offline', 'Alive' or 'Stale'."""
        if self._began is None:
            return "Offline"
        return "Stale" if now - self._last > self._stale else "Alive"

    def rate(self, now: float) -> float:
        """The share of the expected numbers that was received, 0 ... 1; 0 for a topic that is offline."""
        if self._began is None:
            return 0.0
        first, since = self._began
        newest = first + int(max(0.0, now - since - self._latency) / self._period)
        wanted = range(max(first - self._depth, newest - self._window + 1), newest + 1)
        return len(set(wanted) & set(self._numbers)) / len(wanted)
