"""Beams of chapter 8: cast rays, and a scan before and after matching."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from coursekit.view.figure import Arrow, Dots, Figure, Line, Panel, Shape, View

if TYPE_CHECKING:
    import numpy as np

    from coursekit.grade.chapters.measures.rays import Ray
    from coursekit.grade.matching import Pose, Puzzle

MOST_RAYS = 24
FAR = 10.0
"""The distance from the guess beyond which no gap is measured [m]."""
AROUND = 0.8
"""The margin around a scan [m]."""


def rays_among(walls: Sequence[Sequence[float]], rays: Sequence[Ray]) -> Figure:
    """Draw correct rays, each up to the first wall."""
    drawn = rays[:MOST_RAYS]
    shapes = [*_walls(walls), *(part for ray in drawn for part in _right(ray))]
    met = sum(math.isfinite(ray.need) for ray in drawn)
    alt = f"{len(walls)} walls from above and {len(drawn)} of your rays: {met} end at the first wall, the others meet none."
    return Figure([Panel(shapes, view=_around(walls, drawn))], alt)


def wrong_ray(walls: Sequence[Sequence[float]], ray: Ray) -> Figure:
    """Draw one ray: its end, and the end of the answer."""
    start = (ray.x, ray.y)
    need = Line([start, ray.end(ray.need)], "truth", "the ray", wide=True)
    got = Line([start, ray.end(ray.got)], "bad", "your answer", dashed=True)
    shapes = [*_walls(walls), need, got, Dots([start], "ink", "its start", 3.5)]
    alt = f"Walls and one ray from ({ray.x:.2f}, {ray.y:.2f}): it goes {_far(ray.need)}; your answer goes {_far(ray.got)}."
    return Figure([Panel(shapes, view=_around(walls, [ray]), rings=[ray.end(ray.got)])], alt)


def _walls(walls: Sequence[Sequence[float]]) -> list[Shape]:
    return [Line([wall[:2], wall[2:]], "wall", "a wall", wide=True) for wall in walls]


def _far(distance: float) -> str:
    return "on without meeting a wall" if math.isinf(distance) else f"{distance:.2f} m"


def _right(ray: Ray) -> list[Shape]:
    met = math.isfinite(ray.need)
    kind, label = ("own", "a ray, up to the first wall") if met else ("guess", "a ray that meets none in its range")
    ends = [ray.end(ray.need)] if met else []
    line = Line([(ray.x, ray.y), ray.end(ray.need if met else 0.6)], kind, label, dashed=not met)
    return [line, Dots(ends, kind, "", 2.6)]


def _around(walls: Sequence[Sequence[float]], rays: Sequence[Ray], room: float = 0.4) -> View:
    """Return a view of all walls and the rays' starts."""
    points = [point for wall in walls for point in (wall[:2], wall[2:])] + [(ray.x, ray.y) for ray in rays]
    xs, ys = zip(*points, strict=True)
    return min(xs) - room, max(xs) + room, min(ys) - room, max(ys) + room


def matched(puzzle: Puzzle, pose: Pose, told: str, right: bool) -> Figure:
    """Draw a scan over the true walls: at the guess, and at the pose found by `match`."""
    from coursekit.geometry.plane import Pose2D

    ends = Pose2D(*puzzle.truth).transform(puzzle.points)
    (left, low), (up, high) = ends.min(axis=0) - AROUND, ends.max(axis=0) + AROUND
    view = (float(left), float(up), float(low), float(high))
    walls = puzzle.gap.points
    seen = walls[((walls > (left, low)) & (walls < (up, high))).all(axis=1)]
    kind, label = ("own", "the scan, matched") if right else ("bad", "where you put the scan")
    before = _placed(puzzle, seen, puzzle.guess, "guess", "the scan at the guess", view, "before: at the guess")
    after = _placed(puzzle, seen, pose, kind, label, view, "after matching")
    gap = f"{puzzle.misfit(pose) * 100:.1f} cm" if math.dist(pose[:2], puzzle.guess[:2]) < FAR else f"more than {FAR:g} m"
    alt = f"The scan {told} over the true walls. Their mean gap is {puzzle.misfit(puzzle.guess) * 100:.1f} cm at the guess,"
    return Figure([before, after], f"{alt} and {gap} after matching.")


def _placed(puzzle: Puzzle, walls: np.ndarray, pose: Pose, kind: str, label: str, view: View, title: str) -> Panel:
    from coursekit.geometry.plane import Pose2D

    points = Pose2D(*pose).transform(puzzle.points)
    shown = [Dots(walls[::3].tolist(), "wall", "a wall", 1.2), Dots(points.tolist(), kind, label, 1.7)]
    return Panel([*shown, Arrow(*pose, kind)], title, view)


__all__ = ["matched", "rays_among", "wrong_ray"]
