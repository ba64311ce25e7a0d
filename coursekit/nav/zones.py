"""Zones around a robot in which obstacles stop it, slow it down, or limit it by the time to collision."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coursekit.geometry.plane import Array, rotation

Speeds = tuple[float, float, float]
"""Forward and left [m/s], and angular velocity [rad/s]."""
STILL: Speeds = (0.0, 0.0, 0.0)


def within(points: Array, corners: Array) -> Array:
    """Return a mask of the points (n, 2) inside a polygon (k, 2).

    >>> box = np.array([[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]])
    >>> within(np.array([[0.5, 0.5], [1.5, 0.0]]), box).tolist()
    [True, False]
    """
    inside = np.zeros(len(points), bool)
    x, y = points[:, 0], points[:, 1]
    for (ax, ay), (bx, by) in zip(np.roll(corners, 1, axis=0), corners, strict=True):
        crosses = (ay > y) != (by > y)
        if crosses.any():
            inside ^= crosses & (x < (bx - ax) * (y - ay) / ((by - ay) or 1.0) + ax)
    return inside


@dataclass
class Zone:
    """An action for when at least `few` points are inside `corners` (k, 2), or within `radius` [m] of the robot.

    >>> zone = Zone("slowdown", few=2, radius=1.0, ratio=0.5)
    >>> near = np.array([[0.5, 0.0], [0.0, 0.6]])
    >>> zone.wish(near, (0.4, 0.0, 1.0)), zone.wish(near[:1], (0.4, 0.0, 1.0))
    ((0.2, 0.0, 0.5), None)
    """

    action: str
    few: int = 4
    corners: Array | None = None
    radius: float = 0.0
    ratio: float = 0.5
    linear_limit: float = 0.5
    angular_limit: float = 0.5
    ahead: float = 2.0
    """For `approach`: the time to collision from which on the robot slows down [s]."""
    step: float = 0.1

    def holds(self, points: Array) -> bool:
        """Whether enough points are inside."""
        if self.corners is None:
            return int((np.hypot(points[:, 0], points[:, 1]) < self.radius).sum()) >= self.few
        return int(within(points, self.corners).sum()) >= self.few

    def wish(self, points: Array, speeds: Speeds) -> Speeds | None:
        """Return the velocities that the zone allows instead of the wanted ones; None when nothing is in the way."""
        if self.action == "approach":
            left = self.seconds_left(points, speeds)
            return None if left is None else scaled(speeds, left / self.ahead)
        if not self.holds(points):
            return None
        if self.action == "stop":
            return STILL
        return scaled(speeds, self.ratio) if self.action == "slowdown" else self._limited(speeds)

    def _limited(self, speeds: Speeds) -> Speeds:
        pace, turn = math.hypot(speeds[0], speeds[1]), abs(speeds[2])
        return scaled(speeds, min(
            1.0, self.linear_limit / pace if pace else 1.0, self.angular_limit / turn if turn else 1.0,
        ))  # fmt: skip

    def seconds_left(self, points: Array, speeds: Speeds) -> float | None:
        """Return the time [s] to a collision of the robot's outline at these velocities; None if beyond `ahead`.

        >>> zone, post = Zone("approach", few=1, radius=0.5, ahead=3.0), np.array([[1.52, 0.0]])
        >>> [zone.seconds_left(post, (ahead, 0.0, 0.0)) for ahead in (0.5, -0.5)]
        [2.1, None]
        """
        x, y, heading = 0.0, 0.0, 0.0
        ahead, left, turn = speeds
        for count in range(int(self.ahead / self.step + 1e-9) + 1):
            if self.holds((points - (x, y)) @ rotation(heading)):
                return count * self.step
            c, s = math.cos(heading) * self.step, math.sin(heading) * self.step
            x, y, heading = x + ahead * c - left * s, y + ahead * s + left * c, heading + turn * self.step
        return None


def scaled(speeds: Speeds, share: float) -> Speeds:
    """Scale the velocities, which keeps the path."""
    return speeds[0] * share, speeds[1] * share, speeds[2] * share


def pace(speeds: Speeds) -> float:
    """Return a measure of speed, to compare the zones' velocities."""
    return sum(speed * speed for speed in speeds)


__all__ = ["STILL", "Speeds", "Zone", "pace", "scaled", "within"]
