"""The inner loop of the controller: simulate every sampled pair of velocities, and score the trajectory."""

from __future__ import annotations

import math

import numpy as np
from numba import njit


@njit(cache=True)
def touches(cells, x0, y0, cell, x, y, yaw, outline, near):  # type: ignore[no-untyped-def]
    """Return the cost of the robot's centre at a pose; 255 where the robot would touch something.

    A centre cost of 253 or more touches; the points of an outline (m, 2) are checked where the centre costs at least `near`.
    Outside of the map nothing counts as an obstacle.
    """
    rows, columns = cells.shape
    i, j = math.floor((y - y0) / cell), math.floor((x - x0) / cell)
    if not (0 <= i < rows and 0 <= j < columns):
        return 0
    cost = cells[i, j]
    if cost == 255:
        return 0
    if cost >= 253:
        return 255
    if cost < near:
        return cost
    c, s = math.cos(yaw), math.sin(yaw)
    for k in range(len(outline)):
        i = math.floor((y + s * outline[k, 0] + c * outline[k, 1] - y0) / cell)
        j = math.floor((x + c * outline[k, 0] - s * outline[k, 1] - x0) / cell)
        if 0 <= i < rows and 0 <= j < columns and cells[i, j] == 254:
            return 255
    return cost


@njit(cache=True)
def solid(cells, x0, y0, cell, x, y):  # type: ignore[no-untyped-def]
    """Whether the cell at a position is an obstacle.

    >>> cells = np.zeros((4, 4), np.uint8)
    >>> cells[1, 2] = 254
    >>> solid(cells, 0.0, 0.0, 0.5, 1.2, 0.7), solid(cells, 0.0, 0.0, 0.5, 0.7, 1.2)
    (True, False)
    """
    rows, columns = cells.shape
    i, j = math.floor((y - y0) / cell), math.floor((x - x0) / cell)
    return 0 <= i < rows and 0 <= j < columns and cells[i, j] == 254


@njit(cache=True)
def gap_to(path, x, y):  # type: ignore[no-untyped-def]
    """Return the distance from a point to a path (n, 2).

    >>> gap_to(np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), 1.3, 0.4)
    0.5
    """
    least = np.inf
    for k in range(len(path)):
        d = (path[k, 0] - x) ** 2 + (path[k, 1] - y) ** 2
        if d < least:
            least = d
    return math.sqrt(least)


@njit(cache=True)
def score(cells, x0, y0, cell, outline, near, pose, speeds, turns, now, gains, horizon, dt, path, carrot, weights):  # type: ignore[no-untyped-def]
    """Return the penalty (speeds, turns) of each pair; infinite where it touches something within `horizon` seconds.

    `now` are the current velocities, `gains` their maximum changes per second; `weights` are those of the distance to the
    path, to the carrot, of both for a point ahead, of the worst cost, and the distance of that point ahead [m].
    A robot that already touches something may leave it, the sooner the better, but not drive into an obstacle itself.
    """
    score = np.full((len(speeds), len(turns)), np.inf)
    steps = max(round(horizon / dt), 1)
    held = touches(cells, x0, y0, cell, pose[0], pose[1], pose[2], outline, near) == 255
    for a in range(len(speeds)):
        for b in range(len(turns)):
            x, y, yaw, v, w, worst, free = pose[0], pose[1], pose[2], now[0], now[1], 0, True
            inside, late = held, 0
            for _ in range(steps):
                v += min(max(speeds[a] - v, -gains[0] * dt), gains[0] * dt)
                w += min(max(turns[b] - w, -gains[1] * dt), gains[1] * dt)
                x += v * math.cos(yaw + w * dt / 2) * dt
                y += v * math.sin(yaw + w * dt / 2) * dt
                yaw += w * dt
                cost = touches(cells, x0, y0, cell, x, y, yaw, outline, near)
                if cost == 255:
                    if not inside or solid(cells, x0, y0, cell, x, y):
                        free = False
                        break
                    late += 1
                else:
                    inside = False
                    worst = max(worst, cost)
            if not free or inside:
                continue
            ax, ay = x + weights[5] * math.cos(yaw), y + weights[5] * math.sin(yaw)
            score[a, b] = (
                weights[0] * gap_to(path, x, y)
                + weights[1] * math.hypot(carrot[0] - x, carrot[1] - y)
                + weights[2] * gap_to(path, ax, ay)
                + weights[3] * math.hypot(carrot[2] - ax, carrot[3] - ay)
                + weights[4] * worst
                + 5.0 * late
            )
    return score
