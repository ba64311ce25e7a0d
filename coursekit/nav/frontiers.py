"""Frontiers: the borders between reachable free space and unknown space."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
from scipy import ndimage

from coursekit.nav.map_file import GridMap

Array = npt.NDArray[np.float64]
FREE, UNKNOWN = 0, -1
_BESIDE = ndimage.generate_binary_structure(2, 1)
_AROUND = ndimage.generate_binary_structure(2, 2)


@dataclass(frozen=True)
class Frontier:
    """A cluster of unknown cells: their centres (n, 2), centroid, nearest centre and its distance [m], and their cost."""

    points: Array
    centroid: tuple[float, float]
    nearest: tuple[float, float]
    distance: float
    cost: float


def frontiers(
    grid: GridMap, robot: tuple[float, float], least: float, potential_scale: float = 1e-3, gain_scale: float = 1.0
) -> list[Frontier]:
    """Return the frontiers of at least `least` metres reachable from the robot, cheapest first: near and long ones.

    ValueError when the robot is not on the map. The map must not be rotated.

    >>> grid = GridMap(np.full((20, 20), UNKNOWN, np.int8), 0.5)
    >>> grid.cells[:, :12] = FREE  # the map ends at x = 6 m
    >>> found = frontiers(grid, (1.0, 5.0), least=1.0)
    >>> len(found), found[0].centroid, round(found[0].distance, 2)
    (1, (6.25, 5.0), 5.26)
    """
    cell = _cell_of(grid, robot)
    free, unknown = grid.cells == FREE, grid.cells == UNKNOWN
    if not free.any():
        return []
    edge = unknown & ndimage.binary_dilation(free, _BESIDE)
    reached = ndimage.binary_dilation(_area_of(free, cell), _BESIDE)
    labels, _ = ndimage.label(edge, _AROUND)
    reachable = []
    for label in np.unique(labels[reached & edge]):
        rows, columns = np.nonzero(labels == label)
        if len(rows) * grid.resolution >= least:
            reachable.append(_made(grid, rows, columns, robot, potential_scale, gain_scale))
    return sorted(reachable, key=lambda frontier: frontier.cost)


def _cell_of(grid: GridMap, robot: tuple[float, float]) -> tuple[int, int]:
    column, row = (int((robot[k] - grid.origin[k]) // grid.resolution) for k in (0, 1))
    height, width = grid.cells.shape
    if not (0 <= row < height and 0 <= column < width):
        raise ValueError("Robot out of costmap bounds, cannot search for frontiers")
    return row, column


def _area_of(free: npt.NDArray[np.bool_], cell: tuple[int, int]) -> npt.NDArray[np.bool_]:
    """Return the connected area of free cells nearest to the robot."""
    areas, _ = ndimage.label(free, _BESIDE)
    nearest = ndimage.distance_transform_edt(~free, return_distances=False, return_indices=True)
    row, column = nearest[:, cell[0], cell[1]]
    home: npt.NDArray[np.bool_] = areas == areas[row, column]
    return home


def _made(grid: GridMap, rows: Any, columns: Any, robot: tuple[float, float], potential: float, gain: float) -> Frontier:
    points = np.column_stack([columns + 0.5, rows + 0.5]) * grid.resolution + grid.origin[:2]
    away = np.hypot(*(points - robot).T)
    nearest, distance = points[int(away.argmin())], float(away.min())
    x, y = points.mean(axis=0)
    cost = (potential * distance - gain * len(points)) * grid.resolution
    return Frontier(points, (float(x), float(y)), (float(nearest[0]), float(nearest[1])), distance, cost)
