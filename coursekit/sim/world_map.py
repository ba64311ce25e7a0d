"""A world from an occupancy grid, such as a navigation map: occupied cells become walls."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursekit.geometry.plane import Pose2D

from .errors import WorldError
from .solids import Part, Prism
from .world import Thing, World

OCCUPIED = 65
"""Minimum value of wall cells."""
MOST_BLOCKS = 50_000


def world_from_grid(
    cells: NDArray[np.int8], resolution: float, origin: tuple[float, float, float] = (0.0, 0.0, 0.0),
    name: str = "map", file: str = "",
) -> World:  # fmt: skip
    """Return a world of the occupied cells; row 0 has the smallest y, `origin` is the pose of its corner. Raises WorldError.

    >>> import numpy as np
    >>> world = world_from_grid(np.array([[0, 100, 100]], np.int8), 0.5)
    >>> world.bounds()
    (0.5, 0.0, 1.5, 0.5)
    """
    grid = np.asarray(cells)
    if grid.ndim != 2 or not resolution > 0:
        raise WorldError("is no grid with cells of some size", file=file, cure="Give rows of cells and a resolution > 0.")
    blocks = _blocks(grid >= OCCUPIED)
    if len(blocks) > MOST_BLOCKS:
        raise WorldError(f"has {len(blocks)} blocks of walls", file=file, cure=f"At most {MOST_BLOCKS} can be simulated.")
    parts: list[Part] = [_prism(*block, resolution) for block in blocks]
    things = (Thing("map", tuple(parts), Pose2D(*origin), texture="concrete"),) if parts else ()
    return World(name, things, _free_place(grid, resolution, origin), file=file)


def _blocks(walls: NDArray[np.bool_]) -> list[tuple[int, int, int, int]]:
    """Return rectangles (row, column, end row, end column) that cover each true cell once."""
    open_: dict[tuple[int, int], int] = {}
    done = []
    for row in range(len(walls) + 1):
        runs = _runs(walls[row]) if row < len(walls) else []
        kept = set(runs)
        for run in [run for run in open_ if run not in kept]:
            done.append((open_.pop(run), run[0], row, run[1]))
        for run in runs:
            open_.setdefault(run, row)
    return done


def _runs(row: NDArray[np.bool_]) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate(([0], row.astype(np.int8), [0]))))
    return [(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def _prism(row: int, column: int, row_end: int, column_end: int, size: float) -> Prism:
    x0, y0, x1, y1 = column * size, row * size, column_end * size, row_end * size
    return Prism(((x0, y0), (x1, y0), (x1, y1), (x0, y1)), 0.0, 2.0)


def _free_place(grid: NDArray[np.int8], size: float, origin: tuple[float, float, float]) -> Pose2D:
    """Return roughly the free cell farthest from all other cells, as a start for robots."""
    free = grid == 0
    if not free.any():
        return Pose2D(*origin)
    depth = np.zeros(grid.shape, int)
    inner = free.copy()
    for _ in range(40):
        depth += inner
        shrunk = np.zeros_like(inner)
        shrunk[1:-1, 1:-1] = (
            inner[1:-1, 1:-1] & inner[:-2, 1:-1] & inner[2:, 1:-1] & inner[1:-1, :-2] & inner[1:-1, 2:]
        )
        if not shrunk.any():
            break
        inner = shrunk
    row, column = np.unravel_index(int(depth.argmax()), depth.shape)
    return Pose2D(*origin) @ Pose2D((float(column) + 0.5) * size, (float(row) + 0.5) * size)


__all__ = ["world_from_grid"]
