"""Velocities limited to accelerations that a robot can achieve."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

Speeds = Sequence[float]
"""Forward [m/s], sideways [m/s] and angular [rad/s] velocity."""


@dataclass(frozen=True)
class AccelerationLimiter:
    """Limits of velocities and of their changes per second; decelerations are negative.

    With `together` all three changes are scaled alike, so that the robot stays on its curve.

    >>> AccelerationLimiter((0.5, 0, 1), (-0.5, 0, -1), (1, 0, 2), (-2, 0, -2)).toward((0.0, 0.0, 0.0), (0.8, 0.0, 0.1), 0.1)
    [0.1, 0.0, 0.1]
    """

    highest: Speeds
    lowest: Speeds
    acceleration: Speeds
    deceleration: Speeds
    together: bool = False

    def toward(self, now: Speeds, wish: Speeds, seconds: float) -> list[float]:
        """Return the velocities after `seconds`, changing from `now` towards `wish`."""
        goal = [max(low, min(high, speed)) for low, high, speed in zip(self.lowest, self.highest, wish, strict=True)]
        most = [self._most(k, now[k], goal[k]) * seconds for k in range(3)]
        gaps = [to - at for to, at in zip(goal, now, strict=True)]
        if self.together:
            share = min([1.0, *(room / abs(gap) for gap, room in zip(gaps, most, strict=True) if abs(gap) > 1e-9)])
            return [at + gap * share for at, gap in zip(now, gaps, strict=True)]
        return [at + max(-room, min(room, gap)) for at, gap, room in zip(now, gaps, most, strict=True)]

    def _most(self, axis: int, now: float, goal: float) -> float:
        """Return the maximum change per second."""
        faster = abs(goal) >= abs(now) and now * goal >= 0
        return self.acceleration[axis] if faster else -self.deceleration[axis]
