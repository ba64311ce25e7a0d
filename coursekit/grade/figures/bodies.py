"""A robot's body: its links from the side and the front, and its stability from above."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from coursekit.view.figure import Dots, Figure, Line, Panel, Point, Shape

if TYPE_CHECKING:
    import numpy as np

    from coursekit.urdf import Robot

KINDS = ("own", "guess", "truth", "robot4", "wall")
"""The colours of the links, repeated."""
SIDE, FRONT, ABOVE = (0, 2), (1, 2), (0, 1)
MOST_LINKS = 24


def sides(robot: Robot) -> Figure:
    """Draw the links' outlines and the joints' frames, with all joints at 0; the front view shows y, which is left."""
    panels = [_view(robot, {}, SIDE, "from the side: x and z"), _view(robot, {}, FRONT, "from the front: y and z")]
    return Figure(panels, f"{robot.name} from the side and from the front: {', '.join(list(robot.links)[:MOST_LINKS])}.")


def standing(robot: Robot, positions: Mapping[str, float], feet: np.ndarray, centre: Point) -> Figure:
    """Draw a posture from the side, and from above its floor contacts (n, 2) and its centre of mass [m]."""
    above = _view(robot, positions, ABOVE, "from above: x and y")
    above.shapes = [*above.shapes, Line(_hull(feet), "wall", "its contacts", wide=True)]
    above.shapes.append(Dots([centre], "bad", "centre of mass", 5.0))
    side = _view(robot, positions, SIDE, "from the side: x and z")
    place = f"({centre[0]:.2f}, {centre[1]:.2f})"
    return Figure([side, above], f"{robot.name} from the side and from above, its centre of mass at {place} m.")


def _view(robot: Robot, positions: Mapping[str, float], axes: tuple[int, int], title: str) -> Panel:
    from coursekit.urdf.kinematics import Kinematics

    poses = Kinematics(robot).poses(dict(positions))
    shapes: list[Shape] = list(_outlines(robot, positions, axes))
    frames = [(pose[axes[0]], pose[axes[1]]) for pose in list(poses.values())[:MOST_LINKS]]
    shapes.append(Dots(frames, "ink", "a link's frame", 2.6))
    panel = Panel(shapes, title)
    if axes[1] == 2:
        xs = [x for shape in shapes if isinstance(shape, Line) for x, _ in shape.points] or [-0.5, 0.5]
        panel.shapes.insert(0, Line([(min(xs) - 0.1, 0.0), (max(xs) + 0.1, 0.0)], "ink", "the floor", dashed=True))
    return panel


def _outlines(robot: Robot, positions: Mapping[str, float], axes: tuple[int, int]) -> Iterator[Line]:
    from coursekit.urdf.shapes import robot_surfaces

    names = list(robot.links)[:MOST_LINKS]
    for name, surface in robot_surfaces(robot, dict(positions)):
        if name in names:
            yield Line(_hull(surface.vertices[:, axes]), KINDS[names.index(name) % len(KINDS)], name)


def _hull(points: np.ndarray) -> list[Point]:
    """Return the corners of the convex hull, closed by the first one."""
    import numpy as np

    corners = sorted({(round(float(x), 5), round(float(y), 5)) for x, y in np.asarray(points) if math.isfinite(x + y)})
    if len(corners) < 3:
        return corners
    lower, upper = _chain(corners), _chain(corners[::-1])
    return [*lower[:-1], *upper]


def _chain(points: list[Point]) -> list[Point]:
    chain: list[Point] = []
    for x, y in points:
        while len(chain) > 1 and _turn(chain[-2], chain[-1], (x, y)) <= 0:
            chain.pop()
        chain.append((x, y))
    return chain


def _turn(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


__all__ = ["sides", "standing"]
