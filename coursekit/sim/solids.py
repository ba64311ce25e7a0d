"""The solids that objects are made of: they can be cut at a height, as by a LiDAR.

A cut is the intersection with a plane parallel to the floor: edges (n, 4) as x1, y1, x2, y2 and circles (m, 3) as x, y,
radius [m].
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from coursekit.geometry.plane import Array, Pose2D

NO_EDGES = np.zeros((0, 4))
NO_CIRCLES = np.zeros((0, 3))


class Cut(NamedTuple):
    """The outline of objects at one height."""

    edges: Array
    circles: Array

    def moved(self, place: Pose2D) -> Cut:
        """Transform from an object's own frame to the world.

        >>> Disc(1.0, 0.0, 0.1).cut(0.5).moved(Pose2D(5.0, 5.0, np.pi / 2)).circles.round(3).tolist()
        [[5.0, 6.0, 0.1]]
        """
        ends = place.transform(self.edges.reshape(-1, 2)).reshape(-1, 4)
        centres = place.transform(self.circles[:, :2])
        return Cut(ends, np.column_stack((centres, self.circles[:, 2:])))


NOTHING = Cut(NO_EDGES, NO_CIRCLES)


def join(cuts: list[Cut]) -> Cut:
    """Join several cuts to one."""
    if not cuts:
        return NOTHING
    return Cut(np.concatenate([cut.edges for cut in cuts]), np.concatenate([cut.circles for cut in cuts]))


def ring(points: Array, closed: bool = True) -> Array:
    """Return the edges of a chain of points (n, 2).

    >>> ring([(0, 0), (1, 0)], closed=False).tolist()
    [[0.0, 0.0, 1.0, 0.0]]
    """
    corners = np.asarray(points, float)
    ends = np.roll(corners, -1, axis=0)
    edges = np.column_stack((corners, ends))
    return edges if closed else edges[:-1]


@dataclass(frozen=True)
class Prism:
    """A polygon, or an open chain, extruded from `low` to `high` [m]."""

    points: tuple[tuple[float, float], ...]
    low: float = 0.0
    high: float = 2.0
    closed: bool = True

    def cut(self, height: float) -> Cut:
        """Return the outline at a height [m]; NOTHING above and below it.

        >>> table = Prism(((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), low=0.6, high=0.8)
        >>> table.cut(0.7).edges.tolist()
        [[0.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.0]]
        >>> len(table.cut(0.2).edges)
        0
        """
        if not self.low <= height <= self.high:
            return NOTHING
        return Cut(ring(np.array(self.points), self.closed), NO_CIRCLES)

    def corners(self) -> Array:
        """Return points that enclose it, seen from above."""
        return np.array(self.points, float)


@dataclass(frozen=True)
class Disc:
    """An upright cylinder about (x, y)."""

    x: float
    y: float
    radius: float
    low: float = 0.0
    high: float = 2.0

    def cut(self, height: float) -> Cut:
        """Return the outline at a height."""
        if not self.low <= height <= self.high:
            return NOTHING
        return Cut(NO_EDGES, np.array([[self.x, self.y, self.radius]]))

    def corners(self) -> Array:
        """Return the square around it, seen from above."""
        r = self.radius
        return np.array([(self.x + i * r, self.y + j * r) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))])


@dataclass(frozen=True)
class Ball:
    """A sphere about (x, y, z)."""

    x: float
    y: float
    z: float
    radius: float

    @property
    def low(self) -> float:
        """Its lowest point."""
        return self.z - self.radius

    @property
    def high(self) -> float:
        """Its highest point."""
        return self.z + self.radius

    def cut(self, height: float) -> Cut:
        """Return the circle at a height [m].

        >>> Ball(2.0, 0.0, 0.5, 0.5).cut(0.2).circles.round(3).tolist()
        [[2.0, 0.0, 0.4]]
        """
        square = self.radius**2 - (height - self.z) ** 2
        return Cut(NO_EDGES, np.array([[self.x, self.y, square**0.5]])) if square > 0 else NOTHING

    def corners(self) -> Array:
        """Return the square around it, seen from above."""
        return Disc(self.x, self.y, self.radius).corners()


@dataclass(frozen=True, eq=False)
class Skin:
    """A triangle mesh: vertices (n, 3) [m], faces (m, 3)."""

    vertices: Array
    faces: np.ndarray

    @property
    def low(self) -> float:
        """Its lowest point."""
        return float(self.vertices[:, 2].min())

    @property
    def high(self) -> float:
        """Its highest point."""
        return float(self.vertices[:, 2].max())

    def cut(self, height: float) -> Cut:
        """Return the edges in which its triangles meet the plane.

        >>> corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
        >>> pyramid = Skin(corners, np.array([[0, 1, 3], [1, 2, 3], [2, 0, 3]]))
        >>> pyramid.cut(0.5).edges.shape  # one edge in each of the three sides
        (3, 4)
        """
        corners = self.vertices[self.faces]
        # a corner in the plane counts as below it, so each crossing counts once
        above = corners[:, :, 2] > height
        count = above.sum(axis=1)
        met = corners[(count == 1) | (count == 2)]
        if not len(met):
            return NOTHING
        flags = met[:, :, 2] > height
        lonely = np.where(flags.sum(axis=1) == 1, flags.argmax(axis=1), (~flags).argmax(axis=1))
        rows = np.arange(len(met))
        apex, one, two = (met[rows, (lonely + step) % 3] for step in range(3))
        edges = np.concatenate((_meet(apex, one, height), _meet(apex, two, height)), axis=1)
        return Cut(edges[np.abs(edges[:, :2] - edges[:, 2:]).max(axis=1) > 1e-9], NO_CIRCLES)

    def corners(self) -> Array:
        """Return its vertices, seen from above."""
        return self.vertices[:, :2]


def _meet(a: Array, b: Array, height: float) -> Array:
    share = (height - a[:, 2]) / (b[:, 2] - a[:, 2])
    return a[:, :2] + share[:, None] * (b[:, :2] - a[:, :2])


Part = Prism | Disc | Ball | Skin
__all__ = ["NOTHING", "Ball", "Cut", "Disc", "Part", "Prism", "Skin", "join", "ring"]
