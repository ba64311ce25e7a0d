"""A figure: lines, points and cells in the plane, in their own units, with an alternative text."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

Point = tuple[float, float]
View = tuple[float, float, float, float]
"""The left, right, low and high end of the visible area."""
MOST_POINTS = 1500
"""The maximum number of points of a line or cloud; longer ones are thinned out."""
FARTHEST = 1e6
"""Points with a coordinate beyond this are not drawn."""


@dataclass(frozen=True)
class Line:
    """A line through points; `kind` is the name of its colour in `figure_style`."""

    points: Sequence[Sequence[float]]
    kind: str
    label: str = ""
    dashed: bool = False
    wide: bool = False


@dataclass(frozen=True)
class Dots:
    """A cloud of points of `radius` pixels."""

    points: Sequence[Sequence[float]]
    kind: str
    label: str = ""
    radius: float = 1.6


@dataclass(frozen=True)
class Cells:
    """A grid, row 0 at the low end: `codes` (rows, columns) are the indices of the cells' `kinds`."""

    codes: np.ndarray
    kinds: Sequence[str]
    labels: Sequence[str] = ()
    corner: Point = (0.0, 0.0)
    size: float = 1.0


@dataclass(frozen=True)
class Arrow:
    """The pose of a robot: a position and a heading [rad]."""

    x: float
    y: float
    heading: float
    kind: str
    label: str = ""


@dataclass(frozen=True)
class Words:
    """A short text at a position."""

    x: float
    y: float
    text: str
    kind: str = "ink"
    before: bool = False
    """Whether the text ends there; otherwise it begins there."""


@dataclass(frozen=True)
class Mover:
    """An object that moves to the next position at each tick, when the reader starts the motion."""

    places: Sequence[Point]
    kind: str


Shape = Line | Dots | Cells | Arrow | Words | Mover


@dataclass
class Panel:
    """One of the drawings of a figure.

    A plan has the same scale along both axes; a chart, which has names for its axes, fills its paper. `view` is the
    visible area, by default all of the content; `down` lets y grow downwards, as the rows of an array do.
    """

    shapes: list[Shape] = field(default_factory=list)
    title: str = ""
    view: View | None = None
    down: bool = False
    axes: tuple[str, str] | None = None
    """The names of a chart's axes; a vertical axis without a name has no numbers."""
    rings: list[Point] = field(default_factory=list)
    """The positions of faults."""


@dataclass
class Figure:
    """Panels side by side; `alt` describes them in words."""

    panels: list[Panel]
    alt: str


def drawable(points: Sequence[Sequence[float]]) -> list[Point]:
    """Return at most MOST_POINTS drawable points: non-finite and too distant ones are left out.

    >>> drawable([(0, 1), (math.nan, 2), (3, 1e300)])
    [(0.0, 1.0)]
    """
    step = max(1, math.ceil(len(points) / MOST_POINTS))
    kept = [*points[:-1:step], *points[-1:]]
    pairs = ((float(point[0]), float(point[1])) for point in kept)
    return [(x, y) for x, y in pairs if abs(x) < FARTHEST and abs(y) < FARTHEST]


def view_of(panel: Panel) -> View:
    """Return the visible area of a panel: its own view, or all of its content with a margin."""
    if panel.view is not None:
        return panel.view
    points = [point for shape in panel.shapes for point in _extent(shape)]
    xs, ys = ([point[axis] for point in points] or [0.0, 1.0] for axis in (0, 1))
    left, right, low, high = min(xs), max(xs), min(ys), max(ys)
    if panel.axes:
        return left, max(right, left + 1e-9), low - 0.06 * (high - low or 1.0), high + 0.06 * (high - low or 1.0)
    around = 0.0 if any(isinstance(shape, Cells) for shape in panel.shapes) else 0.06 * max(right - left, high - low, 1e-6)
    return left - around, right + around, low - around, high + around


def _extent(shape: Shape) -> Iterator[Point]:
    if isinstance(shape, Cells):
        (rows, columns), (x, y) = shape.codes.shape, shape.corner
        yield from ((x, y), (x + columns * shape.size, y + rows * shape.size))
    elif isinstance(shape, Mover):
        yield from drawable(shape.places)
    elif isinstance(shape, (Line, Dots)):
        yield from drawable(shape.points)
    else:
        yield from drawable([(shape.x, shape.y)])


__all__ = ["Arrow", "Cells", "Dots", "Figure", "Line", "Mover", "Panel", "Point", "Shape", "View", "Words"]
__all__ += ["drawable", "view_of"]
