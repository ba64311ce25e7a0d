"""Shapes as triangles: what viewers draw and simulators bump into."""

from __future__ import annotations

import io
import os
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from coursekit.files import read_bytes

from .errors import MeshError
from .kinematics import Kinematics
from .model import Box, Collision, Colour, Cylinder, Geometry, Link, Mesh, Origin, Robot, Sphere, Visual
from .resources import find_file

GREY: Colour = (0.7, 0.7, 0.7, 1.0)
"""What has no material: as grey as a part fresh from the machine."""
FORMATS = (".stl", ".dae", ".obj", ".ply", ".glb", ".gltf", ".off")
_MATERIALS = re.compile(rb"<bind_material\b.*?</bind_material>", re.DOTALL)
"""Where a DAE file looks for a texture that is not there, its reader leaves the whole shape out."""
ROUND = 32
"""Corners of a cylinder's circle."""


@dataclass(frozen=True)
class Surface:
    """Triangles of one colour, in the frame of a link."""

    vertices: np.ndarray
    """(n, 3) float64 [m]"""
    faces: np.ndarray
    """(m, 3) int64, corners counter-clockwise seen from outside"""
    colour: Colour = GREY


def matrix_of(origin: Origin) -> np.ndarray:
    """An origin as a 4x4 matrix."""
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
    """A shape in its own frame as one trimesh.Trimesh, a mesh's scale applied. Raises MeshError."""
    import trimesh

    parts = surfaces_of(geometry, near)
    return trimesh.util.concatenate([trimesh.Trimesh(one.vertices, one.faces, process=False) for one in parts])


def surfaces_of(geometry: Geometry, near: Path | None = None) -> list[Surface]:
    """A shape in its own frame; a DAE, OBJ or GLB file may have several colours. Raises MeshError."""
    if isinstance(geometry, Mesh):
        path = find_file(geometry.filename, near)
        return [_scaled(one, geometry.scale) for one in _load(path, path.stat().st_mtime_ns)]
    return [_primitive(geometry)]


@lru_cache(maxsize=256)
def _primitive(geometry: Box | Cylinder | Sphere) -> Surface:
    import trimesh

    if isinstance(geometry, Box):
        made = trimesh.creation.box(extents=geometry.size)
    elif isinstance(geometry, Cylinder):
        made = trimesh.creation.cylinder(radius=geometry.radius, height=geometry.length, sections=ROUND)
    else:
        made = trimesh.creation.icosphere(subdivisions=3, radius=geometry.radius)
    return Surface(np.asarray(made.vertices, float), np.asarray(made.faces))


def _scaled(surface: Surface, scale: tuple[float, float, float]) -> Surface:
    if scale == (1.0, 1.0, 1.0):
        return surface
    faces = surface.faces if np.prod(scale) > 0 else surface.faces[:, ::-1]  # a mirrored shape stays outside out
    return Surface(surface.vertices * np.array(scale), faces, surface.colour)


@lru_cache(maxsize=256)
def _load(path: Path, _changed: int) -> tuple[Surface, ...]:
    """The surfaces of a mesh file, as long as the file does not change."""
    if path.suffix.lower() not in FORMATS:
        raise MeshError(
            f"cannot read '{path.suffix}' files as meshes",
            file=str(path),
            cure=f"Save it as one of: {', '.join(FORMATS)}.",
        )
    try:
        data = read_bytes(path)
        parts = _parts(path)
        if not parts and path.suffix.lower() == ".dae":
            parts = _parts(path, io.BytesIO(_MATERIALS.sub(b"", data)))
    except Exception as error:  # the readers of six formats fail in as many ways
        what = f"is no {path.suffix[1:].upper()} mesh that can be read: {type(error).__name__}: {error}"
        raise MeshError(what, file=str(path), cure="Export it again, or try another format.") from None
    if not parts or not any(len(part.faces) for part in parts):
        raise MeshError("has no triangles", file=str(path), cure="Is the file complete? Export it again.")
    return tuple(parts)


def _parts(path: Path, data: io.BytesIO | None = None) -> list[Surface]:
    import trimesh

    kind = path.suffix[1:].lower()
    scene = trimesh.load_scene(path) if data is None else trimesh.load_scene(data, file_type=kind)
    if kind == "dae" and scene.units:  # COLLADA says its unit; RViz and Gazebo heed it, as we do
        scene = scene.convert_units("meters")
    return [_surface(part) for part in scene.dump() if isinstance(part, trimesh.Trimesh)]


def _surface(mesh: Any) -> Surface:
    colour = GREY
    material = getattr(mesh.visual, "material", None)
    if material is not None and getattr(material, "main_color", None) is not None:
        red, green, blue, alpha = (float(one) / 255.0 for one in material.main_color)
        colour = (red, green, blue, alpha)
    return Surface(np.asarray(mesh.vertices, float), np.asarray(mesh.faces), colour)


def link_surfaces(robot: Robot, link: Link | str, *, collision: bool = False) -> list[Surface]:
    """What a link looks like (or bumps with), in the link's frame: the visual's colour wins over the file's.

    Raises MeshError, which names the robot's file and the element.
    """
    one = robot.link(link) if isinstance(link, str) else link
    found: list[Surface] = []
    parts: Iterable[Visual | Collision] = one.collisions if collision else one.visuals
    for part in parts:
        matrix = matrix_of(part.origin)
        colour = part.material.colour if isinstance(part, Visual) and part.material is not None else None
        for surface in _part_surfaces(robot, one, part):
            vertices = surface.vertices @ matrix[:3, :3].T + matrix[:3, 3]
            found.append(Surface(vertices, surface.faces, colour or surface.colour))
    return found


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
    """(link name, surface in the root's frame) of the whole robot, with its joints at `positions`."""
    kinematics = Kinematics(robot)
    for name, matrix in zip(kinematics.links, kinematics.matrices(positions), strict=True):
        for surface in link_surfaces(robot, name, collision=collision):
            yield name, Surface(surface.vertices @ matrix[:3, :3].T + matrix[:3, 3], surface.faces, surface.colour)


__all__ = ["GREY", "Surface", "link_surfaces", "matrix_of", "mesh_of", "robot_surfaces", "surfaces_of"]
