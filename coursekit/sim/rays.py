"""Rays against edges and circles, compiled: each edge looks only at the beams between its ends.

All is in the sensor's frame: beam k points at `first + k * step`; `beams` (n, 2) holds its direction. What is nearer wins.
"""

from __future__ import annotations

import math

import numba
import numpy as np

from .place import Array

TURN = 2 * math.pi
SLACK = 1e-9
"""Beams this close [rad] to an edge's end are tried too."""
NARROW = 0.5
"""Between beams closer than this [rad] no edge can hide a half turn."""


@numba.njit(cache=True, inline="always")
def _meet(ranges, beams, k, area, dx, dy, nx, ny):  # type: ignore[no-untyped-def]
    """Shorten one beam by an edge; `nx`, `ny` is the edge's nearest point."""
    slope = beams[k, 0] * dy - beams[k, 1] * dx
    if area == 0.0:
        ranges[k] = min(ranges[k], math.sqrt(nx * nx + ny * ny))
    elif slope > 0.0 and area < ranges[k] * slope:
        ranges[k] = area / slope


@numba.njit(cache=True)
def _edge(ranges, beams, first, step, x1, y1, x2, y2, reach):  # type: ignore[no-untyped-def]
    """Shorten the beams that one edge stops."""
    dx, dy = x2 - x1, y2 - y1
    area = x1 * dy - y1 * dx
    length2 = dx * dx + dy * dy
    if length2 == 0.0:
        return
    share = -(x1 * dx + y1 * dy) / length2
    share = min(1.0, max(0.0, share))
    nx, ny = x1 + share * dx, y1 + share * dy
    if nx * nx + ny * ny > reach * reach:
        return
    if area * area <= 1e-18 * length2:  # seen end-on: it is as wide as a point
        x2, y2, dx, dy, area = nx, ny, 0.0, 0.0, 0.0
        x1, y1 = nx, ny
    if area < 0.0:  # so that it goes counter-clockwise as seen from the sensor
        x1, y1, x2, y2, dx, dy, area = x2, y2, x1, y1, -dx, -dy, -area
    low = math.atan2(y1, x1) - first
    low -= TURN * math.floor(low / TURN)
    k = max(0, math.ceil((low - SLACK) / step))
    if step < NARROW:  # one bearing will do: go on until a beam has passed the other end
        past = -SLACK * (abs(x2) + abs(y2))
        while k < len(ranges) and beams[k, 0] * y2 - beams[k, 1] * x2 >= past:
            _meet(ranges, beams, k, area, dx, dy, nx, ny)
            k += 1
        if k < len(ranges):
            return
    span = abs(math.atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2))
    for _turn in range(2):
        begin, end = math.ceil((low - SLACK) / step), math.floor((low + span + SLACK) / step)
        for j in range(max(0, begin), min(len(ranges) - 1, end) + 1):
            _meet(ranges, beams, j, area, dx, dy, nx, ny)
        low -= TURN


@numba.njit(cache=True)
def _circle(ranges, beams, first, step, x, y, radius, reach):  # type: ignore[no-untyped-def]
    """Shorten the beams that one circle stops; from inside, its far side does."""
    square = x * x + y * y
    inside = square <= radius * radius
    if not inside and math.sqrt(square) - radius > reach:
        return
    if inside:
        start, span = first, TURN
    else:
        half = math.asin(min(1.0, radius / math.sqrt(square)))
        start, span = math.atan2(y, x) - half, 2.0 * half
    low = start - first
    low -= TURN * math.floor(low / TURN)
    for _turn in range(2):
        begin = math.ceil((low - SLACK) / step)
        end = math.floor((low + span + SLACK) / step)
        for k in range(max(0, begin), min(len(ranges) - 1, end) + 1):
            along = beams[k, 0] * x + beams[k, 1] * y
            rest = radius * radius - (square - along * along)
            if rest >= 0.0:
                distance = along + math.sqrt(rest) if inside else along - math.sqrt(rest)
                if 0.0 <= distance < ranges[k]:
                    ranges[k] = distance
        low -= TURN


@numba.njit(cache=True)
def cast(ranges, beams, first, step, x, y, theta, edges, circles, reach):  # type: ignore[no-untyped-def]
    """Shorten `ranges` (n) by what a sensor at x, y, theta meets: edges (m, 4) and circles (m, 3) of the world."""
    c, s = math.cos(theta), math.sin(theta)
    for row in range(len(edges)):
        ax, ay = edges[row, 0] - x, edges[row, 1] - y
        bx, by = edges[row, 2] - x, edges[row, 3] - y
        _edge(
            ranges, beams, first, step, c * ax + s * ay, c * ay - s * ax, c * bx + s * by, c * by - s * bx, reach
        )
    for row in range(len(circles)):
        ax, ay = circles[row, 0] - x, circles[row, 1] - y
        _circle(ranges, beams, first, step, c * ax + s * ay, c * ay - s * ax, circles[row, 2], reach)


@numba.njit(cache=True)
def carry(edges, circles, owner_edges, owner_circles, places, out_edges, out_circles):  # type: ignore[no-untyped-def]
    """Edges and circles of moving bodies from their own frames to the world; `places` (n, 3) are x, y, theta."""
    for row in range(len(edges)):
        x, y, theta = places[owner_edges[row]]
        c, s = math.cos(theta), math.sin(theta)
        for end in (0, 2):
            out_edges[row, end] = x + c * edges[row, end] - s * edges[row, end + 1]
            out_edges[row, end + 1] = y + s * edges[row, end] + c * edges[row, end + 1]
    for row in range(len(circles)):
        x, y, theta = places[owner_circles[row]]
        c, s = math.cos(theta), math.sin(theta)
        out_circles[row, 0] = x + c * circles[row, 0] - s * circles[row, 1]
        out_circles[row, 1] = y + s * circles[row, 0] + c * circles[row, 1]
        out_circles[row, 2] = circles[row, 2]


def directions(first: float, step: float, count: int) -> Array:
    """The beams (n, 2) that `cast` wants."""
    angles = first + step * np.arange(count)
    return np.column_stack((np.cos(angles), np.sin(angles)))


__all__ = ["carry", "cast", "directions"]
