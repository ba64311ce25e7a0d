"""Path planning in costmaps: the cheapest path for the robot's centre, kept away from obstacles by their inflation."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coursekit.nav.costmap import INSCRIBED, UNKNOWN, Costmap
from coursekit.nav.planner_kernels import search, smooth

NEARER = 0.2
"""Hysteresis near an occupied goal: a new end position must be so much nearer to the goal [m]."""


class PlanError(Exception):
    """No path; the message gives the reason."""


@dataclass(frozen=True)
class Planner:
    """A* over eight neighbours; if the goal is occupied, the path ends at the nearest cell within `tolerance` [m].

    `factor` weighs costs against distance.

    >>> room = Costmap.of_size(3.0, 3.0, 0.1)
    >>> path = Planner().plan(room, (0.25, 0.25, 0.0), (2.25, 0.25, 0.0))
    >>> path[0].tolist(), path[-1].tolist(), round(length(path), 6)
    ([0.25, 0.25, 0.0], [2.25, 0.25, 0.0], 2.0)
    """

    tolerance: float = 0.5
    unknown: bool = True
    factor: float = 0.8

    def plan(
        self, costs: Costmap, start: tuple[float, float, float], goal: tuple[float, float, float],
        before: tuple[float, float] | None = None,
    ) -> np.ndarray:  # fmt: skip
        """Return poses (n, 3) from start to goal [m, rad]. Raises PlanError.

        `before` is the end of the last path to this goal: while the goal is occupied, the path ends there again.
        """
        self._check(costs, start, "start")
        self._check(costs, goal, "goal")
        begin, end = self._flat(costs, start), self._flat(costs, goal)
        parents, _ = search(costs.cells, begin, end, self.unknown, self.factor)
        reached = end if parents[end] >= 0 else self._nearby(costs, parents, goal, before)
        path = self._walk(costs, parents, begin, reached)
        path[0] = start[:2]
        if reached == end:
            path = np.vstack([path[:-1] if len(path) > 1 else path, [goal[:2]]])
        smooth(path, costs.cells, costs.x, costs.y, costs.resolution, 300, 0.1, 0.3)
        return with_headings(path, goal[2])

    def _check(self, costs: Costmap, place: tuple[float, float, float], what: str) -> None:
        if not all(map(math.isfinite, place)):
            raise PlanError(f"The {what} is not made of finite numbers: {place}")
        if not costs.inside(place[0], place[1]):
            height, width = (cells * costs.resolution for cells in costs.cells.shape)
            raise PlanError(
                f"The {what} ({place[0]:.2f}, {place[1]:.2f}) is off the global costmap, which reaches from "
                f"({costs.x:.2f}, {costs.y:.2f}) to ({costs.x + width:.2f}, {costs.y + height:.2f})"
            )

    @staticmethod
    def _flat(costs: Costmap, place: tuple[float, float, float]) -> int:
        row, column = costs.cell(place[0], place[1])
        return row * costs.cells.shape[1] + column

    def _nearby(
        self, costs: Costmap, parents: np.ndarray, goal: tuple[float, float, float], before: tuple[float, float] | None
    ) -> int:
        """Return the reached cell nearest to the goal, within the tolerance; among similar ones the nearest to `before`."""
        reached = np.flatnonzero((parents >= 0) & (costs.cells.ravel() < INSCRIBED))
        rows, columns = np.divmod(reached, costs.cells.shape[1])
        x, y = costs.x + (columns + 0.5) * costs.resolution, costs.y + (rows + 0.5) * costs.resolution
        gaps = np.hypot(x - goal[0], y - goal[1])
        if len(gaps) and gaps.min() <= self.tolerance:
            # cells around an obstacle are about equally near: a robot that always heads for the nearest one would never stop
            good = gaps <= min(gaps.min() + (NEARER if before else 0.0), self.tolerance)
            moved = np.hypot(x - before[0], y - before[1]) if before else gaps
            return int(reached[np.where(good, moved, np.inf).argmin()])
        cost = costs.cost(goal[0], goal[1])
        why = "the goal is inside or beside an obstacle" if INSCRIBED <= cost < UNKNOWN else "no path leads there"
        near = f"; the nearest place that can be reached is {gaps.min():.2f} m away" if len(gaps) else ""
        raise PlanError(f"{why} (cost {cost}){near}, farther than the tolerance of {self.tolerance:.2f} m")

    @staticmethod
    def _walk(costs: Costmap, parents: np.ndarray, begin: int, end: int) -> np.ndarray:
        """Return the centres of the cells along the path."""
        way = [end]
        while way[-1] != begin:
            way.append(int(parents[way[-1]]))
        rows, columns = np.divmod(np.array(way[::-1]), costs.cells.shape[1])
        return np.column_stack([costs.x + (columns + 0.5) * costs.resolution, costs.y + (rows + 0.5) * costs.resolution])


def with_headings(points: np.ndarray, last: float) -> np.ndarray:
    """Convert points (n, 2) to poses (n, 3) that face along the path; the last one faces `last` [rad].

    >>> with_headings(np.array([[0.0, 0.0], [0.0, 1.0], [0.0, 2.0]]), 3.0).round(3).tolist()
    [[0.0, 0.0, 1.571], [0.0, 1.0, 1.571], [0.0, 2.0, 3.0]]
    """
    if len(points) < 2:
        return np.column_stack([points, np.full(len(points), last)])
    steps = np.diff(points, axis=0)
    headings = np.append(np.arctan2(steps[:, 1], steps[:, 0]), last)
    return np.column_stack([points, headings])


def length(path: np.ndarray) -> float:
    """Return the length of a path (n, 2 or more) [m].

    >>> length(np.array([[0.0, 0.0, 0.0], [3.0, 4.0, 0.0], [3.0, 5.0, 0.0]]))
    6.0
    """
    return float(np.hypot(*np.diff(path[:, :2], axis=0).T).sum()) if len(path) > 1 else 0.0


def smoothed(costs: Costmap, path: np.ndarray, rounds: int = 1000) -> np.ndarray:
    """Smooth a path (n, 3) without moving it nearer to obstacles.

    >>> corner = np.array([[0.5, 0.5, 0.0], [1.0, 0.5, 0.0], [1.5, 0.5, 0.0], [1.5, 1.0, 0.0], [1.5, 1.5, 0.0]])
    >>> path = smoothed(Costmap.of_size(3.0, 3.0, 0.1), corner)
    >>> round(length(corner), 2), round(length(path), 2), path[-1].tolist()
    (2.0, 1.58, [1.5, 1.5, 0.0])
    """
    points = np.ascontiguousarray(path[:, :2], dtype=float).copy()
    smooth(points, costs.cells, costs.x, costs.y, costs.resolution, rounds, 0.2, 0.3)
    return with_headings(points, float(path[-1, 2]))
