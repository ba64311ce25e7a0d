"""The time in a recording during playback: it runs at a rate, can be paused, and can jump."""

from __future__ import annotations

import math
from typing import Any


class PlayClock:
    """The playback time in nanoseconds; `clock` is the session's clock.

    >>> from coursekit.core.virtual_clock import VirtualClock
    >>> wall = VirtualClock(); played = PlayClock(wall, start=0, rate=2.0)
    >>> wall.sleep(1.0); played.now()
    2000000000
    """

    def __init__(self, clock: Any, start: int, rate: float = 1.0, paused: bool = False) -> None:
        self._clock = clock
        self.rate = rate
        self.paused = paused
        self._here, self._there = clock.steady(), start

    def now(self) -> int:
        """The current time in the recording."""
        if self.paused:
            return self._there
        return self._there + int((self._clock.steady() - self._here) * self.rate)

    def jump(self, time: int) -> None:
        """Jump to a time in the recording."""
        self._here, self._there = self._clock.steady(), time

    def set_rate(self, rate: float) -> bool:
        """Run at another rate from now on. Return False for a rate that is not finite and above 0."""
        if not (rate > 0 and math.isfinite(rate)):
            return False
        self.jump(self.now())
        self.rate = rate
        return True

    def pause(self) -> None:
        """Stop the clock."""
        self.jump(self.now())
        self.paused = True

    def resume(self) -> None:
        """Let the clock run again."""
        self.jump(self.now())
        self.paused = False

    def seconds_until(self, time: int) -> float | None:
        """Seconds of session time until the recording reaches `time`, at least 0.0; None while it is paused."""
        if self.paused:
            return None
        due = self._here + math.ceil((time - self._there) / self.rate)
        return max(0.0, (due - self._clock.steady()) * 1e-9)
