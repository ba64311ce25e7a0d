"""The inner loop of `grid`: every beam clears the cells that it crosses and marks the cell at its end."""

from __future__ import annotations

import math

import numpy as np
from numba import njit


@njit(cache=True)
def _clear(grid, marks, width, number, x0, y0, x1, y1, miss, limit):  # type: ignore[no-untyped-def]
    """Add `miss` to the cells between two points in cell units, once per scan; one sample for each row or column crossed.

    Positions are integers in units of 2^-32 cells: no rounding, no branches.
    """
    steps = math.ceil(max(abs(x1 - x0), abs(y1 - y0)))
    if steps == 0:
        return
    dx, dy = int((x1 - x0) / steps * 4294967296.0), int((y1 - y0) / steps * 4294967296.0)
    fx, fy = int(x0 * 4294967296.0) + (dx >> 1), int(y0 * 4294967296.0) + (dy >> 1)
    for _ in range(steps):
        cell = np.uint64((fy >> 32) * width + (fx >> 32))
        if marks[cell] != number:
            marks[cell] = number
            grid[cell] = max(grid[cell] + miss, -limit)
        fx += dx
        fy += dy


@njit(cache=True)
def update_grid(grid, marks, width, number, hits, misses, cx, cy, ox, oy, resolution, hit, miss, limit):  # type: ignore[no-untyped-def]
    """Add one scan: `hits` and `misses` in metres, the laser at (cx, cy), the grid's corner at (ox, oy).

    The grid is passed as one long row. A cell changes at most once per scan, and a hit takes precedence over beams that
    graze the cell; `marks` stores, by the scan's `number`, which cells were already updated.
    """
    x0, y0 = (cx - ox) / resolution, (cy - oy) / resolution
    for k in range(len(hits)):
        cell = math.floor((hits[k, 1] - oy) / resolution) * width + math.floor((hits[k, 0] - ox) / resolution)
        if marks[cell] != number:
            marks[cell] = number
            grid[cell] = min(grid[cell] + hit, limit)
    for points in (hits, misses):
        for k in range(len(points)):
            x1, y1 = (points[k, 0] - ox) / resolution, (points[k, 1] - oy) / resolution
            _clear(grid, marks, width, number, x0, y0, x1, y1, miss, limit)


@njit(cache=True)
def place(points, x, y, theta, limit, bounds):  # type: ignore[no-untyped-def]
    """Transform points from a pose, without those farther than `limit`; widens `bounds` (low x, low y, high x, high y)."""
    c, s, count = math.cos(theta), math.sin(theta), 0
    out = np.empty((len(points), 2))
    for k in range(len(points)):
        px, py = points[k, 0], points[k, 1]
        if abs(px) > limit or abs(py) > limit:
            continue
        wx, wy = x + c * px - s * py, y + s * px + c * py
        out[count, 0], out[count, 1] = wx, wy
        count += 1
        bounds[0], bounds[1] = min(bounds[0], wx), min(bounds[1], wy)
        bounds[2], bounds[3] = max(bounds[2], wx), max(bounds[3], wy)
    return out[:count]
