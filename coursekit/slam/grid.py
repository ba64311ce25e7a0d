"""The map: cells that are wall, free or unknown, as log-odds that every scan adds to. It grows as the robot drives."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from coursekit.slam.grid_kernels import update_grid
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.pose import Array, Pose2
from coursekit.slam.scan import Scan

CHUNK = 64
"""Cells that the grid grows by."""
LARGEST = 8000
"""Cells each way (400 m at 5 cm); a scan that would need more is left out."""


class OccupancyGrid:
    """Log-odds of cells. In ROS 2: the source of nav_msgs/OccupancyGrid.

    >>> grid = OccupancyGrid(SlamParameters())
    >>> grid.insert(Scan.from_points(np.array([[1.0, 0.02]]), grid.params), Pose2())
    >>> grid.value_at(1.0, 0.02) > 50 > grid.value_at(0.5, 0.02) >= 0
    True
    """

    def __init__(self, params: SlamParameters) -> None:
        self.params = params
        self.resolution = params.resolution
        self.log_odds = np.zeros((0, 0), dtype=np.float32)
        """Row 0 is the lowest y; 0 is unknown."""
        self.origin = (0.0, 0.0)
        """Lower left corner of the first cell [m], a multiple of the resolution."""

    def insert(self, scan: Scan, pose: Pose2) -> None:
        """Add a scan seen from a pose of the robot."""
        centre = pose @ scan.origin
        hits, misses = pose.transform(scan.hits), pose.transform(scan.misses)
        limit = LARGEST * self.resolution / 2
        hits, misses = (p[(np.abs(p - centre[:2]) < limit).all(axis=1)] for p in (hits, misses))
        if not self._make_room(np.concatenate([hits, misses, [[centre.x, centre.y]]])):
            return
        p = self.params
        update_grid(
            self.log_odds, np.ascontiguousarray(hits), np.ascontiguousarray(misses), centre.x - self.origin[0],
            centre.y - self.origin[1], self.origin[0], self.origin[1], self.resolution, p.hit_odds, p.miss_odds,
            p.odds_limit,
        )  # fmt: skip

    def insert_all(self, scans: Iterable[tuple[Scan, Pose2]]) -> None:
        """Add many."""
        for scan, pose in scans:
            self.insert(scan, pose)

    def _make_room(self, points: Array) -> bool:
        """Grow to hold the points; False when that would be too large."""
        r = self.resolution
        low = np.floor(points.min(axis=0) / r).astype(np.int64) - 1
        high = np.floor(points.max(axis=0) / r).astype(np.int64) + 2
        if not self.log_odds.size:
            self.origin = (float(low[0] * r), float(low[1] * r))
        first = np.round(np.array(self.origin) / r).astype(np.int64)
        size = np.array(self.log_odds.shape[::-1])
        before = -(-np.maximum(first - low, 0) // CHUNK) * CHUNK
        after = -(-np.maximum(high - first - size, 0) // CHUNK) * CHUNK
        if (size + before + after > LARGEST).any():
            return False
        if before.any() or after.any():
            self.log_odds = np.pad(self.log_odds, ((before[1], after[1]), (before[0], after[0])))
            self.origin = (float((first[0] - before[0]) * r), float((first[1] - before[1]) * r))
        return True

    def cells(self) -> np.ndarray:
        """int8 like OccupancyGrid.data: -1 unknown, else 0 (free) to 100 (wall)."""
        percent = np.rint(100.0 / (1.0 + np.exp(-self.log_odds.astype(np.float64)))).astype(np.int8)
        return np.where(self.log_odds == 0.0, np.int8(-1), percent)

    def value_at(self, x: float, y: float) -> int:
        """The cell at a position [m]: -1 unknown or outside, else 0 to 100."""
        j, i = (math.floor((at - corner) / self.resolution) for at, corner in zip((x, y), self.origin, strict=True))
        if not (0 <= i < self.log_odds.shape[0] and 0 <= j < self.log_odds.shape[1]):
            return -1
        odds = float(self.log_odds[i, j])
        return -1 if odds == 0.0 else round(100 / (1 + np.exp(-odds)))
