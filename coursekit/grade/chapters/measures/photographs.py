"""Photographs of an outline from all sides, for the last exercise of appendix B."""

from __future__ import annotations

import math

from coursekit.grade.verdict import NO_HINT, Wrong

HALF_VIEW = math.radians(30.0)

Flat = tuple[float, float]
"""x and y [m]."""


def judge_views(poses: list[tuple[Flat, float]], corners: list[Flat], name: str) -> None:
    """Raise Wrong unless every side is seen whole, from outside and not too close; poses are (position, yaw)."""
    sides = list(zip(corners, corners[1:] + corners[:1], strict=True))
    away = min(_away(place, *side) for place, _ in poses for side in sides)
    inside = any(all(_height(place, *side) < 0 for side in sides) for place, _ in poses)
    if inside or not away >= 0.8 - 1e-6:
        got = "one stands in it" if inside else f"one is {away:.2f} m from a side"
        nearest = min((place for place, _ in poses), key=lambda place: min(_away(place, *side) for side in sides))
        raise Wrong(f"0.8 m of room around {name}", gave=got, share=0.25, hint=NO_HINT, at=[nearest])
    for number, side in enumerate(sides, 1):
        faults = [fault for place, yaw in poses if (fault := _fault(place, yaw, *side))]
        if len(faults) == len(poses):
            best = max(faults)[1]
            wanted = f"a photograph of side {number} of {name}, from {told(side[0])} to {told(side[1])}"
            at = [((side[0][0] + side[1][0]) / 2, (side[0][1] + side[1][1]) / 2)]
            raise Wrong(wanted, gave=best, share=0.25, hint=1, at=at)


def _height(place: Flat, a: Flat, b: Flat) -> float:
    """Return the signed distance of a point from the line a-b, positive on the outer side [m]."""
    along = (b[0] - a[0], b[1] - a[1])
    return ((place[0] - a[0]) * along[1] - (place[1] - a[1]) * along[0]) / math.hypot(*along)


def _away(place: Flat, a: Flat, b: Flat) -> float:
    """Return the distance of a point from a side [m]."""
    along, way = (b[0] - a[0], b[1] - a[1]), (place[0] - a[0], place[1] - a[1])
    part = max(0.0, min(1.0, (way[0] * along[0] + way[1] * along[1]) / (along[0] ** 2 + along[1] ** 2)))
    return math.dist(place, (a[0] + part * along[0], a[1] + part * along[1]))


def _fault(place: Flat, yaw: float, a: Flat, b: Flat) -> tuple[int, str] | None:
    """Return why a pose does not show a side, with a higher rank for a better pose; None when it does."""
    middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
    far, height = math.dist(place, middle), _height(place, a, b)
    if not height > 0:
        return 1, "all poses stand on its other side"
    if not height >= far * math.cos(math.radians(45.0)) - 1e-6:
        return 2, "the nearest to it looks at it from too far aside"
    if not 1.0 - 1e-6 <= far <= 2.5 + 1e-6:
        return 3, f"the one before it is {far:.2f} m from its middle"
    turns = [abs(math.remainder(math.atan2(end[1] - place[1], end[0] - place[0]) - yaw, math.tau)) for end in (a, b)]
    if not max(turns) <= HALF_VIEW + 1e-6:
        return 4, f"the one before it has an end {math.degrees(max(turns)):.0f}° off the middle of its picture"
    return None


def told(numbers: tuple[float, ...]) -> str:
    """Format numbers for a verdict."""
    return f"({', '.join(f'{number + 0.0:.2f}' for number in numbers)})"
