"""All outlines at one height, including those of moving bodies, for LiDARs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from coursekit.geometry.plane import Array, Pose2D

from .lidar import Lidar
from .rays import carry
from .solids import Cut, Part, join


class OutlineScene:
    """The outlines of fixed objects, computed once; those of moving objects in the frames of their bodies."""

    def __init__(self, fixed: Sequence[Cut], moving: Sequence[tuple[Any, Cut]]) -> None:
        self.fixed = join(list(fixed))
        self._bodies = [body for body, _ in moving]
        self._local = join([cut for _, cut in moving])
        edges, circles = [len(cut.edges) for _, cut in moving], [len(cut.circles) for _, cut in moving]
        self._owners = tuple(np.repeat(np.arange(len(moving)), counts) for counts in (edges, circles))
        self._ends = [tuple(np.cumsum([0, *counts])) for counts in (edges, circles)]
        self._world = Cut(self._local.edges.copy(), self._local.circles.copy())

    @staticmethod
    def cut_of(parts: Iterable[Part], height: float) -> Cut:
        """Return the outline of some parts."""
        return join([part.cut(height) for part in parts])

    def moving(self) -> Cut:
        """Return the current outline of the moving objects."""
        if self._bodies:
            places = np.array([(*body.position, body.angle) for body in self._bodies])
            (edges, circles), (edge_owners, circle_owners) = self._local, self._owners
            carry(edges, circles, edge_owners, circle_owners, places, self._world.edges, self._world.circles)
        return self._world

    def look(self, lidar: Lidar, place: Pose2D, without: Any = None) -> Array:
        """Return true distances from a pose, ignoring `without`: a LiDAR does not see its own robot."""
        ranges = lidar.look(self.fixed, place)
        cut = self.moving()
        if without not in self._bodies:
            return lidar.look(cut, place, ranges)
        own = self._bodies.index(without)
        (a, b), (c, d) = ((ends[own], ends[own + 1]) for ends in self._ends)
        lidar.look(Cut(cut.edges[:a], cut.circles[:c]), place, ranges)
        return lidar.look(Cut(cut.edges[b:], cut.circles[d:]), place, ranges)


__all__ = ["OutlineScene"]
