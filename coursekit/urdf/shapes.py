"""Shapes as triangles, for viewers and simulators."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from .errors import MeshError
from .kinematics import Kinematics
from .mesh_files import GREY, Surface, load_mesh
from .model import Box, Collision, Cylinder, Geometry, Link, Mesh, Origin, Robot, Sphere, Visual
from .resources import find_file

ROUND = 32
"""Number of corners of a cylinder's circle."""


def matrix_of(origin: Origin) -> np.ndarray:
    """Convert an origin to a 4x4 matrix.

    >>> matrix_of(Origin((1.0, 2.0, 3.0)))[:, 3].tolist()
    [1.0, 2.0, 3.0, 1.0]
    """
    (cr, cp, cy), (sr, sp, sy) = np.cos(origin.rpy), np.sin(origin.rpy)
    result = np.eye(4)
    result[:3, :3] = [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
    result[:3, 3] = origin.xyz
    return result


def mesh_of(geometry: Geometry, near: Path | None = None) -> Any:
    """Return a shape in its own frame as one trimesh.Trimesh, with a mesh's scale applied. Raises MeshError.

    >>> from coursekit.urdf.model import Box
    >>> round(float(mesh_of(Box((1.0, 2.0, 3.0))).volume), 6)  # cubic metres
    6.0
    """
    import trimesh

    parts = surfaces_of(geometry, near)
    return trimesh.util.concatenate([trimesh.Trimesh(part.vertices, part.faces, process=False) for part in parts])


def surfaces_of(geometry: Geometry, near: Path | None = None) -> list[Surface]:
    """Return the surfaces of a shape in its own frame; a DAE, OBJ or GLB file may have several colours. Raises MeshError.

    >>> from coursekit.urdf.model import Box
    >>> (box,) = surfaces_of(Box((1.0, 2.0, 3.0)))
    >>> box.vertices.max(axis=0).tolist(), len(box.faces)
    ([0.5, 1.0, 1.5], 12)
    """
    if isinstance(geometry, Mesh):
        path = find_file(geometry.filename, near)
        return [_scaled(surface, geometry.scale) for surface in load_mesh(path).surfaces]
    return [_primitive(geometry)]


def notes_of(geometry: Geometry, near: Path | None = None) -> tuple[str, ...]:
    """Return a note for each part of a mesh file that is drawn in a simplified form. Raises MeshError."""
    if not isinstance(geometry, Mesh):
        return ()
    path = find_file(geometry.filename, near)
    return tuple(f"{path}: {note}" for note in load_mesh(path).notes)


@lru_cache(maxsize=256)
def _primitive(geometry: Box | Cylinder | Sphere) -> Surface:
    import trimesh

    if isinstance(geometry, Box):
        mesh = trimesh.creation.box(extents=geometry.size)
    elif isinstance(geometry, Cylinder):
        mesh = trimesh.creation.cylinder(radius=geometry.radius, height=geometry.length, sections=ROUND)
    else:
        mesh = trimesh.creation.icosphere(subdivisions=3).apply_scale(geometry.radius)  # its own radius cannot be 0
    return Surface(np.asarray(mesh.vertices, float), np.asarray(mesh.faces))


def _scaled(surface: Surface, scale: tuple[float, float, float]) -> Surface:
    if scale == (1.0, 1.0, 1.0):
        return surface
    faces = surface.faces if np.prod(scale) > 0 else surface.faces[:, ::-1]  # mirroring flips the orientation of faces
    return Surface(surface.vertices * np.array(scale), faces, surface.colour)


def link_surfaces(robot: Robot, link: Link | str, *, collision: bool = False) -> list[Surface]:
    """Return the surfaces of a link (visual or collision) in the link's frame: the visual's colour overrides the file's.

    Raises MeshError, which names the robot's file and the element.

    >>> from coursekit.urdf import parse
    >>> robot = parse('''<robot name="post"><link name="post"><visual><origin xyz="0 0 0.5"/>
    ...   <geometry><box size="0.1 0.1 1"/></geometry></visual></link></robot>''')
    >>> (post,) = link_surfaces(robot, "post")
    >>> sorted(set(post.vertices[:, 2].tolist()))
    [0.0, 1.0]
    """
    resolved = robot.link(link) if isinstance(link, str) else link
    surfaces: list[Surface] = []
    parts: Iterable[Visual | Collision] = resolved.collisions if collision else resolved.visuals
    for part in parts:
        matrix = matrix_of(part.origin)
        colour = part.material.colour if isinstance(part, Visual) and part.material is not None else None
        for surface in _part_surfaces(robot, resolved, part):
            vertices = surface.vertices @ matrix[:3, :3].T + matrix[:3, 3]
            surfaces.append(Surface(vertices, surface.faces, colour or surface.colour))
    return surfaces


def _part_surfaces(robot: Robot, link: Link, part: Visual | Collision) -> list[Surface]:
    try:
        return surfaces_of(part.geometry, robot.file)
    except MeshError as error:
        kind = "visual" if isinstance(part, Visual) else "collision"
        file = error.file if error.line or os.sep in error.file else str(robot.file or robot.name)
        line = part.line if file != error.file else 0
        element = f'<{kind}> of <link name="{link.name}">'
        raise MeshError(error.what, file=file, line=line, element=element, cure=error.cure) from None


def robot_surfaces(
    robot: Robot, positions: dict[str, float] | None = None, *, collision: bool = False
) -> Iterator[tuple[str, Surface]]:
    """Yield (link name, surface in the root's frame) for the whole robot, with its joints at `positions`."""
    kinematics = Kinematics(robot)
    for name, matrix in zip(kinematics.links, kinematics.matrices(positions), strict=True):
        for surface in link_surfaces(robot, name, collision=collision):
            yield name, Surface(surface.vertices @ matrix[:3, :3].T + matrix[:3, 3], surface.faces, surface.colour)


__all__ = ["GREY", "Surface", "link_surfaces", "matrix_of", "mesh_of", "notes_of", "robot_surfaces", "surfaces_of"]
