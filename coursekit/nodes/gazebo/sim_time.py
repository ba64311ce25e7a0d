"""The simulation's time: the session's clock from when the simulator began, less the time that it stood still."""

from __future__ import annotations

from typing import Any

MOST_BEHIND_NS = 50_000_000
"""A computer that falls behind by more makes the simulation slower instead of jerking."""


class SimTime:
    """Nanoseconds of simulated time."""

    def __init__(self, clock: Any, paused: bool = False) -> None:
        self._clock = clock
        self.paused = paused
        self._zero = clock.steady()
        self._held = 0

    def now(self) -> int:
        """The time now."""
        return self._held if self.paused else self._clock.steady() - self._zero

    def pause(self) -> None:
        """Stand still; harmless when it does."""
        self._held, self.paused = self.now(), True

    def go_on(self) -> None:
        """Go on; harmless when it does."""
        self.set(self.now())
        self.paused = False

    def set(self, time_ns: int) -> None:
        """It is this time now."""
        self._held, self._zero = time_ns, self._clock.steady() - time_ns

    def keep_up(self, planned_ns: int) -> None:
        """Forget time that the simulation could not keep up with; work was planned for `planned_ns`."""
        if not (self.paused or self._clock.virtual) and self.now() - planned_ns > MOST_BEHIND_NS:
            self.set(planned_ns + MOST_BEHIND_NS)


__all__ = ["SimTime"]
