"""Collision shapes from files as parts of the simulation."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from coursekit.geometry.plane import Array
from coursekit.sim.solids import Ball, Disc, Part, Prism, Skin
from coursekit.urdf.model import Box, Cylinder, Mesh, Sphere
from coursekit.urdf.shapes import mesh_of

UPRIGHT = 1e-6
"""The maximum tilt of an upright axis, as `1 - cos` of the angle."""


@dataclass(frozen=True)
class Outline:
    """SDF's polyline: a polygon extruded from its own z = 0."""

    points: tuple[tuple[float, float], ...]
    height: float


Shape = Box | Cylinder | Sphere | Mesh | Outline


def part_of(shape: Shape, made: Array, near: Path | None = None) -> Part:
    """Return a shape at a pose (4x4). Upright boxes and cylinders stay exact; tilted ones become triangles. Raises
    MeshError.
    """
    x, y, z = (float(number) for number in made[:3, 3])
    upright = 1.0 - abs(made[2, 2]) < UPRIGHT
    if isinstance(shape, Sphere):
        return Ball(x, y, z, shape.radius)
    if isinstance(shape, Cylinder) and upright:
        return Disc(x, y, shape.radius, z - shape.length / 2, z + shape.length / 2)
    if isinstance(shape, Box) and upright:
        half = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * shape.size[0:2] / 2
        return _prism(half, made, z - shape.size[2] / 2, z + shape.size[2] / 2)
    if isinstance(shape, Outline):
        low, high = sorted((z, z + float(made[2, 2]) * shape.height))
        return _prism(np.array(shape.points), made, low, high)
    mesh = mesh_of(shape, near)
    vertices = np.asarray(mesh.vertices) @ made[:3, :3].T + made[:3, 3]
    return Skin(vertices, np.asarray(mesh.faces))


def _prism(points: Array, matrix: Array, low: float, high: float) -> Prism:
    corners = points @ matrix[:2, :2].T + matrix[:2, 3]
    return Prism(tuple((float(a), float(b)) for a, b in corners), low, high)


def raised(part: Part, by: float) -> Part:
    """Return the part, raised."""
    if isinstance(part, Skin):
        return Skin(part.vertices + np.array((0.0, 0.0, by)), part.faces)
    if isinstance(part, Ball):
        return Ball(part.x, part.y, part.z + by, part.radius)
    if isinstance(part, Disc):
        return Disc(part.x, part.y, part.radius, part.low + by, part.high + by)
    return Prism(part.points, part.low + by, part.high + by, part.closed)


__all__ = ["Outline", "Shape", "part_of", "raised"]
