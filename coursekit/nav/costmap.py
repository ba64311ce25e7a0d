"""Costmaps: the cost of each cell for a robot's centre, with nav2's constants."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FREE, INSCRIBED, LETHAL, UNKNOWN = 0, 253, 254, 255
"""No cost; the robot's centre cannot be here without touching something; an obstacle; unknown."""
Cells = NDArray[np.uint8]


@dataclass
class Costmap:
    """Costs (rows, columns) uint8, row 0 at the smallest y; `x`, `y` are the corner of cell (0, 0) [m], `resolution` metres.

    >>> costs = Costmap.of_size(2.0, 1.0, 0.5, x=-1.0)
    >>> costs.cells.shape, costs.cell(0.6, 0.1), costs.inside(5.0, 0.0)
    ((2, 4), (0, 3), False)
    """

    cells: Cells
    resolution: float
    x: float = 0.0
    y: float = 0.0

    @classmethod
    def of_size(
        cls, width: float, height: float, resolution: float, x: float = 0.0, y: float = 0.0, fill: int = FREE
    ) -> Costmap:
        """Return a map of this size in metres, filled with one value."""
        shape = max(round(height / resolution), 1), max(round(width / resolution), 1)
        return cls(np.full(shape, fill, dtype=np.uint8), resolution, x, y)

    def cell(self, x: float, y: float) -> tuple[int, int]:
        """Return row and column of a position [m]; they may be outside of the map."""
        return math.floor((y - self.y) / self.resolution), math.floor((x - self.x) / self.resolution)

    def centre(self, row: int, column: int) -> tuple[float, float]:
        """Return the centre of a cell [m].

        >>> Costmap.of_size(2.0, 1.0, 0.5, x=-1.0).centre(0, 3)
        (0.75, 0.25)
        """
        return self.x + (column + 0.5) * self.resolution, self.y + (row + 0.5) * self.resolution

    def inside(self, x: float, y: float) -> bool:
        """Whether the position is on the map."""
        row, column = self.cell(x, y)
        return 0 <= row < self.cells.shape[0] and 0 <= column < self.cells.shape[1]

    def cost(self, x: float, y: float) -> int:
        """Return the cost at a position; UNKNOWN outside of the map.

        >>> costs = Costmap.of_size(2.0, 1.0, 0.5, x=-1.0)
        >>> costs.cells[0, 3] = LETHAL
        >>> costs.cost(0.75, 0.25), costs.cost(-0.75, 0.25), costs.cost(9.0, 0.0) == UNKNOWN
        (254, 0, True)
        """
        row, column = self.cell(x, y)
        return int(self.cells[row, column]) if self.inside(x, y) else UNKNOWN

    def like(self, fill: int) -> Costmap:
        """Return another map of the same cells, filled with one value."""
        return Costmap(np.full(self.cells.shape, fill, dtype=np.uint8), self.resolution, self.x, self.y)

    def moved_to(self, x: float, y: float, fill: int) -> Costmap:
        """Return the map at another corner, shifted by whole cells; overlapping cells are kept, the rest is `fill`.

        >>> costs = Costmap(np.array([[1, 2, 3]], np.uint8), 0.5)
        >>> moved = costs.moved_to(0.5, 0.0, fill=9)
        >>> moved.x, moved.cells.tolist()
        (0.5, [[2, 3, 9]])
        """
        rows, columns = self.cells.shape
        down, right = round((y - self.y) / self.resolution), round((x - self.x) / self.resolution)
        corner = self.x + right * self.resolution, self.y + down * self.resolution
        costmap = Costmap(np.full_like(self.cells, fill), self.resolution, *corner)
        if abs(down) < rows and abs(right) < columns:
            to_row, to_column = slice(max(-down, 0), rows - max(down, 0)), slice(max(-right, 0), columns - max(right, 0))
            of_row, of_column = slice(max(down, 0), rows - max(-down, 0)), slice(max(right, 0), columns - max(-right, 0))
            costmap.cells[to_row, to_column] = self.cells[of_row, of_column]
        return costmap


def static_costs(cells: NDArray[np.int8], *, lethal: int = 100, unknown: bool = True, trinary: bool = True) -> Cells:
    """Return the costs of an occupancy grid: -1 is unknown (free unless `unknown`), values from `lethal` on are obstacles.

    >>> static_costs(np.array([[0, -1, 60, 100]], np.int8)).tolist()
    [[0, 255, 0, 254]]
    """
    scaled = np.zeros(cells.shape) if trinary else cells.astype(float) / max(lethal, 1) * LETHAL
    costs = np.where(cells >= lethal, LETHAL, np.where(cells < 0, UNKNOWN if unknown else FREE, scaled))
    return costs.astype(np.uint8)


_OCCUPANCY = np.array([0, *(1 + 97 * (cost - 1) // 251 for cost in range(1, 253)), 99, 100, -1], dtype=np.int8)


def occupancy(cells: Cells) -> NDArray[np.int8]:
    """Convert costs to an occupancy grid: 0 free, 1 to 98 cost, 99 inscribed, 100 obstacle, -1 unknown.

    >>> occupancy(np.array([0, 128, 253, 254, 255], np.uint8)).tolist()
    [0, 50, 99, 100, -1]
    """
    shown: NDArray[np.int8] = _OCCUPANCY[cells]
    return shown


def combine(below: Cells, above: Cells) -> None:
    """Merge a layer into another, in place: the greater cost wins, and known cells override UNKNOWN.

    >>> base = np.array([255, 0, 254, 7], np.uint8); combine(base, np.array([0, 254, 0, 255], np.uint8)); base.tolist()
    [0, 254, 254, 7]
    """
    wins = (above != UNKNOWN) & ((below == UNKNOWN) | (above > below))
    below[wins] = above[wins]
