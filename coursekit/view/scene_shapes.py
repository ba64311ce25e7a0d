"""The shapes of a scene: triangles, lines, points, pictures and labels, as arrays."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

Colour = tuple[float, float, float, float]
"""Red, green, blue, alpha from 0 to 1"""
Body = tuple[np.ndarray, np.ndarray]
"""Vertices (n, 3) and faces (m, 3)"""
CREASE = math.cos(math.radians(40))
"""Cosine of the angle between faces below which they are shaded as one smooth surface."""


@dataclass(frozen=True, eq=False)
class Triangles:
    """Filled triangles; `colours` (m, 4), one for each face, take precedence over `colour`."""

    vertices: np.ndarray
    """(n, 3) [m]"""
    faces: np.ndarray
    """(m, 3) indices"""
    colour: Colour
    colours: np.ndarray | None = None


@dataclass(frozen=True, eq=False)
class Band(Triangles):
    """A band along line segments. A page turns it towards the viewer, and never draws it too thin to see."""

    ends: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    """(2n, 3) [m], from each even point to the odd one after it"""
    width: float = 0.0
    """[m]"""
    end_colours: np.ndarray | None = None
    """(2n, 3)"""


@dataclass(frozen=True, eq=False)
class Lines:
    """Lines from each even point to the odd one after it, `pixels` wide; `colours` (2n, 3) take precedence over `colour`."""

    points: np.ndarray
    """(2n, 3) [m]"""
    colour: Colour
    colours: np.ndarray | None = None
    pixels: float = 1.0


@dataclass(frozen=True, eq=False)
class Points:
    """Dots of `size` metres, or screen pixels; `colours` (n, 3) take precedence over `colour`."""

    points: np.ndarray
    """(n, 3) [m]"""
    size: float
    colour: Colour
    colours: np.ndarray | None = None
    pixels: bool = False


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture in the plane z = 0, its lower left corner at the origin."""

    image: np.ndarray
    """(rows, columns, 4) uint8, RGBA, top row first"""
    width: float
    """[m]"""
    height: float
    """[m]"""
    alpha: float = 1.0


@dataclass(frozen=True)
class Label:
    """A text that faces the viewer; `height` in metres, or 0 for small text of constant screen size."""

    text: str
    colour: Colour = (0.15, 0.2, 0.25, 1.0)
    height: float = 0.0

    @property
    def light(self) -> bool:
        """Whether the text is too light for the light floor and needs a dark rim; small text has a fixed colour.

        >>> Label("A", (1.0, 1.0, 0.2, 1.0), height=0.5).light
        True
        """
        red, green, blue = (round(value * 255) for value in self.colour[:3])
        return self.height > 0.0 and 0.2126 * red + 0.7152 * green + 0.0722 * blue > 150


Shape = Triangles | Band | Lines | Points | Picture | Label


def colour_of(rgb: list[int] | tuple[int, ...], alpha: float = 1.0) -> Colour:
    """Make a colour from values of 0 to 255.

    >>> colour_of([255, 0, 51])
    (1.0, 0.0, 0.2, 1.0)
    """
    red, green, blue = (value / 255.0 for value in rgb)
    return red, green, blue, alpha


def rotation(quaternions: np.ndarray) -> np.ndarray:
    """Convert (n, 4) quaternions x, y, z, w to (n, 3, 3) rotation matrices.

    >>> rotation(np.array([[0.0, 0.0, 1.0, 0.0]]))[0].tolist()
    [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]
    """
    x, y, z, w = np.moveaxis(np.asarray(quaternions, float), -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


@lru_cache(maxsize=64)
def box(x: float = 1.0, y: float = 1.0, z: float = 1.0) -> Body:
    """Return vertices and faces of a box centred on the origin.

    >>> vertices, faces = box(2.0, 1.0, 1.0)
    >>> vertices.shape, faces.shape, float(vertices[:, 0].max())
    ((8, 3), (12, 3), 1.0)
    """
    import trimesh

    mesh = trimesh.creation.box(extents=(x, y, z))
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


@lru_cache(maxsize=8)
def ball(fine: int = 2) -> Body:
    """Return vertices and faces of a ball of diameter 1.

    >>> vertices, faces = ball(0)
    >>> vertices.shape, faces.shape
    ((12, 3), (20, 3))
    """
    import trimesh

    mesh = trimesh.creation.icosphere(subdivisions=fine, radius=0.5)
    return np.asarray(mesh.vertices), np.asarray(mesh.faces)


@lru_cache(maxsize=64)
def tube(start: float, end: float, radius: float, tip: float | None = None, sides: int = 16) -> Body:
    """Return a cylinder along x from `start` to `end`; the radius at `end` is `tip`, where 0 makes a cone.

    >>> vertices, faces = tube(0.0, 2.0, 0.1, sides=8)
    >>> vertices.min(axis=0).round(2).tolist(), faces.shape
    ([0.0, -0.1, -0.1], (32, 3))
    """
    turn = np.arange(sides) * (2 * np.pi / sides)
    ring = np.stack([np.zeros(sides), np.cos(turn), np.sin(turn)], axis=1)
    far = radius if tip is None else tip
    near_ring, far_ring = ring * radius + [start, 0, 0], ring * far + [end, 0, 0]
    vertices = np.concatenate([near_ring, far_ring, [[start, 0, 0], [end, 0, 0]]])
    here, there = np.arange(sides), (np.arange(sides) + 1) % sides
    faces = [(here, there, there + sides), (here, there + sides, here + sides)]
    faces += [(there, here, np.full(sides, 2 * sides)), (here + sides, there + sides, np.full(sides, 2 * sides + 1))]
    return vertices, np.concatenate([np.stack(face, axis=1) for face in faces])


def arrow(length: float, radius: float, head: float, head_radius: float, colour: Colour) -> Triangles:
    """Return an arrow along x: a shaft of `length`, followed by a head [m].

    >>> arrow(1.0, 0.05, 0.3, 0.1, (1.0, 0.0, 0.0, 1.0)).vertices.max(axis=0).round(2).tolist()
    [1.3, 0.1, 0.1]
    """
    return join([tube(0.0, length, radius), tube(length, length + head, head_radius, 0.0)], colour)


def join(parts: list[Body], colour: Colour) -> Triangles:
    """Join several bodies to one shape.

    >>> join([tube(0.0, 1.0, 0.1), ball(0)], (1.0, 0.0, 0.0, 1.0)).faces.shape
    (84, 3)
    """
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in parts)])
    faces = [triangles + start for (_, triangles), start in zip(parts, starts, strict=False)]
    return Triangles(np.concatenate([vertices for vertices, _ in parts]), np.concatenate(faces), colour)


def scattered(body: Body, places: np.ndarray, turns: np.ndarray | None = None) -> Body:
    """Copy a body to many positions (n, 3), rotated by quaternions (n, 4), as one body.

    >>> vertices, _ = scattered(box(), np.array([[0.0, 0.0, 0.0], [5.0, 0.0, 0.0]]))
    >>> len(vertices), float(vertices[:, 0].max())
    (16, 5.5)
    """
    vertices, faces = body
    turned = np.broadcast_to(vertices, (len(places), *vertices.shape))
    if turns is not None:
        turned = np.einsum("nij,vj->nvi", rotation(turns), vertices)
    shifts = np.arange(len(places))[:, None, None] * len(vertices)
    return (turned + places[:, None, :]).reshape(-1, 3), (faces[None] + shifts).reshape(-1, 3)


def towards(direction: np.ndarray) -> np.ndarray:
    """Return a rotation that maps the x axis to a direction.

    >>> (towards(np.array([0.0, 2.0, 0.0])) @ [1.0, 0.0, 0.0]).tolist()
    [0.0, 1.0, 0.0]
    """
    x = direction / np.linalg.norm(direction)
    other = np.array([0.0, 0.0, 1.0]) if abs(x[2]) < 0.9 else np.array([0.0, 1.0, 0.0])
    y = np.cross(other, x)
    y /= np.linalg.norm(y)
    return np.stack([x, y, np.cross(x, y)], axis=1)


def simpler(body: Body, most: int) -> Body:
    """Simplify a body to about `most` faces at most, by merging corners that are near each other.

    >>> fine = ball(4)
    >>> len(fine[1]), len(simpler(fine, 500)[1]) <= 500
    (5120, True)
    """
    cells = 128.0
    simplified = body
    while len(simplified[1]) > most and cells >= 2:
        simplified = _clustered(body, cells)
        cells = min(cells * 0.8, cells * math.sqrt(most / max(1, len(simplified[1]))))
    return simplified


def _clustered(body: Body, cells: float) -> Body:
    """Merge the corners in each cell of a lattice to their mean; `cells` is the number of cells along the longest edge."""
    vertices, faces = body
    low = vertices.min(axis=0)
    edge = max(float(np.ptp(vertices, axis=0).max()) / cells, 1e-12)
    lattice = ((vertices - low) / edge).astype(np.int64)
    _, place = np.unique(lattice @ (1, 1 << 21, 1 << 42), return_inverse=True)
    count = np.bincount(place)
    means = np.stack([np.bincount(place, vertices[:, axis]) / count for axis in range(3)], axis=1)
    corners = place.ravel()[faces]
    flat = (corners[:, 0] == corners[:, 1]) | (corners[:, 1] == corners[:, 2]) | (corners[:, 2] == corners[:, 0])
    corners = corners[~flat]
    _, first = np.unique(np.sort(corners, axis=1) @ (1, 1 << 21, 1 << 42), return_index=True)
    return means, corners[np.sort(first)]


def corner_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return the normal of each corner of each face (3m, 3): smooth across flat edges, sharp across others.

    >>> corner_normals(np.eye(3), np.array([[0, 1, 2]])).round(2)
    array([[0.58, 0.58, 0.58],
           [0.58, 0.58, 0.58],
           [0.58, 0.58, 0.58]])
    """
    from scipy.sparse import csr_matrix

    corners = vertices[faces]
    area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    flat = area / np.maximum(np.linalg.norm(area, axis=1, keepdims=True), 1e-30)
    _, place = np.unique(np.round(corners.reshape(-1, 3), 6), axis=0, return_inverse=True)
    count = len(faces) * 3
    held = csr_matrix((np.ones(count), (np.arange(count), place.ravel())))
    pairs = (held @ held.T).tocoo()
    mine, other = pairs.row // 3, pairs.col // 3
    smooth = np.einsum("ij,ij->i", flat[mine], flat[other]) > CREASE
    total = np.stack([np.bincount(pairs.row[smooth], area[other[smooth], axis], count) for axis in range(3)], axis=1)
    return total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-30)


__all__ = [
    "Colour",
    "Label",
    "Lines",
    "Picture",
    "Points",
    "Shape",
    "Triangles",
    "arrow",
    "ball",
    "box",
    "colour_of",
    "corner_normals",
    "join",
    "rotation",
    "scattered",
    "simpler",
    "towards",
    "tube",
]
