"""Polygons: area, crossings, convex pieces."""

from __future__ import annotations

import numpy as np

from coursekit.geometry.plane import Array


def signed_area(points: Array) -> float:
    """Return the area of a polygon [m^2], negative when its corners are clockwise.

    >>> signed_area([(0, 0), (2, 0), (2, 1)])
    1.0
    """
    p = np.asarray(points, float)
    q = np.roll(p, -1, axis=0)
    return float((p[:, 0] * q[:, 1] - q[:, 0] * p[:, 1]).sum()) / 2


def crossing(points: Array) -> tuple[int, int] | None:
    """Return the first two edges that meet without being neighbours; None for a simple polygon.

    >>> crossing([(0, 0), (1, 1), (1, 0), (0, 1)])
    (0, 2)
    """
    p = np.asarray(points, float)
    q = np.roll(p, -1, axis=0)
    count = len(p)
    for i in range(count - 2):
        others = np.arange(i + 2, count if i else count - 1)
        if not len(others):
            continue
        a, b, c, d = p[i], q[i], p[others], q[others]
        across = _side(a, b, c) * _side(a, b, d) <= 0
        along = _side(c, d, a) * _side(c, d, b) <= 0
        near = (np.minimum(c, d) <= np.maximum(a, b)).all(axis=1) & (np.maximum(c, d) >= np.minimum(a, b)).all(axis=1)
        hit = others[across & along & near]
        if len(hit):
            return i, int(hit[0])
    return None


def _side(a: Array, b: Array, p: Array) -> Array:
    first, second = b - a, p - a
    return np.asarray(first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0])


def hull(points: Array) -> Array:
    """Return the convex hull of points, counter-clockwise.

    >>> hull([(0, 0), (2, 0), (1, 0.5), (1, 2)]).tolist()
    [[0.0, 0.0], [2.0, 0.0], [1.0, 2.0]]
    """
    rows = sorted({(float(x), float(y)) for x, y in points})
    if len(rows) < 3:
        return np.array(rows)
    chains = []
    for order in (rows, rows[::-1]):
        chain: list[tuple[float, float]] = []
        for point in order:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0:
                chain.pop()
            chain.append(point)
        chains.append(chain[:-1])
    return np.array(chains[0] + chains[1])


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


__all__ = ["crossing", "hull", "signed_area"]
