"""An outline from above, and the poses from which it is photographed."""

from __future__ import annotations

import math
from collections.abc import Sequence

from coursekit.view.figure import Arrow, Figure, Line, Panel, Point, Shape

HALF_VIEW, SIGHT = math.radians(30.0), 1.6
"""Half of a camera's field of view [rad], and its drawn length [m]."""
FAR = 20.0


def photographed(corners: Sequence[Point], poses: Sequence[tuple[Point, float]], name: str) -> Figure:
    """Draw the outline [m], and the field of view of each pose (position, yaw)."""
    shapes: list[Shape] = [Line([*corners, corners[0]], "wall", "the outline", wide=True)]
    near = [pose for pose in poses if math.dist(pose[0], corners[0]) < FAR]
    for place, yaw in near:
        left, right = (_ahead(place, yaw + side) for side in (HALF_VIEW, -HALF_VIEW))
        shapes.append(Line([left, place, right], "guess", "what it sees", dashed=True))
        shapes.append(Arrow(*place, yaw, "own", "a photograph"))
    return Figure([Panel(shapes)], f"{name} from above, with {len(poses)} photographs of it.")


def _ahead(place: Point, yaw: float) -> Point:
    return place[0] + SIGHT * math.cos(yaw), place[1] + SIGHT * math.sin(yaw)


__all__ = ["photographed"]
