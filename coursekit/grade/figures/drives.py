"""A robot's drive, with the planned path."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from coursekit.grade.outputs import course_said
from coursekit.grade.plain import field, fields
from coursekit.view.figure import Cells, Dots, Figure, Line, Panel, Point, Shape, View, Words

if TYPE_CHECKING:
    from coursekit.grade.plan import Seen
    from coursekit.nav.map_file import GridMap

MOST_PLANS = 60
ROOM = 0.9
"""The margin around a round [m]."""


def estimates_and_plans(seen: Seen) -> tuple[list[Any], list[Any]]:
    """Return the poses published by amcl and the paths published by the planner, in order."""
    poses, plans = ([message for _, message in course_said(seen, topic)] for topic in ("/amcl_pose", "/plan"))
    return poses, plans


def driven(
    map_file: str,
    odometry: Sequence[Sequence[float]],
    estimates: Sequence[Any],
    plans: Sequence[Any],
    stops: Sequence[Point],
) -> Figure:
    """Draw the map with the stops, the planned paths, and the robot's positions by amcl and by odometry alone."""
    from coursekit.nav.map_file import load_map

    track = [_place(estimate, "pose.pose.position", "/amcl_pose") for estimate in estimates]
    lines = [Line(odometry, "robot4", "by odometry alone"), Line(track, "own", "driven, as amcl finds", wide=True)]
    shapes: list[Shape] = [_cells(load_map(map_file)), *lines]
    shapes += [Line(_path(plan), "guess", "planned", dashed=True) for plan in _first_of_each(plans)]
    shapes.append(Dots(odometry[:1], "ink", "her start", 4.5))
    for number, stop in enumerate(stops, 1):
        shapes += [Dots([stop], "truth", "a stop", 5.0), Words(stop[0], stop[1] - 0.13, f"stop {number}")]
    alt = f"The room from above: {len(stops)} stops, the planned paths, and the {_length(odometry):.1f} m that Vera drove."
    return Figure([Panel(shapes, view=_around([*odometry, *stops]))], alt)


def _cells(grid: GridMap) -> Cells:
    import numpy as np

    codes = np.where(grid.cells < 0, 1, np.where(grid.cells > 65, 2, 0))
    return Cells(codes, ("free", "unknown", "wall"), (), grid.origin[:2], grid.resolution)


def _around(points: Sequence[Sequence[float]]) -> View:
    """Return a view of all points with a margin."""
    xs, ys = ([point[axis] for point in points] for axis in (0, 1))
    return min(xs) - ROOM, max(xs) + ROOM, min(ys) - ROOM, max(ys) + ROOM


def _first_of_each(plans: Sequence[Any]) -> list[Any]:
    """Return the first plan to each goal: later ones start at her current position."""
    plan_by_goal: dict[Point, Any] = {}
    for plan in plans[:MOST_PLANS]:
        path = _path(plan)
        if path:
            plan_by_goal.setdefault((round(path[-1][0], 1), round(path[-1][1], 1)), plan)
    return list(plan_by_goal.values())


def _path(plan: Any) -> list[Point]:
    return [_place(pose, "pose.position", "/plan") for pose in field(plan, "poses", list, "/plan")]


def _place(message: Any, position: str, topic: str) -> Point:
    x, y = fields(message, (f"{position}.x", f"{position}.y"), topic)
    return x, y


def _length(track: Sequence[Sequence[float]]) -> float:
    return sum(math.dist(one[:2], other[:2]) for one, other in pairwise(track))


__all__ = ["driven", "estimates_and_plans"]
