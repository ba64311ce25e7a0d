"""Walks: sequences of poses that an object follows by itself, at given times, with smooth transitions."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from coursekit.geometry.plane import Array, Pose2D


@dataclass(frozen=True)
class Walk:
    """Poses [m, rad] at ascending times [s] from 0 on; with `loop` the walk starts again after its last pose.

    Two poses are joined by a cubic Hermite curve whose tangents follow the neighbours, as in Gazebo (its tension is 0: a
    Catmull-Rom spline). `delay` [s] is the pause before each round.

    >>> walk = Walk((0.0, 2.0), (Pose2D(0.0, 0.0, 0.0), Pose2D(1.0, 0.0, 0.0)), loop=False)
    >>> [round(walk.at(seconds).x, 3) for seconds in (0.0, 1.0, 2.0, 9.0)]
    [0.0, 0.5, 1.0, 1.0]
    """

    times: tuple[float, ...]
    poses: tuple[Pose2D, ...]
    loop: bool = True
    delay: float = 0.0

    def at(self, seconds: float) -> Pose2D:
        """Return the pose at a time since the start of the world."""
        end = self.times[-1]
        passed = max(0.0, seconds - self.delay)
        if self.loop and end > 0.0:
            passed = max(0.0, math.fmod(max(seconds, 0.0), self.delay + end) - self.delay)
        if len(self.poses) == 1 or passed >= end:
            return self.poses[-1]
        after = int(np.searchsorted(self.times, passed, side="right"))
        if after == 0:
            return self.poses[0]
        begin, finish = self.times[after - 1], self.times[after]
        x, y, theta = _between(self._rows, after, (passed - begin) / (finish - begin))
        return Pose2D(float(x), float(y), float(theta))

    @cached_property
    def _rows(self) -> Array:
        """The poses as rows, with unwrapped headings."""
        rows = np.array([tuple(pose) for pose in self.poses])
        rows[:, 2] = np.unwrap(rows[:, 2])
        return rows


def _between(rows: Array, after: int, part: float) -> Array:
    """Return the curve from row `after - 1` to row `after`, at a part of its time from 0 to 1."""
    start, end = rows[after - 1], rows[after]
    leave = (end - rows[max(after - 2, 0)]) / 2
    arrive = (rows[min(after + 1, len(rows) - 1)] - start) / 2
    square, cube = part**2, part**3
    weights = 2 * cube - 3 * square + 1, cube - 2 * square + part, 3 * square - 2 * cube, cube - square
    return np.asarray(weights[0] * start + weights[1] * leave + weights[2] * end + weights[3] * arrive)


__all__ = ["Walk"]
