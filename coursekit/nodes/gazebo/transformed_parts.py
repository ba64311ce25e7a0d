"""Parts transformed by a 3D pose."""

from __future__ import annotations

import numpy as np

from coursekit.geometry.plane import Array
from coursekit.sim.solids import Ball, Disc, Part, Prism, Skin

from .solids import UPRIGHT


def moved(part: Part, made: Array) -> Part:
    """Transform a part by a 4x4 pose; a tilted upright part becomes triangles."""
    if isinstance(part, Skin):
        return Skin(part.vertices @ made[:3, :3].T + made[:3, 3], part.faces)
    if isinstance(part, Ball):
        x, y, z = made[:3, :3] @ (part.x, part.y, part.z) + made[:3, 3]
        return Ball(float(x), float(y), float(z), part.radius)
    if 1.0 - abs(made[2, 2]) >= UPRIGHT:
        return moved(_skin(part), made)
    low, high = sorted(float(made[2, 2] * z + made[2, 3]) for z in (part.low, part.high))
    if isinstance(part, Disc):
        x, y = made[:2, :2] @ (part.x, part.y) + made[:2, 3]
        return Disc(float(x), float(y), part.radius, low, high)
    corners = np.array(part.points) @ made[:2, :2].T + made[:2, 3]
    return Prism(tuple((float(x), float(y)) for x, y in corners), low, high, part.closed)


def _skin(part: Prism | Disc) -> Skin:
    """Return the walls of an upright part; lids are not needed, because a cut intersects the walls."""
    if isinstance(part, Disc):
        turn = np.linspace(0, 2 * np.pi, 48, endpoint=False)
        ring = np.column_stack((part.x + part.radius * np.cos(turn), part.y + part.radius * np.sin(turn)))
    else:
        ring = np.array(part.points)
    count = len(ring)
    low, high = (np.column_stack((ring, np.full(count, z))) for z in (part.low, part.high))
    middle = ring.mean(axis=0)
    ends = np.array([(*middle, part.low), (*middle, part.high)])
    here, there = np.arange(count), (np.arange(count) + 1) % count
    faces = [(here, there, there + count), (here, there + count, here + count)]
    faces += [(there, here, np.full(count, 2 * count)), (here + count, there + count, np.full(count, 2 * count + 1))]
    return Skin(np.concatenate((low, high, ends)), np.concatenate([np.column_stack(face) for face in faces]))


__all__ = ["moved"]
