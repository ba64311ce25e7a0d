"""Objects and robots as pymunk's bodies and shapes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
import pymunk
from pymunk.autogeometry import convex_decomposition

from coursekit.geometry.plane import wrap

from .outlines import hull, signed_area
from .solids import Ball, Disc, Part, Skin
from .world import Thing

FIXED, LOOSE, ROBOT = 1, 2, 3
"""Kinds of shapes."""
SKIN_HEIGHTS = (0.05, 0.15, 0.3)
"""Heights at which fixed meshes are cut for collisions [m]."""
SILL, FLOOR, FLAT = 0.02, 0.15, 0.05
"""Wheels roll over objects lower than SILL [m]; robots stand on ones up to FLOOR and FLAT times as thick as wide."""


def shapes_of(parts: Iterable[Part], body: pymunk.Body, name: str, kind: int, friction: float = 0.6) -> list[Any]:
    """Return the shapes of an object's parts; each has the object's `name` and its lower and upper height (`span`)."""
    shapes = []
    for part in parts:
        if kind == FIXED and is_floor(part):
            continue
        span = part.low, part.high
        for shape in _shapes(part, body, kind == FIXED):
            shape.friction, shape.elasticity, shape.collision_type = friction, 0.0, kind
            shape.name, shape.span = name, span
            shapes.append(shape)
    return shapes


def _shapes(part: Part, body: pymunk.Body, fixed: bool) -> Iterator[Any]:
    if isinstance(part, (Disc, Ball)):
        yield pymunk.Circle(body, part.radius, (part.x, part.y))
    elif isinstance(part, Skin):
        yield from _skin(part, body, fixed)
    elif part.closed:
        for piece in convex(part.points):
            yield pymunk.Poly(body, [(float(x), float(y)) for x, y in piece])
    else:
        for a, b in zip(part.points[:-1], part.points[1:], strict=True):
            yield pymunk.Segment(body, a, b, 0.0)


def _skin(part: Skin, body: pymunk.Body, fixed: bool) -> Iterator[Any]:
    if not fixed:
        yield pymunk.Poly(body, [(float(x), float(y)) for x, y in hull(part.corners())])
        return
    seen: set[tuple[float, float, float, float]] = set()
    for height in SKIN_HEIGHTS:
        for edge in np.round(part.cut(height).edges, 6):
            x1, y1, x2, y2 = map(float, edge)
            key = (x1, y1, x2, y2)
            if key not in seen:
                seen.add(key)
                yield pymunk.Segment(body, (x1, y1), (x2, y2), 0.0)


def is_floor(part: Part) -> bool:
    """Whether robots stand on the part instead of colliding with it.

    >>> from coursekit.sim import Disc
    >>> is_floor(Disc(0.0, 0.0, 3.0, -0.05, 0.05)), is_floor(Disc(0.0, 0.0, 0.3, 0.0, 0.1))
    (True, False)
    """
    corners = part.corners()
    across = float(np.min(np.ptp(corners, axis=0))) if len(corners) else 0.0
    return part.high <= SILL or (part.high <= FLOOR and part.high - part.low <= FLAT * across)


def convex(points: Iterable[tuple[float, float]]) -> list[Any]:
    """Split a polygon into convex pieces, counter-clockwise.

    >>> len(convex([(0, 0), (2, 0), (2, 2), (1, 0.5)]))
    2
    """
    corners = [(float(x), float(y)) for x, y in points]
    outline = hull(np.array(corners))
    area = signed_area(np.array(corners))
    if abs(abs(signed_area(outline)) - abs(area)) <= 1e-9 * max(1.0, abs(area)):
        return [outline]
    if area < 0:
        corners.reverse()
    pieces = convex_decomposition([*corners, corners[0]], 0.0)
    return [[(p.x, p.y) for p in piece[:-1]] for piece in pieces] or [outline]


def body_of(thing: Thing) -> pymunk.Body:
    """Return the body of a movable object: pushed, on a hinge, or moving by itself."""
    if thing.mass == math.inf:
        body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        body.velocity, body.angular_velocity = thing.velocity[:2], thing.velocity[2]
    else:
        mass = thing.mass or 1.0
        corners = np.concatenate([part.corners() for part in thing.parts])
        body = pymunk.Body(mass, moment(corners, mass))
        if thing.hinge is not None:
            body.moment = mass * float((corners**2).sum(axis=1).max()) / 3
    put(body, thing.place)
    return body


def moment(corners: Any, mass: float) -> float:
    """Return the inertia about the origin of a block with the extent of those corners [kg m^2].

    >>> round(moment([(-0.5, -0.5), (0.5, 0.5)], 6.0), 6)  # a square block of 1 m: m (a² + b²) / 12
    1.0
    """
    (x0, y0), (x1, y1) = np.min(corners, axis=0), np.max(corners, axis=0)
    return float(mass * (((x1 - x0) ** 2 + (y1 - y0) ** 2) / 12 + ((x0 + x1) ** 2 + (y0 + y1) ** 2) / 4)) or 1e-6


def put(body: pymunk.Body, place: tuple[float, float, float]) -> None:
    """Set a body's pose."""
    body.position, body.angle = (place[0], place[1]), place[2]


def follow(body: pymunk.Body, place: tuple[float, float, float], seconds: float) -> None:
    """Set the velocity of a kinematic body to reach a pose in the next physics step.

    >>> body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
    >>> follow(body, (0.2, 0.0, math.pi / 2), 0.1)
    >>> tuple(body.velocity), round(body.angular_velocity, 3)
    ((2.0, 0.0), 15.708)
    """
    x, y = body.position
    body.velocity = (place[0] - x) / seconds, (place[1] - y) / seconds
    body.angular_velocity = wrap(place[2] - body.angle) / seconds


__all__ = ["FIXED", "LOOSE", "ROBOT", "body_of", "convex", "follow", "is_floor", "moment", "put", "shapes_of"]
