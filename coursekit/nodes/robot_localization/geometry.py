"""Conversion between messages, poses as tuples, and the filter's arrays."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from coursekit.geometry.pose import Pose, Quaternion, matrix
from coursekit.geometry.rotation import quaternion_of
from coursekit.nav.fusion.state import Array, Mask

if TYPE_CHECKING:
    from geometry_msgs.msg import Point, Vector3
    from geometry_msgs.msg import Quaternion as QuaternionMsg
    from numpy.typing import NDArray


def quaternion(angles: Iterable[float]) -> Quaternion:
    """The unit quaternion (x, y, z, w) of roll, then pitch, then yaw [rad].

    >>> [round(one, 3) for one in quaternion([0.0, 0.0, 3.0])]
    [0.0, 0.0, 0.997, 0.071]
    """
    roll, pitch, yaw = (float(angle) for angle in angles)
    return quaternion_of((roll, pitch, yaw))


def unit(q: QuaternionMsg) -> Quaternion:
    """A message's quaternion, normalized; a quaternion of zeros or with non-finite values means no rotation.

    >>> from geometry_msgs.msg import Quaternion
    >>> unit(Quaternion(z=2.0, w=0.0)), unit(Quaternion(w=0.0))
    ((0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))
    """
    length = math.sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w)
    if not length > 0 or not math.isfinite(length):
        return (0.0, 0.0, 0.0, 1.0)
    return (q.x / length, q.y / length, q.z / length, q.w / length)


def pose_of(position: Point | Vector3, orientation: QuaternionMsg) -> Pose:
    """A position and a quaternion of a message as a tuple."""
    return (position.x, position.y, position.z, *unit(orientation))


def vector(v: Vector3) -> Array:
    """A message's x, y and z."""
    return np.array([v.x, v.y, v.z])


def turning(pose: Pose) -> Array:
    """The rotation matrix of a pose."""
    return np.array(matrix(pose))[:3, :3]


def square(numbers: NDArray[np.float64]) -> Array:
    """A message's covariance, row by row, as a matrix.

    >>> square(np.arange(9.0)).tolist()
    [[0.0, 1.0, 2.0], [3.0, 4.0, 5.0], [6.0, 7.0, 8.0]]
    """
    flat = np.array(numbers, float)
    side = math.isqrt(len(flat))
    return flat.reshape(side, side)


def turned(covariance: Array, rotation: Array) -> Array:
    """Rotate the covariance of one or two vectors.

    >>> quarter = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    >>> np.diag(turned(np.diag([4.0, 1.0, 0.0]), quarter)).tolist()
    [1.0, 4.0, 0.0]
    """
    full = np.kron(np.eye(len(covariance) // 3), rotation)
    rotated: Array = full @ covariance @ full.T
    return rotated


def turned_mask(used: Mask, rotation: Array) -> Mask:
    """Rotate the mask of a vector: a rotated component is used if a used component contributes to it.

    >>> quarter = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    >>> turned_mask(np.array([True, False, False]), quarter).tolist()
    [False, True, False]
    """
    mask: Mask = np.linalg.norm(rotation * used, axis=1) >= 1e-6
    return mask
