"""The elements of a world file, each built from its keys."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from coursekit.geometry.plane import Pose2D

from .errors import WorldError, known
from .outlines import crossing, signed_area
from .solids import Disc, Part, Prism
from .world import TEXTURES, Hinge, Thing

FARTHEST = 1e5
"""Maximum distance from the origin [m]; a larger one is a typing error."""
COLOURS = {
    "red": (0.8, 0.15, 0.12), "orange": (0.95, 0.5, 0.1), "yellow": (0.95, 0.85, 0.2), "green": (0.2, 0.6, 0.25),
    "blue": (0.15, 0.35, 0.8), "violet": (0.5, 0.25, 0.7), "white": (0.95, 0.95, 0.95), "grey": (0.6, 0.6, 0.6),
    "black": (0.1, 0.1, 0.1), "brown": (0.5, 0.35, 0.2),
}  # fmt: skip


class Fields:
    """The keys of one element; keys that were never read are unknown.

    >>> fields = Fields({"radius": 0.1, "colour": "red"}, "circle 'post'", "yard.yaml", 3)
    >>> fields.number("radius"), fields.number("height", 2.0)
    (0.1, 2.0)
    >>> print(fields.fault("stands in a wall"))
    yard.yaml:3: circle 'post': stands in a wall
    """

    def __init__(self, data: Mapping[str, Any], element: str, file: str, line: int) -> None:
        self.data, self.element, self.file, self.line = data, element, file, line
        self.used: set[str] = {"name"}

    def fault(self, what: str, cure: str = "") -> WorldError:
        """Return an error about this element, to be raised."""
        return WorldError(what, file=self.file, line=self.line, element=self.element, cure=cure)

    def _get(self, key: str, default: Any) -> Any:
        self.used.add(key)
        if key not in self.data and default is None:
            raise self.fault(f"has no '{key}'", f"Add {key}: ... to it.")
        return self.data.get(key, default)

    def number(self, key: str, default: float | None = None, least: float = -FARTHEST, most: float = FARTHEST) -> float:
        """Return a number within bounds."""
        return self._number(key, self._get(key, default), least, most)

    def _number(self, key: str, value: Any, least: float = -FARTHEST, most: float = FARTHEST) -> float:
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not least <= value <= most:
            raise self.fault(f"'{key}' is {value!r}", f"Give a number from {least:g} to {most:g}.")
        return float(value)

    def numbers(self, key: str, default: Sequence[float] | None, counts: Sequence[int]) -> list[float]:
        """Return a list with one of these lengths."""
        value = self._get(key, default)
        if not isinstance(value, (list, tuple)) or len(value) not in counts:
            raise self.fault(f"'{key}' is {value!r}", f"Give a list of {' or '.join(map(str, counts))} numbers.")
        return [self._number(key, number) for number in value]

    def points(self, key: str, least: int) -> np.ndarray:
        """Return a list of [x, y] with at least so many points; a repeated first point at the end is dropped.

        >>> Fields({"points": [[0, 0], [1, 0], [1, 1], [0, 0]]}, "", "", 0).points("points", 3).tolist()
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]
        """
        rows = self._get(key, None)
        if not isinstance(rows, list) or any(not isinstance(row, list) or len(row) != 2 for row in rows):
            raise self.fault(f"'{key}' is no list of points", "Write [[x, y], [x, y], ...].")
        if len(rows) > 1 and rows[0] == rows[-1]:
            rows = rows[:-1]
        if len(rows) < least:
            raise self.fault(f"has {len(rows)} different points; it needs at least {least}", "Add the missing corners.")
        return np.array([[self._number(key, number) for number in row] for row in rows])

    def word(self, key: str, default: str | None = None, of: Sequence[str] = ()) -> str:
        """Return a word, optionally one of a set."""
        value = self._get(key, default)
        if not isinstance(value, (str, int)) or (of and value not in of):
            raise self.fault(f"'{key}' is {value!r}", known(str(value), of) if of else "Give a word.")
        return str(value)

    def flag(self, key: str, default: bool) -> bool:
        """Return true or false."""
        value = self._get(key, default)
        if not isinstance(value, bool):
            raise self.fault(f"'{key}' is {value!r}", "Write true or false.")
        return value

    def span(self, height: float) -> tuple[float, float]:
        """Return the lower and upper height above the floor."""
        low = self.number("bottom", 0.0)
        return low, low + self.number("height", height, 1e-3)

    def finish(self) -> None:
        """Check that all keys were used.

        >>> fields = Fields({"radios": 0.1}, "circle 'post'", "yard.yaml", 3)
        >>> fields.number("radius", 0.5)
        0.5
        >>> fields.finish()
        Traceback (most recent call last):
        coursekit.sim.errors.WorldError: yard.yaml:3: circle 'post': unknown key 'radios'
        Did you mean 'radius'?
        """
        for key in self.data:
            if key not in self.used:
                raise self.fault(f"unknown key '{key}'", known(key, self.used))

    def thing(self, parts: Sequence[Part], texture: str, place: Pose2D = Pose2D(), **more: Any) -> Thing:
        """Return an object with the element's colour and texture."""
        colour = self.data.get("colour")
        self.used.add("colour")
        if colour is not None:
            colour = COLOURS[self.word("colour", None, list(COLOURS))] if isinstance(colour, str) else tuple(
                self.numbers("colour", None, (3,)))  # fmt: skip
        return Thing("", tuple(parts), place, texture=self.word("texture", texture, TEXTURES), colour=colour, **more)


def wall(fields: Fields) -> Thing:
    """A chain of walls; with a thickness each segment is a block, and blocks overlap at corners.

    >>> fence = wall(Fields({"points": [[0, 0], [4, 0], [4, 3]], "closed": True, "thickness": 0.1}, "wall", "", 0))
    >>> len(fence.parts)  # a block for each side
    3
    """
    points, closed = fields.points("points", 2), fields.flag("closed", False)
    low, high = fields.span(2.0)
    thickness = fields.number("thickness", 0.1, 0.0, 100.0)
    if closed and len(points) < 3:
        raise fields.fault("a closed wall needs at least 3 points", "Add corners, or write closed: false.")
    if not thickness:
        return fields.thing([Prism(_corners(points), low, high, closed)], "concrete")
    ends = np.roll(points, -1, axis=0)
    pairs = list(zip(points, ends, strict=True))[: None if closed else -1]
    return fields.thing([_stretch(fields, a, b, thickness, low, high) for a, b in pairs], "concrete")


def _stretch(fields: Fields, a: np.ndarray, b: np.ndarray, thickness: float, low: float, high: float) -> Prism:
    length = float(np.hypot(*(b - a)))
    if not length:
        raise fields.fault(f"has the point {a.tolist()} twice in a row", "Remove one of them.")
    along = (b - a) / length * thickness / 2
    side = np.array([-along[1], along[0]])
    return Prism(_corners(np.array([a - along - side, b + along - side, b + along + side, a - along + side])), low, high)


def polygon(fields: Fields) -> Thing:
    """A polygon that does not cross itself; movable if it has a mass."""
    points = fields.points("points", 3)
    low, high = fields.span(1.0)
    cross = crossing(points)
    if cross is not None:
        a, b = cross
        raise fields.fault(f"crosses itself: edge {a + 1} meets edge {b + 1}", "Give the corners in order, round it.")
    if abs(signed_area(points)) < 1e-9:
        raise fields.fault("has no area: it is open, or a line", "Give corners round it; use 'walls' for a line.")
    centre = points.mean(axis=0)
    place = Pose2D(float(centre[0]), float(centre[1]))
    return fields.thing([Prism(_corners(points - centre), low, high)], "plain", place, **_weight(fields))


def circle(fields: Fields) -> Thing:
    """An upright cylinder; movable if it has a mass."""
    x, y = fields.numbers("center", None, (2,))
    low, high = fields.span(1.0)
    radius = fields.number("radius", None, 1e-3)
    return fields.thing([Disc(0.0, 0.0, radius, low, high)], "plain", Pose2D(x, y), **_weight(fields))


def box(fields: Fields) -> Thing:
    """A block; movable if it has a mass.

    >>> crate = box(Fields({"center": [2, 2], "size": [0.4, 0.3], "mass": 4.0}, "box", "", 0))
    >>> crate.place, crate.mass, crate.parts[0].points[0]
    (Pose2D(x=2.0, y=2.0, theta=0.0), 4.0, (-0.2, -0.15))
    """
    x, y = fields.numbers("center", None, (2,))
    length, width = fields.numbers("size", None, (2,))
    if min(length, width) < 1e-3:
        raise fields.fault(f"'size' is {[length, width]}", "Give length and width, each more than 0.")
    low, high = fields.span(0.5)
    half = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * (length / 2, width / 2)
    place = Pose2D(x, y, fields.number("yaw", 0.0))
    return fields.thing([Prism(_corners(half), low, high)], "crates", place, **_weight(fields))


def door(fields: Fields) -> Thing:
    """A leaf on a hinge; with a mass it swings between closed and `widest`.

    >>> leaf = door(Fields({"hinge": [0, 1], "yaw": 0.0, "open": 0.5, "mass": 6.0}, "door", "", 0))
    >>> leaf.place.theta, round(leaf.hinge.lower, 3), round(leaf.hinge.upper, 3)  # from closed to a right angle
    (0.5, -0.5, 1.071)
    """
    x, y = fields.numbers("hinge", None, (2,))
    width, thick = fields.number("width", 0.9, 0.05), fields.number("thickness", 0.04, 0.005)
    low, high = fields.span(2.0)
    shut, opened = fields.number("yaw", 0.0), fields.number("open", 0.0, -math.pi, math.pi)
    widest = fields.number("widest", math.copysign(math.pi / 2, opened or 1.0), -math.pi, math.pi)
    leaf = Prism(((0.0, -thick / 2), (width, -thick / 2), (width, thick / 2), (0.0, thick / 2)), low, high)
    weight = _weight(fields)
    hinge = Hinge(min(0.0, widest, opened) - opened, max(0.0, widest, opened) - opened) if weight["mass"] else None
    return fields.thing([leaf], "door", Pose2D(x, y, shut + opened), hinge=hinge, **weight)


def _weight(fields: Fields) -> dict[str, float | None]:
    mass = fields.number("mass", 0.0, 0.0)
    return {"mass": mass or None, "friction": fields.number("friction", 0.3, 0.0, 10.0)}


def _corners(points: np.ndarray) -> tuple[tuple[float, float], ...]:
    return tuple((float(x), float(y)) for x, y in points)


ELEMENTS: dict[str, Callable[[Fields], Thing]] = {
    "walls": wall, "polygons": polygon, "circles": circle, "boxes": box, "doors": door,
}  # fmt: skip
__all__ = ["ELEMENTS", "Fields"]
