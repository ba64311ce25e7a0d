"""The track of a turtle on turtlesim's paper."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from coursekit.view.figure import Arrow, Dots, Figure, Line, Panel, Shape, View

PAPER = 11.088889
"""The width of the paper [m]."""


def walked(way: Sequence[Sequence[float]], goal: View | None = None) -> Figure:
    """Draw a turtle's track of x, y [m] and heading [rad]; `goal` is the target area: left, right, low, high."""
    shapes: list[Shape] = []
    if goal:
        left, right, low, high = goal
        around = [(left, low), (right, low), (right, high), (left, high), (left, low)]
        shapes.append(Line(around, "truth", "where it is to end", dashed=True))
    x, y, heading = way[-1]
    shapes += [Line(way, "own", "its line", wide=True), Dots(way[:1], "ink", "its start", 4.0)]
    shapes.append(Arrow(x, y, heading, "own", "its end"))
    length = sum(math.dist(a[:2], b[:2]) for a, b in pairwise(way))
    began = f"({way[0][0]:.1f}, {way[0][1]:.1f})"
    alt = f"The turtle's line on its paper, {length:.1f} m long, from {began} to ({x:.1f}, {y:.1f})."
    return Figure([Panel(shapes, view=(0.0, PAPER, 0.0, PAPER))], alt)


__all__ = ["PAPER", "walked"]
