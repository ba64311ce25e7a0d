"""Pieces that meshes are put together from: convex shapes and bodies of revolution. Metres."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np
import trimesh
from trimesh import Trimesh

Point = tuple[float, float, float]
Painted = tuple[str, tuple[float, float, float], Trimesh]
"""Name, colour and shape of a part of a DAE file."""


def joined(*parts: Trimesh) -> Trimesh:
    """Several shapes as one mesh."""
    return trimesh.util.concatenate(list(parts))


def moved(part: Trimesh, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Trimesh:
    """A shifted copy."""
    return part.copy().apply_translation((x, y, z))


def turned(part: Trimesh, angle: float, axis: Point) -> Trimesh:
    """A copy turned about an axis through the origin [rad]."""
    return part.copy().apply_transform(trimesh.transformations.rotation_matrix(angle, axis))


def hull(points: Iterable[Sequence[float]]) -> Trimesh:
    """The smallest convex shape about some points."""
    return trimesh.convex.convex_hull(np.array(list(points), float))


def outline(length: float, width: float, corner: float, steps: int = 3) -> list[tuple[float, float]]:
    """A rectangle about the origin with round corners."""
    points = []
    for quarter, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        for step in range(steps + 1):
            angle = math.pi / 2 * (quarter + step / steps)
            x, y = sx * (length / 2 - corner), sy * (width / 2 - corner)
            points.append((x + corner * math.cos(angle), y + corner * math.sin(angle)))
    return points


def block(length: float, width: float, height: float, corner: float = 0.004, bevel: float = 0.002) -> Trimesh:
    """A block about the origin with round upright edges and bevels above and below."""
    full = outline(length, width, corner)
    small = outline(length - 2 * bevel, width - 2 * bevel, max(corner - bevel, 1e-4))
    half = height / 2
    levels = ((small, -half), (full, -half + bevel), (full, half - bevel), (small, half))
    return hull((x, y, z) for points, z in levels for x, y in points)


def turned_profile(profile: Sequence[tuple[float, float]], sections: int = 32) -> Trimesh:
    """A body of revolution about z from (radius, height) pairs, from below to above."""
    return trimesh.creation.revolve(np.array(profile, float), sections=sections)


def rod(radius: float, height: float, sections: int = 16) -> Trimesh:
    """A cylinder about the origin along z."""
    return turned_profile([(0, -height / 2), (radius, -height / 2), (radius, height / 2), (0, height / 2)], sections)


def box(length: float, width: float, height: float) -> Trimesh:
    """A sharp block about the origin."""
    return trimesh.creation.box((length, width, height))
