"""Homogeneous 4x4 matrices: composition, decomposition and comparison."""

from __future__ import annotations

import math

import numpy as np

from .euler import euler_from_matrix, euler_matrix
from .factors import factors
from .quaternions import quaternion_about_axis, quaternion_from_matrix, quaternion_matrix
from .vectors import Array, Matrix, Vector, vector_norm


def identity_matrix() -> Array:
    """The identity matrix."""
    return np.identity(4)


def translation_matrix(direction: Vector) -> Array:
    """The translation by a vector."""
    return _affine(np.identity(3), direction)


def translation_from_matrix(matrix: Matrix) -> Array:
    """The translation vector of a matrix."""
    return np.array(matrix, dtype=np.float64)[:3, 3]


def rotation_matrix(angle: float, direction: Vector, point: Vector | None = None) -> Array:
    """The rotation by an angle about an axis through `point` (the origin by default)."""
    matrix = quaternion_matrix(quaternion_about_axis(angle, direction[:3]))
    if point is not None:
        place = np.asarray(point[:3], dtype=np.float64)
        matrix[:3, 3] = place - matrix[:3, :3] @ place
    return matrix


def rotation_from_matrix(matrix: Matrix) -> tuple[float, Array, Array]:
    """Angle, axis, and the point of the axis nearest to the origin."""
    m = np.asarray(matrix, dtype=np.float64)
    quaternion = quaternion_from_matrix(m)
    length = vector_norm(quaternion[:3])
    if not length:
        return 0.0, np.array((1.0, 0.0, 0.0)), np.zeros(3)
    direction = np.array(quaternion[:3]) / length
    chord = m[:3, 3] - direction * (direction @ m[:3, 3])  # from the origin to its rotated position
    point = (chord + np.cross(direction, chord) * quaternion[3] / length) / 2.0
    return 2.0 * math.atan2(length, quaternion[3]), direction, point


def compose_matrix(
    scale: Vector | None = None, shear: Vector | None = None, angles: Vector | None = None,
    translate: Vector | None = None, perspective: Vector | None = None,
) -> Array:  # fmt: skip
    """A matrix that shears (xy, xz, yz), then scales, rotates (angles about static x, y, z) and translates.

    `perspective` is not used, as in ROS 2's package.
    """
    matrix = np.identity(4) if angles is None else euler_matrix(*angles)
    if scale is not None:
        matrix[:3, :3] *= np.asarray(scale, dtype=np.float64)
    if shear is not None:
        xy, xz, yz = shear
        matrix[:3, :3] = matrix[:3, :3] @ np.array(((1.0, xy, xz), (0.0, 1.0, yz), (0.0, 0.0, 1.0)))
    if translate is not None:
        matrix[:3, 3] = translate
    return matrix


def decompose_matrix(matrix: Matrix) -> tuple[Array, Array, tuple[float, float, float], Array, None]:
    """Scale, shear, angles, translation and None: the arguments of `compose_matrix`."""
    m = np.array(matrix, dtype=np.float64)
    rotation, scale, shear = factors(m[:3, :3])
    return scale, shear, euler_from_matrix(rotation), m[:3, 3], None


def orthogonalization_matrix(lengths: Vector, angles: Vector) -> Array:
    """The conversion from coordinates of a crystal's cell to orthogonal coordinates; angles in degrees."""
    a, b, c = lengths
    sin_a, sin_b, _ = np.sin(np.radians(angles))
    cos_a, cos_b, cos_g = np.cos(np.radians(angles))
    skew = (cos_a * cos_b - cos_g) / (sin_a * sin_b)
    matrix = np.identity(4)
    matrix[:3, :3] = (
        (a * sin_b * math.sqrt(1.0 - skew * skew), 0.0, 0.0),
        (-a * sin_b * skew, b * sin_a, 0.0),
        (a * cos_b, b * cos_a, c),
    )
    return matrix


def superimposition_matrix(v0: Vector, v1: Vector, scaling: bool = False, usesvd: bool = True) -> Array:
    """The rigid motion (with `scaling`, also a scale) that brings points v0 nearest to v1; a point is a column.

    It uses Kabsch's method with singular values, or Horn's with a quaternion. Raises ValueError for fewer than three points.
    """
    a = np.asarray(v0, dtype=np.float64)[:3]
    b = np.asarray(v1, dtype=np.float64)[:3]
    if a.shape != b.shape or a.shape[1] < 3:
        raise ValueError("Vector sets are of wrong shape or type.")
    middle_a, middle_b = a.mean(axis=1), b.mean(axis=1)
    a, b = a - middle_a[:, None], b - middle_b[:, None]
    rotation = _kabsch(b @ a.T) if usesvd else _horn(b @ a.T)
    if scaling:
        rotation = rotation * math.sqrt(float(np.sum(b * b) / np.sum(a * a)))
    return _affine(rotation, middle_b - rotation @ middle_a)


def _kabsch(products: Array) -> Array:
    u, _, vh = np.linalg.svd(products)
    flip = np.diag((1.0, 1.0, float(np.sign(np.linalg.det(u @ vh)))))
    result: Array = u @ flip @ vh
    return result


def _horn(products: Array) -> Array:
    """Horn's method: the quaternion that maximises the sum of b · (q a q*) is an eigenvector of a symmetric matrix."""
    p = products
    skew = np.array((p[2, 1] - p[1, 2], p[0, 2] - p[2, 0], p[1, 0] - p[0, 1]))
    form = np.empty((4, 4))
    form[:3, :3] = p + p.T - np.trace(p) * np.identity(3)
    form[:3, 3] = form[3, :3] = skew
    form[3, 3] = np.trace(p)
    vectors = np.linalg.eigh(form)[1]
    return quaternion_matrix(vectors[:, 3])[:3, :3]


def inverse_matrix(matrix: Matrix) -> Array:
    """The inverse of a matrix."""
    return np.linalg.inv(matrix)


def concatenate_matrices(*matrices: Matrix) -> Array:
    """The product of matrices; the last one acts first."""
    product = np.identity(4)
    for matrix in matrices:
        product = product @ np.asarray(matrix)
    return product


def is_same_transform(matrix0: Matrix, matrix1: Matrix) -> bool:
    """Whether two matrices describe the same transform."""
    a = np.array(matrix0, dtype=np.float64)
    b = np.array(matrix1, dtype=np.float64)
    return bool(np.allclose(a / a[3, 3], b / b[3, 3]))


def _affine(linear: Array, move: Vector) -> Array:
    matrix = np.identity(4)
    matrix[:3, :3] = linear
    matrix[:3, 3] = np.asarray(move, dtype=np.float64)[:3]
    return matrix
