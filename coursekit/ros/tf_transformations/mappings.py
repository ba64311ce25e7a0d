"""Matrices that reflect, scale, shear, project and clip, and the recovery of their parameters."""

from __future__ import annotations

import math

import numpy as np

from .vectors import EPS, Array, Matrix, Vector, unit_vector


def _vector(values: Vector) -> Array:
    return np.asarray(values, dtype=np.float64)[:3]


def _matrix(linear: Array, move: Array) -> Array:
    matrix = np.identity(4)
    matrix[:3, :3] = linear
    matrix[:3, 3] = move
    return matrix


def reflection_matrix(point: Vector, normal: Vector) -> Array:
    """The reflection in the plane through `point` with that normal."""
    n = unit_vector(_vector(normal))
    return _matrix(np.identity(3) - 2.0 * np.outer(n, n), 2.0 * (_vector(point) @ n) * n)


def reflection_from_matrix(matrix: Matrix) -> tuple[Array, Array]:
    """The point of the reflection plane nearest to the origin, and the normal of the plane."""
    m = np.asarray(matrix, dtype=np.float64)
    values, vectors = np.linalg.eigh(m[:3, :3])
    if abs(values[0] + 1.0) > 1e-8:
        raise ValueError("no reflection: no direction is reversed")
    return m[:3, 3] / 2.0, vectors[:, 0]


def scale_matrix(factor: float, origin: Vector | None = None, direction: Vector | None = None) -> Array:
    """The scaling about `origin`, in all directions or along one."""
    if direction is None:
        linear = np.identity(3) * factor
    else:
        d = unit_vector(_vector(direction))
        linear = np.identity(3) + (factor - 1.0) * np.outer(d, d)
    centre = np.zeros(3) if origin is None else _vector(origin)
    return _matrix(linear, centre - linear @ centre)


def scale_from_matrix(matrix: Matrix) -> tuple[float, Array, Array | None]:
    """Factor, origin, and direction (None if it scales in all directions)."""
    m = np.asarray(matrix, dtype=np.float64)
    factor = float(np.trace(m[:3, :3])) - 2.0
    values, vectors = np.linalg.eigh(m[:3, :3])
    match = int(np.argmin(np.abs(values - factor)))
    direction = vectors[:, match] if abs(values[match] - factor) < 1e-8 else None
    if direction is None:
        factor = (factor + 2.0) / 3.0
    origin = m[:3, 3] / (1.0 - factor) if abs(1.0 - factor) > EPS else np.zeros(3)
    return factor, origin, direction


def shear_matrix(angle: float, direction: Vector, point: Vector, normal: Vector) -> Array:
    """The shear by an angle along `direction`, which lies in the plane through `point` with `normal`."""
    d, n = unit_vector(_vector(direction)), unit_vector(_vector(normal))
    if abs(float(d @ n)) > 1e-5:
        raise ValueError("direction and normal vectors are not orthogonal")
    slope = math.tan(angle)
    return _matrix(np.identity(3) + slope * np.outer(d, n), -slope * (_vector(point) @ n) * d)


def shear_from_matrix(matrix: Matrix) -> tuple[float, Array, Array, Array]:
    """Angle, direction, point and normal of a shear."""
    m = np.asarray(matrix, dtype=np.float64)
    u, sizes, vh = np.linalg.svd(m[:3, :3] - np.identity(3))
    slope = float(sizes[0])
    if slope < EPS:
        raise ValueError("no shear: the matrix leaves every direction as it is")
    direction, normal = u[:, 0], vh[0]
    return math.atan(slope), direction, -(m[:3, 3] @ direction) / slope * normal, normal


def projection_matrix(
    point: Vector, normal: Vector, direction: Vector | None = None, perspective: Vector | None = None, pseudo: bool = False
) -> Array:
    """The projection onto the plane through `point` with `normal`.

    It is along the normal, along `direction`, or from the point `perspective` (with `pseudo`, depth is kept).
    """
    n = unit_vector(_vector(normal))
    height = float(_vector(point) @ n)
    if perspective is None:
        d = n if direction is None else _vector(direction)
        along = float(d @ n)
        return _matrix(np.identity(3) - np.outer(d, n) / along, d * (height / along))
    eye = _vector(perspective)
    matrix = np.empty((4, 4))
    shift = eye + n if pseudo else eye
    matrix[:3, :3] = (float(eye @ n) - height) * np.identity(3) - np.outer(shift, n)
    matrix[:3, 3] = height * shift
    matrix[3, :3] = -n
    matrix[3, 3] = eye @ n
    return matrix


def projection_from_matrix(matrix: Matrix, pseudo: bool = False) -> tuple[Array, Array, Array | None, Array | None, bool]:
    """Point, normal, direction, perspective and pseudo: the arguments of `projection_matrix`."""
    m = np.array(matrix, dtype=np.float64)
    size = float(np.linalg.norm(m[3, :3]))
    if size < 1e-8:
        u, _, vh = np.linalg.svd(m[:3, :3])
        direction, normal = vh[2], u[:, 2]
        slanted = float(np.linalg.norm(np.cross(direction, normal))) > 1e-8
        return m[:3, 3], normal, direction if slanted else None, None, False
    m /= size
    normal = -m[3, :3]
    distance = (float(np.trace(m[:3, :3])) + m[3, 3] + float(pseudo)) / 3.0
    shift = (distance * np.identity(3) - m[:3, :3]) @ normal
    return (m[3, 3] - distance) * normal, normal, None, shift - normal if pseudo else shift, pseudo


def clip_matrix(
    left: float, right: float, bottom: float, top: float, near: float, far: float, perspective: bool = False
) -> Array:
    """The mapping of a box (or, with `perspective`, a truncated pyramid) to the cube from -1 to 1.

    Raises ValueError for limits in the wrong order.
    """
    if left >= right or bottom >= top or near >= far:
        raise ValueError("invalid frustrum")
    if perspective and near <= EPS:
        raise ValueError("invalid frustrum: near <= 0")
    matrix = np.zeros((4, 4))
    for row, (low, high) in enumerate(((left, right), (bottom, top), (near, far))):
        span = high - low
        if not perspective:
            matrix[row, row], matrix[row, 3] = 2.0 / span, -(high + low) / span
        elif row < 2:
            matrix[row, row], matrix[row, 2] = -2.0 * near / span, (high + low) / span
        else:
            matrix[row, row], matrix[row, 3] = -(high + low) / span, 2.0 * near * far / span
    matrix[3] = (0.0, 0.0, -1.0, 0.0) if perspective else (0.0, 0.0, 0.0, 1.0)
    return matrix
