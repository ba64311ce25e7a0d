"""The map: wall, free or unknown cells, as log-odds updated by every scan. It grows as the robot drives."""

from __future__ import annotations

import math

import numpy as np

from coursekit.geometry.plane import Pose2D
from coursekit.slam.grid_kernels import place, update_grid
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Scan

CHUNK = 64
"""Size of the steps in which the grid grows [cells]."""
WALL_ODDS, FREE_ODDS = 0.62, -0.35
"""Log-odds: cells above 65 % are walls, those below 41 % free."""
LARGEST = 8000
"""Maximum size in each direction [cells] (400 m at 5 cm); a scan that would exceed it is left out."""


class OccupancyGrid:
    """Log-odds of cells. In ROS 2: the source of nav_msgs/OccupancyGrid.

    >>> grid = OccupancyGrid(SlamParameters())
    >>> grid.insert(Scan.from_points(np.array([[1.0, 0.02]]), grid.params), Pose2D())
    >>> grid.value_at(1.0, 0.02) > 50 > grid.value_at(0.5, 0.02) >= 0
    True
    """

    def __init__(self, params: SlamParameters) -> None:
        self.params = params
        self.resolution = params.resolution
        self.log_odds = np.zeros((0, 0), dtype=np.float32)
        """Row 0 is the lowest y; 0 is unknown."""
        self._marks = np.zeros((0, 0), dtype=np.int32)
        self._number = 0
        self._corner = (0, 0)
        self._hit, self._miss, self._limit = (
            np.float32(value) for value in (params.hit_odds, params.miss_odds, params.odds_limit)
        )
        self.origin = (0.0, 0.0)
        """Lower left corner of the first cell [m], a multiple of the resolution."""

    def insert(self, scan: Scan, pose: Pose2D) -> None:
        """Add a scan seen from a pose of the robot."""
        centre = pose @ scan.origin
        bounds = np.array([centre.x, centre.y, centre.x, centre.y])
        limit = LARGEST * self.resolution / 2
        hits = place(scan.hits, pose.x, pose.y, pose.theta, limit, bounds)
        misses = place(scan.misses, pose.x, pose.y, pose.theta, limit, bounds)
        if not self._make_room(*bounds.tolist()):
            return
        self._number += 1
        update_grid(
            self.log_odds.reshape(-1), self._marks.reshape(-1), self.log_odds.shape[1], self._number, hits, misses,
            centre.x, centre.y, self.origin[0], self.origin[1], self.resolution, self._hit, self._miss, self._limit,
        )  # fmt: skip

    def _make_room(self, left: float, bottom: float, right: float, top: float) -> bool:
        """Grow to contain a rectangle; False when that would be too large."""
        r, (rows, columns) = self.resolution, self.log_odds.shape
        if not self.log_odds.size:
            self._corner = (math.floor(left / r) - 1, math.floor(bottom / r) - 1)
        j, i = self._corner
        before = (_chunks(j - math.floor(left / r) + 1), _chunks(i - math.floor(bottom / r) + 1))
        after = (
            _chunks(math.floor(right / r) + 2 - j - columns),
            _chunks(math.floor(top / r) + 2 - i - rows),
        )
        if not any(before) and not any(after):
            return True
        if max(columns + before[0] + after[0], rows + before[1] + after[1]) > LARGEST:
            return False
        pads = ((before[1], after[1]), (before[0], after[0]))
        self.log_odds, self._marks = np.pad(self.log_odds, pads), np.pad(self._marks, pads)
        self._corner = (j - before[0], i - before[1])
        self.origin = (self._corner[0] * r, self._corner[1] * r)
        return True

    def cells(self) -> np.ndarray:
        """Return the cells as int8 like OccupancyGrid.data: -1 unknown, else 0 (free) to 100 (wall).

        >>> grid = OccupancyGrid(SlamParameters())
        >>> grid.insert(Scan.from_points(np.array([[1.0, 0.02]]), grid.params), Pose2D())
        >>> cells = grid.cells()
        >>> cells.dtype.name, int(cells.min()), int((cells > 50).sum())  # unknown around one wall cell
        ('int8', -1, 1)
        """
        percent = np.rint(100.0 / (1.0 + np.exp(-self.log_odds.astype(np.float64)))).astype(np.int8)
        return np.where(self.log_odds == 0.0, np.int8(-1), percent)

    def trinary(self) -> np.ndarray:
        """Return the cells as int8: -1 unknown or undecided, 0 free, 100 wall, as slam_toolbox publishes them.

        >>> grid = OccupancyGrid(SlamParameters(resolution=0.5))
        >>> for _ in range(5):
        ...     grid.insert(Scan.from_points(np.array([[1.5, 0.0]]), grid.params), Pose2D(0.25, 0.25, 0.0))
        >>> row = math.floor((0.25 - grid.origin[1]) / 0.5)
        >>> [int(cell) for cell in grid.trinary()[row] if cell >= 0]
        [0, 0, 100]
        """
        known = np.where(self.log_odds < FREE_ODDS, np.int8(0), np.int8(-1))
        return np.where(self.log_odds > WALL_ODDS, np.int8(100), known)

    def value_at(self, x: float, y: float) -> int:
        """Return the cell at a position [m]: -1 unknown or outside, else 0 to 100.

        >>> OccupancyGrid(SlamParameters()).value_at(3.0, 4.0)
        -1
        """
        j, i = (
            math.floor((at - corner) / self.resolution)
            for at, corner in zip((x, y), self.origin, strict=True)
        )
        if not (0 <= i < self.log_odds.shape[0] and 0 <= j < self.log_odds.shape[1]):
            return -1
        odds = float(self.log_odds[i, j])
        return -1 if odds == 0.0 else round(100 / (1 + np.exp(-odds)))


def _chunks(cells: int) -> int:
    """Round a number of cells up to whole chunks."""
    return -(-max(cells, 0) // CHUNK) * CHUNK
