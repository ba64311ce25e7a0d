"""Whether two scans can be of the same place: no beam of one may pass through a wall that the other has seen.

Rooms that look alike match each other's walls; a false loop is revealed by scans that look through each other's walls.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
from numba import njit

from coursekit.geometry.plane import Array, Pose2D
from coursekit.slam.keyframe import Keyframe
from coursekit.slam.scan import Scan
from coursekit.slam.scan_kernels import usual_gap

TOLERANCE, TOLERANCE_PER_METRE = 0.2, 0.03
"""A point so far in front of a beam's end contradicts it [m]: poses have errors, and beams hit or miss edges."""
WIDEST = 3.0
"""Maximum gap between neighbouring beams, in usual gaps."""


@njit(cache=True)
def _count(points: Array, bearings: Array, ranges: Array, widest: float, fixed: float, growing: float) -> tuple[int, int]:
    """Return how many points agree with the ends of neighbouring beams, and how many are in front of them."""
    agreeing = standing = 0
    last = len(bearings)
    for k in range(len(points)):
        bearing, distance = math.atan2(points[k, 1], points[k, 0]), math.hypot(points[k, 0], points[k, 1])
        above = np.searchsorted(bearings, bearing)
        low, high = (above - 1) % last, above % last
        if (
            abs((bearing - bearings[low] + math.pi) % (2 * math.pi) - math.pi) > widest
            or abs((bearing - bearings[high] + math.pi) % (2 * math.pi) - math.pi) > widest
        ):
            continue
        slack = fixed + growing * distance
        if distance < min(ranges[low], ranges[high]) - slack:
            standing += 1
        elif distance <= max(ranges[low], ranges[high]) + slack:
            agreeing += 1
    return agreeing, standing


def _one_way(viewer: Scan, seen: Scan, motion: Pose2D) -> tuple[int, int]:
    bearings, ranges = viewer.polar
    widest = max(WIDEST * usual_gap(bearings), 0.03)
    points = motion.transform(seen.hits) - np.array([viewer.origin.x, viewer.origin.y])
    return _count(points, bearings, ranges, widest, TOLERANCE, TOLERANCE_PER_METRE)


def contradiction(pairs: Iterable[tuple[Scan, Scan, Pose2D]]) -> float:
    """Return the contradicting part of the comparable points of two scans, 0 to 1; several pairs are taken together.

    A pair is one scan, another, and the motion from the first one's robot pose to the second one's.

    >>> from coursekit.slam.parameters import SlamParameters
    >>> wall = Scan.from_points(np.column_stack([np.full(50, 2.0), np.linspace(-1, 1, 50)]), SlamParameters())
    >>> contradiction([(wall, wall, Pose2D())])
    0.0
    >>> contradiction([(wall, wall, Pose2D(1.0, 0.0, 0.0))]) > 0.4  # a metre on, the wall would be a metre nearer
    True
    """
    agreeing = standing = 0
    for one, other, motion in pairs:
        if len(one.hits) < 3 or len(other.hits) < 3:
            continue
        for viewer, seen, way in ((one, other, motion), (other, one, motion.inverse())):
            good, bad = _one_way(viewer, seen, way)
            agreeing, standing = agreeing + good, standing + bad
    return standing / max(agreeing + standing, 1)


class Usual:
    """The usual contradiction between keyframes that belong together: people walk, beams miss edges.

    >>> usual = Usual()
    >>> round(usual.limit, 3)  # at first 2 % of the points are taken as usual
    0.1
    """

    APART = 10
    """Number of keyframes between the two that are compared."""
    RATE = 0.1

    def __init__(self) -> None:
        self._mean = 0.02

    def learn(self, keyframes: list[Keyframe], poses: Array) -> None:
        """Compare the newest keyframe with one a few metres before it."""
        new, old = len(keyframes) - 1, len(keyframes) - 1 - self.APART
        if old >= 0:
            motion = Pose2D.of(poses[old]).to(Pose2D.of(poses[new]))
            told = contradiction([(keyframes[old].scan, keyframes[new].scan, motion)])
            self._mean += self.RATE * (told - self._mean)

    @property
    def limit(self) -> float:
        """A loop with more contradiction than this is false."""
        return 0.02 + 4.0 * self._mean
