"""Whether a robot has arrived, and whether it still gets on."""

from __future__ import annotations

import math
from dataclasses import dataclass

Pose = tuple[float, float, float]


@dataclass
class GoalChecker:
    """Near enough: position [m] and heading [rad]. With `stateful` a position once reached stays reached.

    >>> checker = GoalChecker()
    >>> checker.reached((0.1, 0.0, 1.0), (0.0, 0.0, 0.0)), checker.near((0.3, 0.0, 0.0), (0.0, 0.0, 0.0))
    (False, True)
    >>> checker.reached((0.3, 0.0, 0.1), (0.0, 0.0, 0.0))
    True
    """

    xy_tolerance: float = 0.25
    yaw_tolerance: float = 0.25
    stateful: bool = True
    _near: bool = False

    def reset(self) -> None:
        """A new goal."""
        self._near = False

    def near(self, pose: Pose, goal: Pose) -> bool:
        """Whether the position is reached."""
        near = math.hypot(pose[0] - goal[0], pose[1] - goal[1]) <= self.xy_tolerance
        self._near = near or (self.stateful and self._near)
        return self._near

    def reached(self, pose: Pose, goal: Pose) -> bool:
        """Whether position and heading are reached."""
        turn = (pose[2] - goal[2] + math.pi) % (2 * math.pi) - math.pi
        return self.near(pose, goal) and abs(turn) <= self.yaw_tolerance


@dataclass
class ProgressChecker:
    """A robot gets on when it moves `radius` metres in `seconds`.

    >>> checker = ProgressChecker(0.5, 10.0)
    >>> [checker.gets_on(x, 0.0, t) for x, t in ((0.0, 0.0), (0.4, 9.0), (0.6, 9.9), (0.7, 19.0), (0.7, 20.5))]
    [True, True, True, True, False]
    """

    radius: float = 0.5
    seconds: float = 10.0
    _mark: tuple[float, float, float] | None = None

    def reset(self) -> None:
        """It may stand still until now."""
        self._mark = None

    def gets_on(self, x: float, y: float, now: float) -> bool:
        """Whether it does, at a place [m] and time [s]."""
        if self._mark is None or math.hypot(x - self._mark[0], y - self._mark[1]) > self.radius:
            self._mark = (x, y, now)
        return now - self._mark[2] <= self.seconds
