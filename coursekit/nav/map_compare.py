"""Map quality: a map's walls compared with the true ones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import distance_transform_edt
from scipy.spatial import cKDTree

from coursekit.nav.map_file import GridMap

WALL = 65
"""Cells above this value are walls."""
STEP = 0.01
"""Spacing of sample points on outlines [m]."""


@dataclass(frozen=True)
class Comparison:
    """A comparison of a map's walls with the truth, limited to what the map could know: cells beside free ones."""

    iou: float
    """Intersection over union: walls in both, as a part of the walls in either; 1 is perfect."""
    false: float
    """Part of the map's wall cells without a true wall."""
    missed: float
    """Part of the true walls that are missing in the map."""
    distance: float
    """Mean distance of the map's wall cells from the true walls [m]."""
    thickness: float
    """Thickness of the map's walls [m], at least one cell."""

    def __str__(self) -> str:
        return (
            f"walls: IoU {self.iou:.3f}, {self.false:.1%} false, {self.missed:.1%} missed, "
            f"{100 * self.distance:.1f} cm off, {100 * self.thickness:.1f} cm thick"
        )


def outline_points(edges: np.ndarray, circles: np.ndarray | None = None, step: float = STEP) -> np.ndarray:
    """Return points (n, 2) on edges (k, 4: x1 y1 x2 y2) and circles (m, 3: x y radius), about `step` apart [m].

    >>> outline_points(np.array([[0.0, 0.0, 1.0, 0.0]]), step=0.5)
    array([[0. , 0. ],
           [0.5, 0. ],
           [1. , 0. ]])
    """
    parts = [np.zeros((0, 2))]
    for x1, y1, x2, y2 in np.asarray(edges, dtype=np.float64).reshape(-1, 4):
        count = max(2, int(np.ceil(np.hypot(x2 - x1, y2 - y1) / step)) + 1)
        parts.append(np.linspace((x1, y1), (x2, y2), count))
    for x, y, radius in np.asarray([] if circles is None else circles, dtype=np.float64).reshape(-1, 3):
        angles = np.linspace(0, 2 * np.pi, max(8, int(np.ceil(2 * np.pi * radius / step))), endpoint=False)
        parts.append(np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles)], axis=1))
    return np.concatenate(parts)


def compare(grid: GridMap, outline: np.ndarray, tolerance: float = 0.05) -> Comparison:
    """Compare a map with the true outline, (n, 2) points in the map's frame [m]; walls within `tolerance` [m] match.

    >>> cells = np.zeros((40, 40), dtype=np.int8)
    >>> cells[20, 5:35] = 100
    >>> wall = outline_points(np.array([[0.25, 1.025, 1.75, 1.025]]))
    >>> print(compare(GridMap(cells, 0.05), wall))
    walls: IoU 1.000, 0.0% false, 0.0% missed, 0.5 cm off, 5.0 cm thick

    Raises:
        ValueError: when the map has no walls, or the outline is entirely outside of its known part.
    """
    walls, size = grid.cells > WALL, grid.resolution
    if not walls.any():
        raise ValueError("the map has no walls: has the robot seen any, and is the map the right way round?")
    visible = _visible(grid, outline)
    if not len(visible):
        raise ValueError("nothing of the outline is where the map knows the world: are both in one frame?")
    off = _off(grid, outline)
    truth = np.unique(_cells(grid, visible), axis=0)
    found = _found(grid, truth, tolerance)
    false = off > tolerance + size / 2
    hit, missed = int(found.sum()), int((~found).sum())
    length = len(np.unique((visible / STEP).round(), axis=0)) * STEP * hit / len(truth)
    return Comparison(
        iou=hit / (hit + missed + int(false.sum())),
        false=float(false.mean()),
        missed=missed / len(truth),
        distance=float(off.mean()),
        thickness=max(size, float((~false).sum()) * size**2 / max(length, size)),
    )


def differences(grid: GridMap, outline: np.ndarray, tolerance: float = 0.05) -> tuple[np.ndarray, np.ndarray]:
    """Return the differences to the truth: cells (n, 2: row, column) of false walls, and those of missing walls.

    >>> cells = np.zeros((40, 40), dtype=np.int8)
    >>> cells[20, 5:35] = cells[8, 8] = 100
    >>> wall = outline_points(np.array([[0.25, 1.025, 1.94, 1.025]]))
    >>> false, missed = differences(GridMap(cells, 0.05), wall)
    >>> false.tolist(), missed.tolist()
    ([[8, 8]], [[20, 36], [20, 37], [20, 38]])
    """
    walls = np.argwhere(grid.cells > WALL)
    false = walls[_off(grid, outline) > tolerance + grid.resolution / 2] if len(walls) else walls
    visible = _visible(grid, outline)
    truth = np.unique(_cells(grid, visible), axis=0)
    missed = truth[~_found(grid, truth, tolerance)] if len(walls) else truth
    return false, missed[:, ::-1]


def _off(grid: GridMap, outline: np.ndarray) -> np.ndarray:
    """Return the distance of each wall cell of the map from the true walls [m]."""
    rows, columns = np.nonzero(grid.cells > WALL)
    off: np.ndarray = cKDTree(outline).query(
        _turned(np.stack([columns + 0.5, rows + 0.5], axis=1) * grid.resolution, grid.origin)
    )[0]
    return off


def _found(grid: GridMap, truth: np.ndarray, tolerance: float) -> np.ndarray:
    """Return whether the map has a wall near each of these cells (n, 2: column, row) of true walls."""
    gap = distance_transform_edt(grid.cells <= WALL) * grid.resolution
    near: np.ndarray = gap[truth[:, 1], truth[:, 0]] <= tolerance + 1e-9
    return near


def _visible(grid: GridMap, outline: np.ndarray) -> np.ndarray:
    """Return the points of the outline with a free cell beside them."""
    free = (grid.cells >= 0) & (grid.cells <= WALL)
    at = _cells(grid, outline)
    inside = (at >= 0).all(axis=1) & (at[:, 0] < free.shape[1]) & (at[:, 1] < free.shape[0])
    near = distance_transform_edt(~free) <= 1.5
    inside[inside] = near[at[inside, 1], at[inside, 0]]
    return outline[inside]


def _cells(grid: GridMap, points: np.ndarray) -> np.ndarray:
    """Return (n, 2) column and row of points."""
    x, y, yaw = grid.origin
    c, s = np.cos(yaw), np.sin(yaw)
    moved = (points - (x, y)) @ np.array([[c, -s], [s, c]])
    cells: np.ndarray = np.floor(moved / grid.resolution).astype(int)
    return cells


def _turned(points: np.ndarray, origin: tuple[float, float, float]) -> np.ndarray:
    """Transform points from the map's corner frame to the map's frame."""
    x, y, yaw = origin
    c, s = np.cos(yaw), np.sin(yaw)
    turned: np.ndarray = points @ np.array([[c, s], [-s, c]]) + (x, y)
    return turned
