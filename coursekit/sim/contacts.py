"""Contacts: shapes at different heights do not collide, robots keep their contacts, the floor brakes objects."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any

import pymunk

from .robot import GRAVITY


def overlap(one: Any, other: Any) -> bool:
    """Whether two shapes are at the same height.

    >>> from types import SimpleNamespace
    >>> table, robot = SimpleNamespace(span=(0.6, 0.8)), SimpleNamespace(span=(0.0, 0.3))
    >>> overlap(table, robot)  # it drives under the table
    False
    """
    return bool(one.span[0] < other.span[1] and other.span[0] < one.span[1])


def pass_by(arbiter: pymunk.Arbiter, _space: pymunk.Space, _data: Any) -> None:
    """Handle the start of a contact: shapes at different heights do not collide."""
    arbiter.process_collision = overlap(*arbiter.shapes)


def touch(arbiter: pymunk.Arbiter, space: pymunk.Space, data: Any) -> None:
    """Handle the start of a robot's contact."""
    pass_by(arbiter, space, data)
    if not arbiter.process_collision:
        return
    for robot, other in _robots(arbiter):
        robot.contacts[other.name] = robot.contacts.get(other.name, 0) + 1


def part(arbiter: pymunk.Arbiter, _space: pymunk.Space, _data: Any) -> None:
    """Handle the end of a robot's contact."""
    for robot, other in _robots(arbiter):
        if other.name in robot.contacts and overlap(*arbiter.shapes):
            robot.contacts[other.name] -= 1
            if robot.contacts[other.name] <= 0:
                del robot.contacts[other.name]


def _robots(arbiter: pymunk.Arbiter) -> Iterator[tuple[Any, Any]]:
    """Yield the robots of a contact, each with the other shape."""
    for one, other in (arbiter.shapes, arbiter.shapes[::-1]):
        robot = getattr(one.body, "robot", None)
        if robot is not None:
            yield robot, other


def hits(space: pymunk.Space, shape: Any) -> Iterator[tuple[Any, float]]:
    """Yield the shapes that a shape would hit, with the penetration depth (below 0)."""
    middle = shape.cache_bb().center()
    for hit in space.shape_query(shape):
        yield hit.shape, min((point.distance for point in hit.contact_point_set.points), default=0.0)
    for info in space.point_query(middle, 0.0, pymunk.ShapeFilter()):  # concentric shapes have no contact points
        yield info.shape, info.distance


def obstacle(space: pymunk.Space, shapes: Iterable[Any]) -> Any | None:
    """Return the first shape of the space that one of these would cut into; None where there is room."""
    space.reindex_static()
    for shape in shapes:
        for other, depth in hits(space, shape):
            if depth < -1e-3 and overlap(shape, other):
                return other
    return None


def drag(body: pymunk.Body, friction: float, seconds: float) -> None:
    """Apply the friction of the floor to a sliding object for some seconds.

    >>> body = pymunk.Body(1.0, 1.0)
    >>> body.velocity = 1.0, 0.0
    >>> drag(body, friction=0.3, seconds=0.1)  # it loses 0.3 * 9.81 m/s² * 0.1 s
    >>> round(body.velocity.x, 3)
    0.706
    """
    speed, most = body.velocity.length, friction * GRAVITY * seconds
    body.velocity = body.velocity * max(0.0, 1.0 - most / speed) if speed else (0.0, 0.0)
    turn = body.angular_velocity
    brake = most * 0.15 * body.mass / body.moment
    body.angular_velocity = math.copysign(max(0.0, abs(turn) - brake), turn)


__all__ = ["drag", "hits", "overlap", "part", "pass_by", "touch"]
