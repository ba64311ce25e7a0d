"""What a robot drove, beside the path that was planned."""

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

MOST_PLANS = 60
ROOM = 0.9
"""What is shown around a round [m]."""


def plans_in(seen: Seen) -> list[Any]:
    """The paths that the course's planner published, as they came."""
    return [message for _, message in course_said(seen, "/plan")]


def driven(map_file: str, track: Sequence[Sequence[float]], plans: Sequence[Any], stops: Sequence[Point]) -> Figure:
    """The map with the stops, the paths that were planned, and the true track."""
    import numpy as np

    from coursekit.nav.map_file import load_map

    grid = load_map(map_file)
    codes = np.where(grid.cells < 0, 1, np.where(grid.cells > 65, 2, 0))
    shapes: list[Shape] = [Cells(codes, ("free", "unknown", "wall"), (), grid.origin[:2], grid.resolution)]
    shapes += [Line(track, "own", "driven", wide=True), Dots(track[:1], "own", "her start", 4.5)]
    shapes += [Line(_path(one), "guess", "planned", dashed=True) for one in _first_of_each(plans)]
    for number, stop in enumerate(stops, 1):
        shapes += [Dots([stop], "truth", "a stop", 5.0), Words(stop[0], stop[1] - 0.13, f"stop {number}")]
    alt = f"The room from above: {len(stops)} stops, the planned paths, and the {_length(track):.1f} m that Vera drove."
    return Figure([Panel(shapes, view=_around([*track, *stops]))], alt)


def _around(points: Sequence[Sequence[float]]) -> View:
    """All of them with some of the room around."""
    xs, ys = ([one[axis] for one in points] for axis in (0, 1))
    return min(xs) - ROOM, max(xs) + ROOM, min(ys) - ROOM, max(ys) + ROOM


def _first_of_each(plans: Sequence[Any]) -> list[Any]:
    """The first plan to each goal: later ones begin where she is by then."""
    found: dict[Point, Any] = {}
    for one in plans[:MOST_PLANS]:
        path = _path(one)
        if path:
            found.setdefault((round(path[-1][0], 1), round(path[-1][1], 1)), one)
    return list(found.values())


def _path(plan: Any) -> list[Point]:
    places = [fields(one, ("pose.position.x", "pose.position.y"), "/plan") for one in field(plan, "poses", list, "/plan")]
    return [(x, y) for x, y in places]


def _length(track: Sequence[Sequence[float]]) -> float:
    return sum(math.dist(one[:2], other[:2]) for one, other in pairwise(track))


__all__ = ["driven", "plans_in"]
