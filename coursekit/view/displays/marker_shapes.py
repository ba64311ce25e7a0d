"""The shapes of visualization_msgs/Marker, by type."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from coursekit.urdf import Mesh
from coursekit.urdf.shapes import surfaces_of
from coursekit.view.scene_shapes import (
    Band,
    Colour,
    Label,
    Points,
    Shape,
    Triangles,
    arrow,
    ball,
    box,
    scattered,
    towards,
    tube,
)

from .poses import ribbon

if TYPE_CHECKING:
    from visualization_msgs.msg import Marker


def shapes_of(msg: Marker) -> list[Shape]:
    """Return a marker's shapes in its own frame; ValueError (or its subclass MeshError) if it cannot be shown."""
    make = _MAKERS.get(msg.type)
    if make is None:
        raise ValueError(f"there is no marker type {msg.type}")
    return make(msg)


def _colour(msg: Marker) -> Colour:
    return (msg.color.r, msg.color.g, msg.color.b, msg.color.a)


def _points(msg: Marker, multiple: int = 1) -> np.ndarray:
    points = np.array([(point.x, point.y, point.z) for point in msg.points], float).reshape(-1, 3)
    if len(points) % multiple:
        raise ValueError(f"{len(points)} points, not a multiple of {multiple}")
    return points


def _colours(msg: Marker, count: int) -> np.ndarray | None:
    if not msg.colors:
        return None
    if len(msg.colors) != count:
        raise ValueError(f"{len(msg.colors)} colors for {count} points")
    return np.array([(color.r, color.g, color.b, color.a) for color in msg.colors])


def _scale(msg: Marker) -> np.ndarray:
    return np.array([msg.scale.x, msg.scale.y, msg.scale.z])


def _body(msg: Marker, body: tuple[np.ndarray, np.ndarray]) -> list[Shape]:
    return [Triangles(body[0] * _scale(msg), body[1], _colour(msg))]


def _cylinder(msg: Marker) -> list[Shape]:
    vertices, faces = tube(-0.5, 0.5, 0.5, sides=24)
    return _body(msg, (vertices[:, [2, 1, 0]] * (1, -1, 1), faces))


def _arrow(msg: Marker) -> list[Shape]:
    """Return an arrow along x from the pose, or between two points.

    Between points, scale.x is the shaft's diameter, scale.y the head's diameter, scale.z the head's length.
    """
    if not msg.points:
        long, wide = msg.scale.x, msg.scale.y
        shape = arrow(0.77 * long, wide / 4, 0.23 * long, wide / 2, _colour(msg))
        return [Triangles(shape.vertices * (1, 1, msg.scale.z / wide if wide else 1), shape.faces, shape.colour)]
    if len(msg.points) != 2:
        raise ValueError(f"an arrow has 0 or 2 points, not {len(msg.points)}")
    start, end = _points(msg)
    length = float(np.linalg.norm(end - start))
    if length < 1e-9:
        return []
    head = msg.scale.z or 0.23 * length
    head = min(head, length)
    shape = arrow(length - head, msg.scale.x / 2, head, msg.scale.y / 2, _colour(msg))
    return [Triangles(shape.vertices @ towards(end - start).T + start, shape.faces, shape.colour)]


def _line(msg: Marker, pairs: bool) -> list[Shape]:
    points = _points(msg, 2 if pairs else 1)
    colours = _colours(msg, len(points))
    starts, ends = (points[0::2], points[1::2]) if pairs else (points[:-1], points[1:])
    if not len(starts):
        return []
    if not pairs and colours is None:
        return [ribbon(points, msg.scale.x, _colour(msg))]
    bands = [ribbon(np.stack([a, b]), msg.scale.x, _colour(msg)) for a, b in zip(starts, ends, strict=True)]
    shifts = np.arange(len(bands))[:, None, None] * 4
    faces = (np.stack([band.faces for band in bands]) + shifts).reshape(-1, 3)
    each = None if colours is None else np.repeat(colours[0::2] if pairs else colours[:-1], 2, axis=0)
    ends = np.concatenate([band.ends for band in bands])
    both = colours if pairs or colours is None else np.stack([colours[:-1], colours[1:]], axis=1).reshape(-1, 4)
    shades = None if both is None else both[:, :3]
    vertices = np.concatenate([band.vertices for band in bands])
    return [Band(vertices, faces, _colour(msg), each, ends, float(msg.scale.x), shades)]


def _list(msg: Marker, body: tuple[np.ndarray, np.ndarray]) -> list[Shape]:
    points = _points(msg)
    colours = _colours(msg, len(points))
    if not len(points):
        return []
    vertices, faces = scattered((body[0] * _scale(msg), body[1]), points)
    each = None if colours is None else np.repeat(colours, len(body[1]), axis=0)
    return [Triangles(vertices, faces, _colour(msg), each)]


def _dots(msg: Marker) -> list[Shape]:
    points = _points(msg)
    colours = _colours(msg, len(points))
    if not len(points):
        return []
    return [Points(points, msg.scale.x, _colour(msg), None if colours is None else colours[:, :3])]


def _text(msg: Marker) -> list[Shape]:
    return [Label(msg.text, _colour(msg), msg.scale.z)]


def _mesh(msg: Marker) -> list[Shape]:
    scale = tuple(float(size) for size in _scale(msg))
    surfaces = surfaces_of(Mesh(msg.mesh_resource, scale), Path.cwd())  # type: ignore[arg-type]
    own = msg.mesh_use_embedded_materials
    return [Triangles(surface.vertices, surface.faces, surface.colour if own else _colour(msg)) for surface in surfaces]


def _triangle_list(msg: Marker) -> list[Shape]:
    points = _points(msg, 3)
    if not len(points):
        return []
    each: np.ndarray | None
    if len(msg.colors) == len(points) // 3:
        each = np.array([(color.r, color.g, color.b, color.a) for color in msg.colors])
    else:
        every = _colours(msg, len(points))
        each = None if every is None else every.reshape(-1, 3, 4).mean(axis=1)
    faces = np.arange(len(points)).reshape(-1, 3)
    return [Triangles(points * _scale(msg), faces, _colour(msg), each)]


_MAKERS: dict[int, Callable[[Any], list[Shape]]] = {
    0: _arrow,
    1: lambda msg: _body(msg, box()),
    2: lambda msg: _body(msg, ball(3)),
    3: _cylinder,
    4: lambda msg: _line(msg, False),
    5: lambda msg: _line(msg, True),
    6: lambda msg: _list(msg, box()),
    7: lambda msg: _list(msg, ball(1)),
    8: _dots,
    9: _text,
    10: _mesh,
    11: _triangle_list,
}

__all__ = ["shapes_of"]
