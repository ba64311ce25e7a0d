"""The inner loops of `scan`."""

from __future__ import annotations

import math

import numpy as np
from numba import njit


@njit(cache=True)
def _spread(points, first, last, out):  # type: ignore[no-untyped-def]
    """Direction across points[first..last] into `out`; True when they lie on a line."""
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
def normals_of(points, distances, reach):  # type: ignore[no-untyped-def]
    """Unit normals (n, 2) of points in order of bearing, from the neighbours within `reach` [m]; zero where unclear."""
    count = len(points)
    normals = np.zeros((count, 2))
    for i in range(count):
        near = reach + 0.02 * distances[i]
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
def thin(points, wanted, spacing):  # type: ignore[no-untyped-def]
    """Indices of the wanted points that are at least `spacing` [m] from the one kept before."""
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
def bearing_table(bearings, bins):  # type: ignore[no-untyped-def]
    """For each of `bins` directions from -pi the number of points before it, and the total at the end."""
    table = np.zeros(bins + 1, dtype=np.int32)
    for i in range(len(bearings)):
        k = int((bearings[i] + math.pi) / (2 * math.pi) * bins)
        table[min(max(k, 0), bins - 1) + 1] += 1
    for k in range(bins):
        table[k + 1] += table[k]
    return table
