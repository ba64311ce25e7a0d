"""Changes of a scene as bytes for MeshCat's viewer: msgpack commands for shapes, one array for all poses."""

from __future__ import annotations

import base64
from typing import Any

import cv2
import numpy as np
import umsgpack

from .scene import Changes, Thing
from .scene_shapes import Band, Colour, Label, Lines, Picture, Points, Triangles, corner_normals

_FLOAT = 0x17
"""The msgpack extension code of MeshCat's Float32Array"""
THINNEST = 2.0
"""The minimum width of a band on the page [pixels]."""
_DOUBLE_SIDED, _NEAREST = 2, 1003
BLOCK = 11
"""The numbers per pose: the thing's number, position, quaternion, scale"""


def packed(changes: Changes) -> tuple[dict[str, Any], list[bytes]]:
    """Return (message, buffers): the first buffer holds all poses, the others are commands."""
    labels: list[dict[str, Any]] = []
    commands: list[bytes] = []
    for thing in changes.made:
        for index, shape in enumerate(thing.shapes):
            if isinstance(shape, Label):
                looks = {"height": shape.height, "colour": css(shape.colour), "light": shape.light}
                labels.append({"of": thing.number, "text": shape.text, **looks})
            else:
                commands.append(_command(f"/scene/{thing.number}/{index}", shape))
    poses = np.array([_numbers(thing) for thing in (*changes.made, *changes.moved)], dtype="<f8")
    solid = [[thing.number, thing.solid] for thing in changes.made if thing.solid]
    return {"gone": changes.gone, "labels": labels, "solid": solid}, [poses.tobytes(), *commands]


def _numbers(thing: Thing) -> tuple[float, ...]:
    return (float(thing.number), *thing.pose, *thing.scale)


def css(colour: Colour) -> str:
    """Convert a colour to CSS.

    >>> css((1.0, 0.0, 0.0, 0.5))
    'rgba(255, 0, 0, 0.5)'
    """
    red, green, blue = (round(value * 255) for value in colour[:3])
    return f"rgba({red}, {green}, {blue}, {colour[3]:g})"


def _command(path: str, shape: Any) -> bytes:
    lower: Any = {Triangles: _triangles, Band: _band, Lines: _lines, Points: _points, Picture: _picture}[type(shape)]
    return umsgpack.packb({"type": "set_object", "path": path, "object": lower(path, shape)})


def _array(values: np.ndarray, size: int = 3) -> dict[str, Any]:
    data = np.ascontiguousarray(values, dtype="<f4").tobytes()
    return {"itemSize": size, "type": "Float32Array", "array": umsgpack.Ext(_FLOAT, data), "normalized": False}


def _object(path: str, kind: str, attributes: dict[str, Any], material: dict[str, Any], **extra: Any) -> dict[str, Any]:
    geometry, look = f"{path}g", f"{path}m"
    return {
        "metadata": {"version": 4.5, "type": "Object"},
        "geometries": [{"uuid": geometry, "type": "BufferGeometry", "data": {"attributes": attributes}}],
        "materials": [{"uuid": look, **material}],
        "object": {"uuid": path, "type": kind, "geometry": geometry, "material": look, "matrix": _EYE},
        **extra,
    }


_EYE = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]


def _paint(colour: Colour, colours: np.ndarray | None) -> dict[str, Any]:
    red, green, blue = (round(min(max(value, 0.0), 1.0) * 255) for value in colour[:3])
    look: dict[str, Any] = {"color": (red << 16) + (green << 8) + blue, "opacity": colour[3], "transparent": colour[3] < 1.0}
    return look if colours is None else {**look, "color": 0xFFFFFF, "vertexColors": 2}


def _triangles(path: str, shape: Triangles) -> dict[str, Any]:
    normals = corner_normals(shape.vertices, shape.faces)
    attributes = {"position": _array(shape.vertices[shape.faces]), "normal": _array(normals)}
    alpha = shape.colour[3]
    if shape.colours is not None:
        attributes["color"] = _array(np.repeat(shape.colours[:, :3], 3, axis=0))
        alpha = float(shape.colours[:, 3].min()) if len(shape.colours) else 1.0
    look = {"type": "MeshPhongMaterial", "shininess": 12, "specular": 0x181818, "side": _DOUBLE_SIDED}
    return _object(path, "Mesh", attributes, {**look, **_paint((*shape.colour[:3], alpha), shape.colours)})


def _lines(path: str, shape: Lines) -> dict[str, Any]:
    attributes = {"position": _array(shape.points)}
    if shape.colours is not None:
        attributes["color"] = _array(shape.colours)
    wide = {"least": shape.pixels} if shape.pixels > 1.0 else {}
    return _segments(path, attributes, _paint(shape.colour, shape.colours), wide)


def _band(path: str, shape: Band) -> dict[str, Any]:
    attributes = {"position": _array(shape.ends)}
    if shape.end_colours is not None:
        attributes["color"] = _array(shape.end_colours)
    wide = {"metres": shape.width, "least": THINNEST}
    return _segments(path, attributes, _paint(shape.colour, shape.end_colours), wide)


def _segments(path: str, attributes: dict[str, Any], paint: dict[str, Any], wide: dict[str, float]) -> dict[str, Any]:
    """Return line segments; `wide` tells the page how wide to draw them."""
    segments = _object(path, "LineSegments", attributes, {"type": "LineBasicMaterial", **paint})
    segments["object"]["userData"] = wide
    return segments


def _points(path: str, shape: Points) -> dict[str, Any]:
    attributes = {"position": _array(shape.points)}
    if shape.colours is not None:
        attributes["color"] = _array(shape.colours)
    look = {"type": "PointsMaterial", "size": shape.size, "sizeAttenuation": not shape.pixels}
    return _object(path, "Points", attributes, {**look, **_paint(shape.colour, shape.colours)})


def _picture(path: str, shape: Picture) -> dict[str, Any]:
    w, h = shape.width, shape.height
    corners = np.array([[0, 0, 0], [w, 0, 0], [w, h, 0], [0, 0, 0], [w, h, 0], [0, h, 0]], float)
    spots = np.array([[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]], float)
    attributes = {"position": _array(corners), "uv": _array(spots, 2), "normal": _array(np.tile([0.0, 0.0, 1.0], (6, 1)))}
    bgra = np.ascontiguousarray(shape.image[:, :, [2, 1, 0, 3]])
    data = base64.b64encode(cv2.imencode(".png", bgra, (cv2.IMWRITE_PNG_COMPRESSION, 3))[1].tobytes()).decode()
    texture = {"uuid": f"{path}t", "image": f"{path}i", "wrap": [1001, 1001], "repeat": [1, 1]}
    look = {"type": "MeshBasicMaterial", "color": 0xFFFFFF, "map": f"{path}t", "side": _DOUBLE_SIDED, "depthWrite": False}
    return _object(
        path,
        "Mesh",
        attributes,
        {**look, "transparent": True, "opacity": shape.alpha},
        textures=[{**texture, "magFilter": _NEAREST, "minFilter": _NEAREST}],
        images=[{"uuid": f"{path}i", "url": f"data:image/png;base64,{data}"}],
    )


__all__ = ["BLOCK", "css", "packed"]
