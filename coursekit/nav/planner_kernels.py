"""The inner loops of the planner: A* on costs, and smoothing."""

from __future__ import annotations

import heapq
import math

import numpy as np
from numba import njit

NEUTRAL = 50.0
"""The cost of a cell without nearby obstacles, as in nav2's NavFn."""


@njit(cache=True)
def search(cells, start, goal, unknown, factor):  # type: ignore[no-untyped-def]
    """Return each cell's predecessor (-1 for unreached cells), and its cost; stop at the goal.

    Start and goal are flat indices. Cells from 253 on are blocked, except to leave such cells around the start.

    >>> parents, _ = search(np.zeros((1, 5), np.uint8), 0, 3, True, 0.8)
    >>> parents.tolist()
    [0, 0, 1, 2, -1]
    """
    rows, columns = cells.shape
    costs = np.full(rows * columns, np.inf)
    parents = np.full(rows * columns, -1, np.int32)
    done = np.zeros(rows * columns, np.bool_)
    goal_row, goal_column = goal // columns, goal % columns
    costs[start], parents[start] = 0.0, start
    heap = [(0.0, start)]
    while heap:
        _, at = heapq.heappop(heap)
        if done[at]:
            continue
        done[at] = True
        if at == goal:
            break
        i, j = at // columns, at % columns
        escaping = cells[i, j] >= 253 and cells[i, j] != 255
        for di in range(-1, 2):
            for dj in range(-1, 2):
                k, m = i + di, j + dj
                if (di == 0 and dj == 0) or k < 0 or m < 0 or k >= rows or m >= columns:
                    continue
                to, cost = k * columns + m, cells[k, m]
                if done[to] or (cost == 255 and not unknown) or cost == 254 or (cost == 253 and not escaping):
                    continue
                weight = NEUTRAL + factor * (cost if cost < 254 else 128.0)
                if cost == 253:
                    weight *= 10.0
                total = costs[at] + weight * math.hypot(di, dj)
                if total < costs[to]:
                    costs[to], parents[to] = total, at
                    dx, dy = abs(m - goal_column), abs(k - goal_row)
                    ahead = max(dx, dy) + 0.41421356 * min(dx, dy)
                    heapq.heappush(heap, (total + NEUTRAL * ahead, to))
    return parents, costs


@njit(cache=True)
def smooth(points, cells, x, y, resolution, rounds, keep, even):  # type: ignore[no-untyped-def]
    """Smooth a path in place, at most `rounds` times; no point moves to a cell with a higher cost than its own."""
    rows, columns = cells.shape
    original = points.copy()
    for _ in range(rounds):
        change = 0.0
        for k in range(1, len(points) - 1):
            px, py = points[k]
            nx = px + keep * (original[k, 0] - px) + even * (points[k - 1, 0] + points[k + 1, 0] - 2 * px)
            ny = py + keep * (original[k, 1] - py) + even * (points[k - 1, 1] + points[k + 1, 1] - 2 * py)
            i, j = math.floor((ny - y) / resolution), math.floor((nx - x) / resolution)
            a, b = math.floor((py - y) / resolution), math.floor((px - x) / resolution)
            if not (0 <= i < rows and 0 <= j < columns and 0 <= a < rows and 0 <= b < columns):
                continue
            if cells[i, j] > max(cells[a, b], 60):
                continue
            points[k] = nx, ny
            change += abs(nx - px) + abs(ny - py)
        if change < 1e-3 * len(points) * resolution:
            break
