"""Scans in a costmap: an obstacle at the end of a beam, free cells along it."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from coursekit.nav.costmap import FREE, LETHAL, UNKNOWN, Costmap


class ObstacleLayer:
    """Obstacles seen by scans, on the cells of a costmap.

    >>> layer = ObstacleLayer(Costmap.of_size(4.0, 1.0, 0.5, y=-0.5))
    >>> layer.see((0.1, 0.0), np.array([[2.2, 0.0]]), np.array([True]))
    >>> layer.map.cells[1].tolist()
    [0, 0, 0, 0, 254, 255, 255, 255]
    >>> layer.see((0.1, 0.0), np.array([[3.2, 0.0]]), np.array([True]))  # it has moved away
    >>> layer.map.cells[1].tolist()
    [0, 0, 0, 0, 0, 0, 254, 255]
    """

    def __init__(self, like: Costmap, mark_within: float = math.inf, clear_within: float = math.inf) -> None:
        self.map = like.like(UNKNOWN)
        self.mark_within, self.clear_within = mark_within, clear_within

    def see(self, origin: tuple[float, float], ends: np.ndarray, hits: np.ndarray, *, clearing: bool = True) -> None:
        """Process a scan from `origin`: the ends (n, 2) of its beams [m], and a mask of those that hit something."""
        grid = self.map
        if clearing:
            begin = (np.array(origin) - (grid.x, grid.y)) / grid.resolution
            reach = min(self.clear_within, 1e9) / grid.resolution
            clear(grid.cells, begin[0], begin[1], (ends - (grid.x, grid.y)) / grid.resolution, hits, reach)
        near = hits & (np.hypot(ends[:, 0] - origin[0], ends[:, 1] - origin[1]) <= self.mark_within)
        cells = np.floor((ends[near] - (grid.x, grid.y)) / grid.resolution).astype(np.int64)
        rows, columns = cells[:, 1], cells[:, 0]
        good = (rows >= 0) & (columns >= 0) & (rows < grid.cells.shape[0]) & (columns < grid.cells.shape[1])
        grid.cells[rows[good], columns[good]] = LETHAL

    def forget(self) -> None:
        """Set all cells to unknown."""
        self.map.cells[:] = UNKNOWN

    def forget_square(self, x: float, y: float, side: float, *, outside: bool = False) -> None:
        """Clear a square about a position, or with `outside` everything else.

        >>> layer = ObstacleLayer(Costmap.of_size(4.0, 1.0, 1.0))
        >>> layer.map.cells[:] = LETHAL
        >>> layer.forget_square(1.5, 0.5, 1.0)
        >>> layer.map.cells.tolist()
        [[254, 255, 255, 254]]
        """
        rows, columns = self._square(x, y, side)
        kept = self.map.cells[rows, columns].copy()
        if outside:
            self.forget()
            self.map.cells[rows, columns] = kept
        else:
            self.map.cells[rows, columns] = UNKNOWN

    def _square(self, x: float, y: float, side: float) -> tuple[slice, slice]:
        (top, left), (bottom, right) = self.map.cell(x - side / 2, y - side / 2), self.map.cell(x + side / 2, y + side / 2)
        return slice(max(top, 0), max(bottom + 1, 0)), slice(max(left, 0), max(right + 1, 0))

    def free(self, outline: np.ndarray) -> None:
        """Mark the inside of the robot's outline (n, 2) as free [m].

        >>> layer = ObstacleLayer(Costmap.of_size(3.0, 1.0, 1.0))
        >>> layer.free(np.array([[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0]]))
        >>> layer.map.cells.tolist()
        [[255, 0, 255]]
        """
        fill(self.map.cells, (outline - (self.map.x, self.map.y)) / self.map.resolution, FREE)


@njit(cache=True)
def clear(cells, x, y, ends, hits, most):  # type: ignore[no-untyped-def]
    """Free every cell along the beams, except the end of a hit; all lengths in cells."""
    rows, columns = cells.shape
    for k in range(len(ends)):
        dx, dy = ends[k, 0] - x, ends[k, 1] - y
        length = math.hypot(dx, dy)
        if length < 1e-9:
            continue
        dx, dy = dx / length, dy / length
        last_row, last_column = math.floor(ends[k, 1]), math.floor(ends[k, 0])
        j, i = math.floor(x), math.floor(y)
        step_x, step_y = (1 if dx > 0 else -1), (1 if dy > 0 else -1)
        next_x = ((j + (dx > 0)) - x) / dx if dx != 0 else np.inf
        next_y = ((i + (dy > 0)) - y) / dy if dy != 0 else np.inf
        gone, until = 0.0, min(length, most)
        while gone <= until:
            if hits[k] and i == last_row and j == last_column:
                break
            if 0 <= i < rows and 0 <= j < columns:
                cells[i, j] = FREE
            if next_x < next_y:
                gone, j = next_x, j + step_x
                next_x += abs(1.0 / dx)
            else:
                gone, i = next_y, i + step_y
                next_y += abs(1.0 / dy)


@njit(cache=True)
def fill(cells, outline, value):  # type: ignore[no-untyped-def]
    """Set the cells whose centre is inside a polygon (in cells).

    >>> cells = np.zeros((3, 3), np.uint8)
    >>> fill(cells, np.array([[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]]), 7)
    >>> cells.tolist()
    [[7, 7, 0], [7, 0, 0], [0, 0, 0]]
    """
    rows, columns = cells.shape
    low, high = max(math.floor(outline[:, 1].min()), 0), min(math.ceil(outline[:, 1].max()), rows)
    left, right = max(math.floor(outline[:, 0].min()), 0), min(math.ceil(outline[:, 0].max()), columns)
    for i in range(low, high):
        for j in range(left, right):
            x, y, within = j + 0.5, i + 0.5, False
            for k in range(len(outline)):
                ax, ay = outline[k - 1]
                bx, by = outline[k]
                if (ay > y) != (by > y) and x < (bx - ax) * (y - ay) / (by - ay) + ax:
                    within = not within
            if within:
                cells[i, j] = value
