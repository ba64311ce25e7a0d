"""Robots of chapter 7: one as seen by another, one at work, a table of four, four at work together."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from coursekit.view.figure import Arrow, Cells, Dots, Figure, Line, Mover, Panel, Shape, View, Words

if TYPE_CHECKING:
    from coursekit.grade.chapters.measures.reports import Report, Spot

EVERY = 15
"""One of this many reports is drawn, at thirty reports a second."""
FAR = 15.0
"""The maximum distance of a drawn answer from `me` [m]."""
CYCLES = 30.0
"""The table's cycles per second."""
SILENT, UNHEARD = 7, 8


def seen_by_me(me: Sequence[float], other: Sequence[float], answer: Sequence[float]) -> Figure:
    """Draw both robots in the common frame, and the answer for the pose of `other` relative to `me`."""
    c, s = math.cos(me[2]), math.sin(me[2])
    x, y = me[0] + c * answer[0] - s * answer[1], me[1] + s * answer[0] + c * answer[1]
    yaw = me[2] + answer[2]
    right = math.dist((x, y), other[:2]) < 1e-6 and abs(math.remainder(yaw - other[2], math.tau)) < 1e-6
    shapes: list[Shape] = [Line([me[:2], (me[0] + c, me[1] + s)], "own", "my x: ahead")]
    shapes += [Line([me[:2], (me[0] - s, me[1] + c)], "own", "my y: left", dashed=True)]
    shapes += [Arrow(me[0], me[1], me[2], "own", "me"), Arrow(other[0], other[1], other[2], "truth", "the other")]
    if not right:
        shapes.append(Arrow(x, y, yaw, "bad", "where your answer puts it"))
    view = _around([me, other, (me[0] + c, me[1] + s), (me[0] - s, me[1] + c)] + [(x, y)] * (math.hypot(*answer[:2]) < FAR))
    off = "exactly where it is" if right else f"{math.dist((x, y), other[:2]):.2f} m beside it"
    return Figure([Panel(shapes, view=view)], f"Two robots from above. Your answer puts the other one {off}.")


def _around(points: Sequence[Sequence[float]]) -> View:
    """Return a view of all points with a margin, at least half as wide again as high."""
    (left, right), (low, high) = (
        (min(point[k] for point in points) - 0.7, max(point[k] for point in points) + 0.7) for k in (0, 1)
    )
    wider = max(0.0, 1.5 * (high - low) - (right - left)) / 2
    return left - wider, right + wider, low, high


def worked(told: Sequence[Report], pickups: Sequence[Spot], deliveries: Sequence[Spot]) -> Figure:
    """Draw the track of a robot that fetches and delivers: without a load, and with one."""
    shapes: list[Shape] = []
    for loaded, kind, label in ((False, "own", "to a load"), (True, "guess", "with a load")):
        shapes += [Line(part, kind, label, wide=loaded) for part in _parts(told, loaded)]
    tasks = _tasks(told)
    for goals, kind, label in ((pickups, "guess", "a pickup"), (deliveries, "truth", "a delivery")):
        shapes += [Arrow(*goal, kind, label) for goal in goals[:tasks]]
    shapes.append(Dots([told[0][1][:2]], "ink", "its start", 4.5))
    alt = f"The robot's track from above, {tasks} loads begun: to each pickup, then to its delivery."
    return Figure([Panel(shapes)], alt)


def _parts(told: Sequence[Report], loaded: bool) -> list[list[tuple[float, float]]]:
    """Return the tracks of stages 0 to 2, or with a load those of stages 3 to 5."""
    parts: list[list[tuple[float, float]]] = [[]]
    for stage, place in told:
        if (stage > 2) == loaded and stage < 6:
            if not parts[-1] or parts[-1][-1] != place[:2]:
                parts[-1].append(place[:2])
        elif parts[-1]:
            parts.append([])
    return [part for part in parts if len(part) > 1]


def _tasks(told: Sequence[Report]) -> int:
    stages = [stage for stage, _ in told]
    return sum(old != 0 and new == 0 for old, new in zip([6, *stages], stages, strict=False))


def table(shown: Mapping[int, Sequence[int]], spoken: Mapping[int, Sequence[float]]) -> Figure:
    """Draw the table over time, a row for each robot, with the times of the robots' reports."""
    import numpy as np

    length = max(map(len, shown.values()))
    rows = [[*stages, *[-1] * (length - len(stages))] for _, stages in sorted(shown.items(), reverse=True)]
    codes = np.array(rows)
    codes = np.select([codes == UNHEARD, codes == SILENT, codes >= 0], [1, 2, 3], 0)
    strips = np.repeat(codes, 2, axis=0)
    strips[::2] = 0
    kinds, labels = ("free", "unknown", "guess", "cost3"), ("", "8: never heard", "7: silent", "its stage")
    shapes: list[Shape] = [Cells(strips, kinds, labels, (0.0, 0.0), 1 / CYCLES)]
    height = 1 / CYCLES
    for row, robot in enumerate(sorted(shown, reverse=True)):
        middle = (2 * row + 1.5) * height
        shapes.append(Dots([(when, middle) for when in spoken.get(robot, ())], "ink", "it reports", 2.0))
        shapes.append(Words(0.0, middle, f"robot{robot}", before=True))
    view = (0.0, length * height, 0.0, 8.4 * height)
    alt = "Your table over time: for each robot when it was never heard, silent, or in a stage, and when it reported."
    return Figure([Panel(shapes, view=view, axes=("time [s]", ""))], alt)


def four_robots(tracks: Sequence[Sequence[Spot]]) -> Figure:
    """Draw the tracks of four robots, and the robots on them."""
    shapes: list[Shape] = []
    for number, track in enumerate(tracks, 1):
        places = [pose[:2] for pose in track[::EVERY]]
        shapes += [Line(places, f"robot{number}", f"robot{number}"), Dots(places[:1], f"robot{number}", "", 4.5)]
        shapes.append(Mover(places, f"robot{number}"))
    lengths = (sum(math.dist(a[:2], b[:2]) for a, b in itertools.pairwise(path)) for path in tracks)
    told = ", ".join(f"robot{number} {length:.1f} m" for number, length in enumerate(lengths, 1))
    return Figure([Panel(shapes)], f"The tracks of four robots from above: {told}.")


__all__ = ["four_robots", "seen_by_me", "table", "worked"]
