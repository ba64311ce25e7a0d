"""Quaternions in ROS's order: x, y, z, w."""

from __future__ import annotations

import math

import numpy as np

from .euler import Axes, euler_from_matrix, turns
from .factors import rotation_part
from .vectors import EPS, Array, Matrix, Vector, unit_vector, vector_norm

Quaternion = tuple[float, float, float, float]


def quaternion_multiply(quaternion1: Vector, quaternion0: Vector) -> Quaternion:
    """The rotation `quaternion0` followed by `quaternion1`.

    >>> quaternion_multiply([1, -2, 3, 4], [-5, 6, 7, 8])
    (-44.0, -14.0, 48.0, 28.0)
    """
    i, j, k, w = (float(part) for part in quaternion1)
    a, b, c, d = (float(part) for part in quaternion0)
    return (
        w * a + i * d + j * c - k * b,
        w * b + j * d + k * a - i * c,
        w * c + k * d + i * b - j * a,
        w * d - i * a - j * b - k * c,
    )


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> Quaternion:
    """The quaternion of three angles (roll, pitch, yaw for 'sxyz').

    >>> [round(part, 6) for part in quaternion_from_euler(1, 2, 3, "ryxz")]
    [0.310622, -0.718287, 0.444435, 0.435953]
    """
    result: Quaternion = (0.0, 0.0, 0.0, 1.0)
    for axis, angle in turns(ai, aj, ak, axes):
        turn = [0.0, 0.0, 0.0, math.cos(angle / 2)]
        turn[axis] = math.sin(angle / 2)
        result = quaternion_multiply(turn, result)
    return result


def euler_from_quaternion(quaternion: Vector, axes: Axes = "sxyz") -> tuple[float, float, float]:
    """The three angles of a quaternion.

    >>> round(euler_from_quaternion([0.06146124, 0, 0, 0.99810947])[0], 6)
    0.123
    """
    return euler_from_matrix(quaternion_matrix(quaternion), axes)


def quaternion_about_axis(angle: float, axis: Vector) -> Quaternion:
    """The rotation by `angle` about `axis` (of any length but 0)."""
    x, y, z = (float(part) for part in axis)
    scale = math.sin(angle / 2) / math.sqrt(x * x + y * y + z * z)
    return x * scale, y * scale, z * scale, math.cos(angle / 2)


def quaternion_matrix(quaternion: Vector) -> Array:
    """The 4x4 rotation of a quaternion of any length; a quaternion of zeros gives the identity."""
    x, y, z, w = (float(part) for part in quaternion)
    matrix = np.identity(4)
    length = x * x + y * y + z * z + w * w
    if length < EPS / 4:
        return matrix
    s = 2.0 / length
    matrix[:3, :3] = (
        (1.0 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)),
        (s * (x * y + z * w), 1.0 - s * (x * x + z * z), s * (y * z - x * w)),
        (s * (x * z - y * w), s * (y * z + x * w), 1.0 - s * (x * x + y * y)),
    )
    return matrix


def quaternion_from_matrix(matrix: Matrix) -> Quaternion:
    """The quaternion (w not negative) of the rotation in a matrix (3x3 or 4x4), which may also have scales and shears."""
    m = rotation_part(matrix).tolist()
    squares = [1.0 + m[0][0] - m[1][1] - m[2][2], 1.0 - m[0][0] + m[1][1] - m[2][2]]
    squares += [1.0 - m[0][0] - m[1][1] + m[2][2], 1.0 + m[0][0] + m[1][1] + m[2][2]]
    largest = squares.index(max(squares))
    skew = (m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1])
    if largest == 3:
        parts = [*skew, squares[3]]
    else:
        parts = [m[largest][axis] + m[axis][largest] for axis in range(3)] + [skew[largest]]
        parts[largest] = squares[largest]
    length = math.copysign(vector_norm(parts), parts[3] or 1.0)
    x, y, z, w = (part / length for part in parts)
    return x, y, z, w


def quaternion_conjugate(quaternion: Vector) -> Array:
    """The quaternion with x, y and z negated."""
    x, y, z, w = quaternion
    return np.array((-x, -y, -z, w), dtype=np.float64)


def quaternion_inverse(quaternion: Vector) -> Array:
    """The inverse of a quaternion."""
    result: Array = quaternion_conjugate(quaternion) / np.dot(quaternion, quaternion)
    return result


def quaternion_slerp(quat0: Vector, quat1: Vector, fraction: float, spin: int = 0, shortestpath: bool = True) -> Array:
    """Interpolate from `quat0` to `quat1` at constant angular speed; `spin` adds half turns."""
    start: Array = unit_vector(quat0[:4])
    end: Array = unit_vector(quat1[:4])
    if fraction in (0.0, 1.0):
        return end if fraction else start
    dot = float(np.dot(start, end))
    if abs(abs(dot) - 1.0) < EPS:
        return start
    if shortestpath and dot < 0.0:
        dot, end = -dot, -end
    angle = math.acos(dot) + spin * math.pi
    if abs(angle) < EPS:
        return start
    weights = math.sin((1.0 - fraction) * angle), math.sin(fraction * angle)
    result: Array = (weights[0] * start + weights[1] * end) / math.sin(angle)
    return result


def random_quaternion(rand: Vector | None = None) -> Array:
    """A random unit quaternion, uniform over all rotations; `rand` gives three numbers from 0 to 1."""
    if rand is None:
        rand = np.random.rand(3)
    assert len(rand) == 3
    near, far = math.sqrt(1.0 - rand[0]), math.sqrt(rand[0])
    a, b = 2.0 * math.pi * rand[1], 2.0 * math.pi * rand[2]
    return np.array((math.sin(a) * near, math.cos(a) * near, math.sin(b) * far, math.cos(b) * far))


def random_rotation_matrix(rand: Vector | None = None) -> Array:
    """A random 4x4 rotation."""
    return quaternion_matrix(random_quaternion(rand))
