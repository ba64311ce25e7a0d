"""The simulation's time: the session's time since the start, scaled by the speed, without pauses."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coursekit.core.clock import Clock

MOST_BEHIND_NS = 50_000_000
"""The maximum lag [ns]: a slower computer slows the simulation down instead of making it jump."""


class SimTime:
    """Nanoseconds of simulated time.

    >>> from types import SimpleNamespace
    >>> clock = SimpleNamespace(virtual=True, now=0, steady=lambda: clock.now)
    >>> time = SimTime(clock)
    >>> time.go_at(2.0); clock.now = 100; time.now()
    200
    """

    def __init__(self, clock: Clock, paused: bool = False) -> None:
        self._clock = clock
        self.paused = paused
        self.speed = 1.0
        """Simulated seconds in a second of the session's clock."""
        self._begin = clock.steady()
        self._held = 0

    def now(self) -> int:
        """Return the current time."""
        return self._held if self.paused else self._held + round((self._clock.steady() - self._begin) * self.speed)

    def pause(self) -> None:
        """Pause; does nothing when paused."""
        self._held, self.paused = self.now(), True

    def go_on(self) -> None:
        """Resume; does nothing when running."""
        self.set(self.now())
        self.paused = False

    def go_at(self, speed: float) -> None:
        """Set the speed relative to the session's clock; ValueError unless it is above 0."""
        if not 0.0 < speed < float("inf"):
            raise ValueError(f"a speed is a number above 0, not {speed}")
        self.set(self.now())
        self.speed = speed

    def set(self, time_ns: int) -> None:
        """Set the current time."""
        self._held, self._begin = time_ns, self._clock.steady()

    def keep_up(self, planned_ns: int) -> None:
        """Drop time that the simulation could not keep up with; work was planned for `planned_ns`."""
        if not (self.paused or self._clock.virtual) and self.now() - planned_ns > MOST_BEHIND_NS:
            self.set(planned_ns + MOST_BEHIND_NS)


__all__ = ["SimTime"]
