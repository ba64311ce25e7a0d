"""The inner loops of `submap`."""

from __future__ import annotations

import math

import numpy as np
from numba import njit


@njit(cache=True)
def _merge(px, py, nx, ny, k, points, normals, weights):  # type: ignore[no-untyped-def]
    """Average a point into point k."""
    w = weights[k]
    step = 1.0 / (w + 1.0)
    points[k, 0] += (px - points[k, 0]) * step
    points[k, 1] += (py - points[k, 1]) * step
    mx, my = normals[k, 0] * w + nx, normals[k, 1] * w + ny
    length = math.sqrt(mx * mx + my * my)
    if length > 1e-9:
        normals[k, 0], normals[k, 1] = mx / length, my / length
    weights[k] = min(w + 1.0, 50.0)


@njit(cache=True)
def _raise_coarse(coarse, row, column, value):  # type: ignore[no-untyped-def]
    """Raise the block of a cell, and those to the left and below it, to its likelihood."""
    i, j = row // 4, column // 4
    for a in range(max(i - 1, 0), min(i + 1, coarse.shape[0])):
        for b in range(max(j - 1, 0), min(j + 1, coarse.shape[1])):
            if coarse[a, b] < value:
                coarse[a, b] = value


@njit(cache=True)
def _paint(px, py, k, points, nearest, likelihood, coarse, ox, oy, cell, reach, table):  # type: ignore[no-untyped-def]
    """Enter point k in the cells within reach."""
    steps = int(reach / cell) + 1
    column, row = int((px - ox) / cell), int((py - oy) / cell)
    scale = (len(table) - 1) / (reach * reach)
    for i in range(max(row - steps, 0), min(row + steps + 1, nearest.shape[0])):
        dy = oy + (i + 0.5) * cell - py
        for j in range(max(column - steps, 0), min(column + steps + 1, nearest.shape[1])):
            dx = ox + (j + 0.5) * cell - px
            d = dx * dx + dy * dy
            if d > reach * reach:
                continue
            other = nearest[i, j]
            if other >= 0:
                ex, ey = ox + (j + 0.5) * cell - points[other, 0], oy + (i + 0.5) * cell - points[other, 1]
                if ex * ex + ey * ey <= d:
                    continue
            nearest[i, j] = k
            value = table[int(d * scale)]
            if value > likelihood[i, j]:
                likelihood[i, j] = value
                _raise_coarse(coarse, i, j, value)


@njit(cache=True)
def insert_points(
    new,
    new_normals,
    points,
    normals,
    weights,
    count,
    nearest,
    likelihood,
    coarse,
    ox,
    oy,
    cell,
    reach,
    sigma,
    merge,
):  # type: ignore[no-untyped-def]
    """Merge or append points, and paint the appended ones; return the number of points."""
    table = np.empty(1025, dtype=np.uint8)
    for t in range(1025):
        table[t] = int(255.0 * math.exp(-0.5 * t / 1024.0 * reach * reach / (sigma * sigma)) + 0.5)
    for i in range(len(new)):
        px, py, nx, ny = new[i, 0], new[i, 1], new_normals[i, 0], new_normals[i, 1]
        k = nearest[int((py - oy) / cell), int((px - ox) / cell)]
        if k >= 0 and merge > 0.0:
            dx, dy = px - points[k, 0], py - points[k, 1]
            plain = (nx == 0.0 and ny == 0.0) or (normals[k, 0] == 0.0 and normals[k, 1] == 0.0)
            if dx * dx + dy * dy < merge * merge and (plain or nx * normals[k, 0] + ny * normals[k, 1] > 0.7):
                _merge(px, py, nx, ny, k, points, normals, weights)
                continue
        points[count, 0], points[count, 1] = px, py
        normals[count, 0], normals[count, 1] = nx, ny
        weights[count] = 1.0
        _paint(px, py, count, points, nearest, likelihood, coarse, ox, oy, cell, reach, table)
        count += 1
    return count
