"""Paper that turtles draw on: strokes for sharp images, and pixels for colour sensors."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import cv2
import numpy as np

Colour = tuple[int, int, int]
Point = tuple[float, float]

PIXELS_PER_METRE = 45
_SHIFT = 4
"""Fractional bits of the coordinates for OpenCV."""
_LONGEST = 0.08
"""Maximum segment length of a drawn curve [m]: accurate to a thousandth on a circle of 1 m."""
_BEND = math.radians(2.0)


@dataclass
class Stroke:
    """A polyline in one colour and width, drawn without lifting the pen."""

    by: str
    colour: Colour
    width: int
    points: list[Point] = field(default_factory=list)

    def extend(self, to: Point) -> None:
        """Extend the line to a point; the last point moves along while the line stays straight or short.

        >>> stroke = Stroke("turtle1", (0, 0, 0), 3, [(0.0, 0.0)])
        >>> for point in ((1.0, 0.0), (2.0, 0.0), (2.0, 1.0)):
        ...     stroke.extend(point)
        >>> stroke.points
        [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0)]
        """
        if len(self.points) > 1 and self._straight(to):
            self.points[-1] = to
        else:
            self.points.append(to)

    def _straight(self, to: Point) -> bool:
        corner, tip = self.points[-2], self.points[-1]
        first = math.atan2(tip[1] - corner[1], tip[0] - corner[0])
        then = math.atan2(to[1] - tip[1], to[0] - tip[0])
        bend = abs(math.remainder(then - first, 2 * math.pi))
        return bend < 1e-6 or (bend < _BEND and math.dist(corner, to) < _LONGEST)


class Paper:
    """A square sheet of `side` metres.

    >>> paper = Paper(2.0)
    >>> paper.line("turtle1", (0.5, 1.0), (1.5, 1.0), (255, 0, 0), 3)
    >>> paper.colour_at(1.0, 1.0), paper.colour_at(1.0, 1.5)
    ((255, 0, 0), (255, 255, 255))
    """

    def __init__(self, side: float) -> None:
        self.side = side
        size = round(side * PIXELS_PER_METRE) + 1
        self.pixels = np.full((size, size, 3), 255, np.uint8)
        self.strokes: list[Stroke] = []
        self.edition = 0
        """Number of the sheet: copies of the strokes must start anew when it changes."""
        self._current: dict[str, Stroke] = {}

    def clear(self) -> None:
        """Start a new sheet."""
        self.pixels[:] = 255
        self.strokes = []
        self._current = {}
        self.edition += 1

    def line(self, by: str, start: Point, end: Point, colour: Colour, width: int) -> None:
        """Draw a straight line; one that starts where `by` ended extends the same stroke."""
        stroke = self._current.get(by)
        if stroke is None or (stroke.points[-1], stroke.colour, stroke.width) != (start, colour, width):
            stroke = Stroke(by, colour, width, [start])
            self.strokes.append(stroke)
            self._current[by] = stroke
        stroke.extend(end)
        cv2.line(self.pixels, self._pixel(start), self._pixel(end), colour, max(1, width), cv2.LINE_8, _SHIFT)

    def colour_at(self, x: float, y: float) -> Colour:
        """Return red, green and blue at a point; white where nothing is drawn."""
        last = self.pixels.shape[0] - 1
        column = min(max(round(x * PIXELS_PER_METRE), 0), last)
        row = min(max(round((self.side - y) * PIXELS_PER_METRE), 0), last)
        red, green, blue = self.pixels[row, column]
        return int(red), int(green), int(blue)

    def _pixel(self, point: Point) -> tuple[int, int]:
        scale = PIXELS_PER_METRE * (1 << _SHIFT)
        return round(point[0] * scale), round((self.side - point[1]) * scale)
