"""The inner loop of `grid`: every beam clears the cells that it crosses and marks the one where it ends."""

from __future__ import annotations

import math

import numpy as np
from numba import njit


@njit(cache=True)
def _cross(grid, x0, y0, x1, y1, miss, limit, last):  # type: ignore[no-untyped-def]
    """Add `miss` to the cells between two points in cell units (exact traversal); the last one only if `last`."""
    i, j = math.floor(y0), math.floor(x0)
    iend, jend = math.floor(y1), math.floor(x1)
    dx, dy = x1 - x0, y1 - y0
    sj, si = (1 if dx > 0 else -1), (1 if dy > 0 else -1)
    tx = (j + (dx > 0) - x0) / dx if dx != 0 else math.inf
    ty = (i + (dy > 0) - y0) / dy if dy != 0 else math.inf
    stepx = abs(1.0 / dx) if dx != 0 else math.inf
    stepy = abs(1.0 / dy) if dy != 0 else math.inf
    for _ in range(abs(iend - i) + abs(jend - j)):
        value = grid[i, j] + miss
        grid[i, j] = value if value > -limit else -limit
        if tx < ty:
            tx += stepx
            j += sj
        else:
            ty += stepy
            i += si
    if last:
        value = grid[iend, jend] + miss
        grid[iend, jend] = value if value > -limit else -limit


@njit(cache=True)
def update_grid(grid, hits, misses, cx, cy, ox, oy, resolution, hit, miss, limit):  # type: ignore[no-untyped-def]
    """Add one scan: `hits` and `misses` in metres, the laser at (cx, cy) from the grid's corner (ox, oy)."""
    x0, y0 = cx / resolution, cy / resolution
    for k in range(len(misses)):
        _cross(
            grid,
            x0,
            y0,
            (misses[k, 0] - ox) / resolution,
            (misses[k, 1] - oy) / resolution,
            miss,
            limit,
            True,
        )
    for k in range(len(hits)):
        x1, y1 = (hits[k, 0] - ox) / resolution, (hits[k, 1] - oy) / resolution
        _cross(grid, x0, y0, x1, y1, miss, limit, False)
    for k in range(len(hits)):
        i, j = math.floor((hits[k, 1] - oy) / resolution), math.floor((hits[k, 0] - ox) / resolution)
        value = grid[i, j] + hit
        grid[i, j] = value if value < limit else np.float32(limit)
