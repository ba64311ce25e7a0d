"""Processes measurements in the order of their times, including late ones."""

from __future__ import annotations

import heapq
import itertools
from collections import deque
from dataclasses import replace

from coursekit.nav.fusion.kalman import Ekf, Estimate
from coursekit.nav.fusion.measurement import Measurement


class Estimator:
    """A filter with a queue in front of it.

    With a `history_ns` it goes back when a measurement is late, and processes the later ones again.
    With `up_to_now` it always predicts to the present; otherwise only after `timeout_ns` without measurements.
    """

    def __init__(self, inner: Ekf, timeout_ns: int, history_ns: int = 0, *, up_to_now: bool = False) -> None:
        self.filter, self.timeout_ns = inner, timeout_ns
        self._history_ns, self._up_to_now = history_ns, up_to_now
        self._queue: list[tuple[int, int, Measurement]] = []
        self._count = itertools.count()
        self._taken: deque[tuple[Estimate, Measurement]] = deque()
        self.refused: list[str] = []

    def add(self, measurement: Measurement) -> None:
        """Queue a measurement."""
        heapq.heappush(self._queue, (measurement.time_ns, next(self._count), measurement))

    def forget(self) -> None:
        """Clear the queue and the history."""
        self._queue.clear()
        self._taken.clear()

    def advance(self, now_ns: int) -> None:
        """Process all measurements up to now; future ones stay queued. `refused` lists the rejected sources."""
        self.refused.clear()
        waited = bool(self._queue)
        if waited and self._history_ns:
            self._go_back(self._queue[0][0])
        while self._queue and self._queue[0][0] <= now_ns:
            self._take(heapq.heappop(self._queue)[2])
        silent = not waited and now_ns - self.filter.now.time_ns >= self.timeout_ns
        if self.filter.now.begun and (self._up_to_now or silent) and now_ns > self.filter.now.time_ns:
            self.filter.predict(now_ns)
        while self._taken and self._taken[0][1].time_ns < self.filter.now.time_ns - self._history_ns:
            self._taken.popleft()

    def _take(self, measurement: Measurement) -> None:
        if self._history_ns:
            now = self.filter.now
            self._taken.append((replace(now, state=now.state.copy(), covariance=now.covariance.copy()), measurement))
        if not self.filter.take(measurement):
            self.refused.append(measurement.source)

    def _go_back(self, time_ns: int) -> None:
        """Undo the measurements processed after a time, and queue them again."""
        while self._taken and self._taken[-1][1].time_ns > time_ns:
            self.filter.now, measurement = self._taken.pop()
            self.add(measurement)
