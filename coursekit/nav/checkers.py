"""Checks whether a robot has reached its goal, and whether it makes progress."""

from __future__ import annotations

import math
from dataclasses import dataclass

from coursekit.geometry.plane import wrap

Pose = tuple[float, float, float]


@dataclass
class GoalChecker:
    """Tolerances in position [m] and heading [rad]. With `stateful` a position once reached stays reached.

    With `still` the robot must also be slower than these speeds [m/s, rad/s].

    >>> checker = GoalChecker()
    >>> checker.reached((0.1, 0.0, 1.0), (0.0, 0.0, 0.0)), checker.near((0.3, 0.0, 0.0), (0.0, 0.0, 0.0))
    (False, True)
    >>> checker.reached((0.3, 0.0, 0.1), (0.0, 0.0, 0.0))
    True
    """

    xy_tolerance: float = 0.25
    yaw_tolerance: float = 0.25
    stateful: bool = True
    still: tuple[float, float] | None = None
    _near: bool = False

    def reset(self) -> None:
        """Reset for a new goal."""
        self._near = False

    def near(self, pose: Pose, goal: Pose) -> bool:
        """Whether the position is reached."""
        near = math.hypot(pose[0] - goal[0], pose[1] - goal[1]) <= self.xy_tolerance
        self._near = near or (self.stateful and self._near)
        return self._near

    def reached(self, pose: Pose, goal: Pose, speeds: tuple[float, float] = (0.0, 0.0)) -> bool:
        """Whether position and heading are reached by a robot with these velocities."""
        if self.still and (abs(speeds[0]) > self.still[0] or abs(speeds[1]) > self.still[1]):
            return False
        turn = wrap(pose[2] - goal[2])
        return self.near(pose, goal) and abs(turn) <= self.yaw_tolerance


@dataclass
class ProgressChecker:
    """A robot makes progress when it moves `radius` metres, or rotates by `angle` [rad], within `seconds`.

    >>> checker = ProgressChecker(0.5, 10.0)
    >>> [checker.gets_on(x, 0.0, t) for x, t in ((0.0, 0.0), (0.4, 9.0), (0.6, 9.9), (0.7, 19.0), (0.7, 20.5))]
    [True, True, True, True, False]
    """

    radius: float = 0.5
    seconds: float = 10.0
    angle: float = math.inf
    _mark: tuple[float, float, float, float] | None = None

    def reset(self) -> None:
        """Restart the measurement: the robot may have stood still until now."""
        self._mark = None

    def gets_on(self, x: float, y: float, now: float, yaw: float = 0.0) -> bool:
        """Whether it makes progress, given a position [m], time [s] and heading [rad]."""
        if self._mark is None or self._moved(self._mark, x, y, yaw):
            self._mark = (x, y, yaw, now)
        return now - self._mark[3] <= self.seconds

    def _moved(self, mark: tuple[float, float, float, float], x: float, y: float, yaw: float) -> bool:
        turn = abs(wrap(yaw - mark[2]))
        return math.hypot(x - mark[0], y - mark[1]) > self.radius or turn > self.angle
