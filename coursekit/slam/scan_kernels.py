"""The inner loops of `scan`."""

from __future__ import annotations

import math

import numpy as np
from numba import njit


@njit(cache=True)
def _spread(points, first, last, out):  # type: ignore[no-untyped-def]
    """Compute the normal of points[first..last] into `out`; True when they are on a line."""
    count = last - first + 1
    mx = my = 0.0
    for k in range(first, last + 1):
        mx += points[k, 0]
        my += points[k, 1]
    mx /= count
    my /= count
    xx = xy = yy = 0.0
    for k in range(first, last + 1):
        dx, dy = points[k, 0] - mx, points[k, 1] - my
        xx += dx * dx
        xy += dx * dy
        yy += dy * dy
    middle, root = 0.5 * (xx + yy), math.sqrt(0.25 * (xx - yy) ** 2 + xy * xy)
    if middle + root <= 0.0 or middle - root > 0.05 * (middle + root):
        return False
    angle = 0.5 * math.atan2(2.0 * xy, xx - yy)
    out[0], out[1] = -math.sin(angle), math.cos(angle)
    return True


@njit(cache=True)
def normals_of(points, distances, reach, slope):  # type: ignore[no-untyped-def]
    """Return unit normals (n, 2) of points in order of bearing, zero where there is no clear wall.

    They are computed from the neighbours within `reach` [m] + `slope` * distance.

    >>> wall = np.column_stack([np.full(9, 2.0), np.linspace(-0.4, 0.4, 9)])  # across the robot's way
    >>> np.abs(normals_of(wall, np.hypot(*wall.T), 0.3, 0.02)[4]).round(3).tolist()
    [1.0, 0.0]
    """
    count = len(points)
    normals = np.zeros((count, 2))
    for i in range(count):
        near = reach + slope * distances[i]
        first = last = i
        while first > 0 and i - first < 12:
            dx, dy = points[first - 1, 0] - points[i, 0], points[first - 1, 1] - points[i, 1]
            if dx * dx + dy * dy > near * near:
                break
            first -= 1
        while last < count - 1 and last - i < 12:
            dx, dy = points[last + 1, 0] - points[i, 0], points[last + 1, 1] - points[i, 1]
            if dx * dx + dy * dy > near * near:
                break
            last += 1
        if last - first >= 3:
            _spread(points, first, last, normals[i])
    return normals


@njit(cache=True)
def usual_gap(bearings):  # type: ignore[no-untyped-def]
    """Return the median gap between neighbours of sorted bearings [rad]; 0 for fewer than two.

    >>> round(usual_gap(np.array([0.0, 0.1, 0.2, 1.0])), 6)
    0.1
    """
    return np.median(np.diff(bearings)) if len(bearings) > 1 else 0.0


@njit(cache=True)
def thin(points, wanted, spacing):  # type: ignore[no-untyped-def]
    """Return the indices of the wanted points that are at least `spacing` [m] from the previous one kept.

    >>> points = np.array([[0.0, 0.0], [0.02, 0.0], [0.06, 0.0], [0.07, 0.0]])
    >>> thin(points, np.array([True, True, True, True]), 0.05).tolist()
    [0, 2]
    """
    keep = np.empty(len(points), dtype=np.int64)
    count = 0
    for i in range(len(points)):
        if not wanted[i]:
            continue
        if count:
            last = keep[count - 1]
            dx, dy = points[i, 0] - points[last, 0], points[i, 1] - points[last, 1]
            if dx * dx + dy * dy < spacing * spacing:
                continue
        keep[count] = i
        count += 1
    return keep[:count].copy()


@njit(cache=True)
def fill_walls(points, normals, spacing, widest):  # type: ignore[no-untyped-def]
    """Fill gaps between neighbours on one wall that are farther apart than `spacing` [m], up to `widest`.

    >>> ends, facing = np.array([[0.0, 1.0], [0.2, 1.0]]), np.array([[0.0, -1.0], [0.0, -1.0]])
    >>> fill_walls(ends, facing, 0.05, 0.5)[0].round(3).tolist()
    [[0.05, 1.0], [0.1, 1.0], [0.15, 1.0]]
    """
    room = int(widest / spacing) + 2
    filled, directions = np.empty((len(points) * room, 2)), np.empty((len(points) * room, 2))
    count = 0
    for i in range(len(points) - 1):
        dx, dy = points[i + 1, 0] - points[i, 0], points[i + 1, 1] - points[i, 1]
        gap = math.sqrt(dx * dx + dy * dy)
        if gap < 1.5 * spacing or gap > widest:
            continue
        ax, ay, bx, by = normals[i, 0], normals[i, 1], normals[i + 1, 0], normals[i + 1, 1]
        if (
            ax * bx + ay * by < 0.9
            or abs(ax * dx + ay * dy) > 0.2 * gap
            or abs(bx * dx + by * dy) > 0.2 * gap
        ):
            continue
        steps = int(gap / spacing + 0.5)
        for k in range(1, steps):
            filled[count, 0], filled[count, 1] = points[i, 0] + dx * k / steps, points[i, 1] + dy * k / steps
            directions[count, 0], directions[count, 1] = ax, ay
            count += 1
    return filled[:count].copy(), directions[:count].copy()
