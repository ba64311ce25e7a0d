"""The solids of a simulated world as triangles."""

from __future__ import annotations

import mapbox_earcut
import numpy as np

from coursekit.sim.solids import Ball, Disc, Part, Skin, ring
from coursekit.sim.textures import ROBOT_COLOUR, USUAL
from coursekit.sim.world import Thing

from .scene_shapes import Body, Colour, Triangles, ball, join

ROUND = 32
"""The number of corners of a cylinder."""


def body_of(part: Part) -> Body:
    """Return vertices (n, 3) [m] and faces (m, 3) of a part.

    >>> from coursekit.sim.solids import Prism
    >>> vertices, faces = body_of(Prism(((0, 0), (1, 0), (1, 1), (0, 1)), 0.0, 2.0))
    >>> vertices.max(axis=0).tolist(), len(faces)
    ([1.0, 1.0, 2.0], 12)
    """
    if isinstance(part, Skin):
        return part.vertices, part.faces
    if isinstance(part, Ball):
        vertices, faces = ball()
        return vertices * 2 * part.radius + [part.x, part.y, part.z], faces
    if isinstance(part, Disc):
        turn = np.arange(ROUND) * (2 * np.pi / ROUND)
        outline = np.column_stack((part.x + part.radius * np.cos(turn), part.y + part.radius * np.sin(turn)))
        return join_bodies([_walls(outline, part.low, part.high, True), *_lids(outline, part.low, part.high)])
    outline = np.asarray(part.points, float)
    walls = _walls(outline, part.low, part.high, part.closed)
    return join_bodies([walls, *(_lids(outline, part.low, part.high) if part.closed else [])])


def join_bodies(bodies: list[Body]) -> Body:
    """Join several bodies."""
    joined = join(bodies, (0.0, 0.0, 0.0, 1.0))
    return joined.vertices, joined.faces


def _walls(outline: np.ndarray, low: float, high: float, closed: bool) -> Body:
    edges = ring(outline, closed)
    count = len(edges)
    ends = edges.reshape(-1, 2)
    vertices = np.concatenate([np.column_stack((ends, np.full(len(ends), z))) for z in (low, high)])
    a, b = np.arange(count) * 2, np.arange(count) * 2 + 1
    up = 2 * count
    return vertices, np.concatenate([np.stack((a, b, b + up), axis=1), np.stack((a, b + up, a + up), axis=1)])


def _lids(outline: np.ndarray, low: float, high: float) -> list[Body]:
    faces = mapbox_earcut.triangulate_float64(outline, np.array([len(outline)], np.uint32)).reshape(-1, 3)
    top, bottom = (np.column_stack((outline, np.full(len(outline), z))) for z in (high, low))
    return [(top, faces.astype(int)), (bottom, faces[:, ::-1].astype(int))]


def thing_shape(thing: Thing) -> Triangles:
    """Return a thing of the world as triangles, in its own frame."""
    red, green, blue = thing.colour or USUAL.get(thing.texture, USUAL["plain"])
    return join([body_of(part) for part in thing.parts], (red, green, blue, 1.0))


def robot_shape(parts: tuple[Part, ...]) -> Triangles:
    """Return a robot of which only the parts are known as triangles, in its own frame."""
    blue, green, red = ROBOT_COLOUR
    return join([body_of(part) for part in parts], (red, green, blue, 1.0))


def fan(origin: tuple[float, float], height: float, ends: np.ndarray, colour: Colour) -> Triangles:
    """Return a LiDAR's sweep: triangles from its origin to each two neighbouring ends (n, 2) [m], at a height.

    >>> fan((0.0, 0.0), 0.2, np.array([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]), (1.0, 0.0, 0.0, 0.3)).faces.tolist()
    [[0, 1, 2], [0, 2, 3]]
    """
    vertices = np.column_stack((np.concatenate(([origin], ends)), np.full(len(ends) + 1, height)))
    first = np.arange(1, len(ends))
    return Triangles(vertices, np.stack((np.zeros_like(first), first, first + 1), axis=1), colour)


__all__ = ["body_of", "fan", "robot_shape", "thing_shape"]
