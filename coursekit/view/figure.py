"""A figure: lines, points and cells in the plane, in their own units, with a text for those who do not see it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

Point = tuple[float, float]
View = tuple[float, float, float, float]
"""Left, right, low and high end of what is shown."""
MOST_POINTS = 1500
"""Of a line or a cloud; of longer ones every so-manieth is drawn."""
FARTHEST = 1e6
"""Things that lie further from the middle are not drawn."""


@dataclass(frozen=True)
class Line:
    """A line through points; `kind` is its colour's name in `figure_style`."""

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
    """A grid, row 0 at the low end: `codes` (rows, columns) says which of `kinds` each cell is."""

    codes: np.ndarray
    kinds: Sequence[str]
    labels: Sequence[str] = ()
    corner: Point = (0.0, 0.0)
    size: float = 1.0


@dataclass(frozen=True)
class Arrow:
    """A place and a heading [rad]: a robot."""

    x: float
    y: float
    heading: float
    kind: str
    label: str = ""


@dataclass(frozen=True)
class Words:
    """A word or two at a place."""

    x: float
    y: float
    text: str
    kind: str = "ink"
    before: bool = False
    """Whether the words end there; otherwise they begin there."""


@dataclass(frozen=True)
class Mover:
    """Something that goes from place to place, one each tick, when the reader wants to see it move."""

    places: Sequence[Point]
    kind: str


Shape = Line | Dots | Cells | Arrow | Words | Mover


@dataclass
class Panel:
    """One of the drawings of a figure.

    A plan has the same scale along both axes; a chart, which has names for its axes, fills its paper. `view` is what is
    shown, by itself all that is drawn; `down` lets y grow downwards, as the rows of an array do.
    """

    shapes: list[Shape] = field(default_factory=list)
    title: str = ""
    view: View | None = None
    down: bool = False
    axes: tuple[str, str] | None = None
    """The names of a chart's axes; an upright one without a name has no numbers."""
    rings: list[Point] = field(default_factory=list)
    """Where something is wrong."""


@dataclass
class Figure:
    """Panels side by side; `alt` says in words what they show."""

    panels: list[Panel]
    alt: str


def drawable(points: Sequence[Sequence[float]]) -> list[Point]:
    """The points that can be drawn, at most MOST_POINTS: those that are not finite, or nowhere, are left out.

    >>> drawable([(0, 1), (math.nan, 2), (3, 1e300)])
    [(0.0, 1.0)]
    """
    step = max(1, math.ceil(len(points) / MOST_POINTS))
    kept = [*points[:-1:step], *points[-1:]]
    pairs = ((float(one[0]), float(one[1])) for one in kept)
    return [(x, y) for x, y in pairs if abs(x) < FARTHEST and abs(y) < FARTHEST]


def view_of(panel: Panel) -> View:
    """The part that a panel shows: its own view, or all of its content, with some room around."""
    if panel.view is not None:
        return panel.view
    found = [point for shape in panel.shapes for point in _extent(shape)]
    xs, ys = ([one[axis] for one in found] or [0.0, 1.0] for axis in (0, 1))
    left, right, low, high = min(xs), max(xs), min(ys), max(ys)
    if panel.axes:
        return left, max(right, left + 1e-9), low - 0.06 * (high - low or 1.0), high + 0.06 * (high - low or 1.0)
    around = 0.0 if any(isinstance(one, Cells) for one in panel.shapes) else 0.06 * max(right - left, high - low, 1e-6)
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
