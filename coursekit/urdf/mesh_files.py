"""Mesh files as triangles; every error in one becomes a MeshError."""

from __future__ import annotations

import io
import logging
import re
from contextvars import ContextVar
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from coursekit.files import read_bytes

from .errors import MeshError
from .model import Colour

GREY: Colour = (0.7, 0.7, 0.7, 1.0)
"""The colour of parts without a material: a machined-metal grey."""
FORMATS = (".stl", ".dae", ".obj", ".ply", ".glb", ".gltf", ".off")
MOST_FACES = 5_000_000
"""Maximum number of triangles in a file; a scan with more fills the memory of a laptop."""
_MATERIALS = re.compile(rb"<bind_material\b.*?</bind_material>", re.DOTALL)
"""The DAE reader drops the whole shape if a texture is missing, so material bindings are removed."""
_COUNTS = re.compile(rb'"count"\s*:\s*(\d+)|^element \w+ (\d+)', re.MULTILINE)
"""The sizes declared in a GLB or PLY file: its reader allocates memory for them first."""
_reading: ContextVar[bool] = ContextVar("_reading", default=False)
logging.getLogger("trimesh").addFilter(lambda _record: not _reading.get())  # it logs tracebacks; MeshError replaces them


@dataclass(frozen=True)
class Surface:
    """Triangles of one colour, in the frame of a link."""

    vertices: np.ndarray
    """(n, 3) float64 [m]"""
    faces: np.ndarray
    """(m, 3) int64, corners counter-clockwise seen from outside"""
    colour: Colour = GREY


@dataclass(frozen=True)
class MeshFile:
    """The content of a file, and a note for each part that is drawn in a simplified form."""

    surfaces: tuple[Surface, ...]
    notes: tuple[str, ...] = ()


def load_mesh(path: Path) -> MeshFile:
    """Load a mesh file, cached until it changes. Raises MeshError."""
    try:
        changed = path.stat().st_mtime_ns
    except (OSError, ValueError) as error:
        raise MeshError(f"cannot be read: {error}", file=str(path), cure="Check the path of the mesh.") from None
    return _load(path, changed)


@lru_cache(maxsize=256)
def _load(path: Path, _changed: int) -> MeshFile:
    kind = path.suffix.lower()
    if kind not in FORMATS:
        raise MeshError(
            f"cannot read '{path.suffix}' files as meshes", file=str(path), cure=f"Save it as one of: {', '.join(FORMATS)}."
        )
    token = _reading.set(True)
    try:
        with np.errstate(all="ignore"):
            mesh = _read(path, kind)
    except Exception as error:  # the readers of six formats raise all kinds of exceptions
        what = f"is no {kind[1:].upper()} mesh that can be read: {type(error).__name__}: {error}"
        raise MeshError(what[:500], file=str(path), cure="Export it again, or try another format.") from None
    finally:
        _reading.reset(token)
    if not any(len(surface.faces) for surface in mesh.surfaces):
        raise MeshError("has no triangles", file=str(path), cure="Is the file complete? Export it again.")
    return mesh


def _read(path: Path, kind: str) -> MeshFile:
    from .textures import Beside

    data, beside = read_bytes(path), Beside(path)
    counts = _COUNTS.findall(data, 0, 1 << 22) if kind in (".glb", ".gltf", ".ply") else ()
    promised = max((int(gltf or ply) for gltf, ply in counts), default=0)
    if promised > 3 * MOST_FACES:
        raise ValueError(f"it promises {promised} numbers; {3 * MOST_FACES} are the most")
    surfaces = _parts(data, kind, beside)
    if not surfaces and kind == ".dae":
        surfaces = _parts(_MATERIALS.sub(b"", data), kind, beside)
    return MeshFile(tuple(surfaces), tuple(beside.notes))


def _parts(data: bytes, kind: str, beside: Any) -> list[Surface]:
    import trimesh

    scene = trimesh.load_scene(io.BytesIO(data), file_type=kind[1:], resolver=beside)
    if kind == ".dae" and scene.units:  # COLLADA specifies its unit; RViz and Gazebo respect it, too
        scene = scene.convert_units("meters")
    meshes = [part for part in scene.dump() if isinstance(part, trimesh.Trimesh)]
    if sum(len(mesh.faces) for mesh in meshes) > MOST_FACES:
        raise ValueError(f"more than {MOST_FACES} triangles")
    return [_surface(part) for part in meshes]


def _surface(mesh: Any) -> Surface:
    vertices, faces = np.asarray(mesh.vertices, float), np.asarray(mesh.faces)
    if not np.isfinite(vertices).all():
        raise ValueError("a corner that is no finite number")
    if len(faces) and not 0 <= int(faces.min()) <= int(faces.max()) < len(vertices):
        raise ValueError("a triangle with a corner that is not there")
    return Surface(vertices, faces, _colour(getattr(mesh.visual, "material", None)))


def _colour(material: Any) -> Colour:
    """Return a material's colour: its main colour times the mean of its texture."""
    from .textures import mean_of

    if material is None or getattr(material, "main_color", None) is None:
        return GREY
    red, green, blue, alpha = (float(value) / 255.0 for value in material.main_color)
    picture = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
    try:
        tint = mean_of(picture) if picture is not None else (255, 255, 255)
    except Exception:  # a broken texture embedded in the file
        tint = (255, 255, 255)
    return red * tint[0] / 255.0, green * tint[1] / 255.0, blue * tint[2] / 255.0, alpha


__all__ = ["FORMATS", "GREY", "MeshFile", "Surface", "load_mesh"]
