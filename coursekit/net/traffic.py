"""Rates and delays of messages."""

from __future__ import annotations

from collections import deque
from statistics import median

SPAN = 5_000_000_000
"""Time window for rates and delays [ns]."""


class Traffic:
    """The messages of one topic in one direction; times are from this computer's clock [ns]."""

    def __init__(self) -> None:
        self.total = 0
        self._recent: deque[tuple[int, int]] = deque(maxlen=256)

    def count(self, now: int, delay: int = 0) -> None:
        """Count a message that took `delay`."""
        self.total += 1
        self._recent.append((now, delay))

    def rate(self, now: int) -> float:
        """Return the recent messages per second.

        >>> traffic = Traffic()
        >>> for k in range(11):
        ...     traffic.count(k * 100_000_000)
        >>> traffic.rate(1_000_000_000)
        10.0
        """
        times = [at for at, _ in list(self._recent) if now - at <= SPAN]
        if len(times) < 2 or times[-1] == times[0]:
            return 0.0
        return (len(times) - 1) * 1e9 / (times[-1] - times[0])

    def delay(self, now: int) -> float | None:
        """Return the median of the recent delays [s]; the difference between the two clocks adds to it.

        >>> traffic = Traffic()
        >>> for delay in (10_000_000, 20_000_000, 900_000_000):
        ...     traffic.count(10**9, delay)
        >>> traffic.delay(10**9)
        0.02
        """
        delays = [delay for at, delay in list(self._recent) if now - at <= SPAN]
        return median(delays) * 1e-9 if delays else None
