"""Rotations: quaternions x, y, z, w and their angles about the axes."""

from __future__ import annotations

from math import asin, atan2, cos, sin

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]


def quaternion_of(rpy: Vector) -> Quaternion:
    """Convert roll, pitch, yaw [rad] about the fixed axes x, y, z to a quaternion, as in URDF and tf2.

    >>> quaternion_of((0.0, 0.0, 3.141592653589793))
    (0.0, 0.0, 1.0, 6.123233995736766e-17)
    """
    (sr, cr), (sp, cp), (sy, cy) = ((sin(a / 2), cos(a / 2)) for a in rpy)
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


def rpy_of(q: Quaternion) -> Vector:
    """Roll, pitch and yaw [rad] of a unit quaternion.

    >>> [round(one, 3) for one in rpy_of(quaternion_of((0.1, -0.2, 3.0)))]
    [0.1, -0.2, 3.0]
    """
    x, y, z, w = q
    lean = max(-1.0, min(1.0, 2 * (w * y - z * x)))
    roll = atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    return roll, asin(lean), yaw_of(q)


def yaw_of(q: Quaternion) -> float:
    """The heading of a quaternion of any length: the direction of its x axis, seen from above [rad].

    >>> yaw_of((0.0, 0.0, 0.0, 1.0)), round(yaw_of((0.0, 0.0, 2.0, 0.0)), 4)
    (0.0, 3.1416)
    """
    x, y, z, w = q
    return atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z)
