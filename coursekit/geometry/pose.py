"""Rigid motions as tuples (x, y, z, qx, qy, qz, qw), in metres and unit quaternions.

A pose of frame b in frame a takes coordinates in b to coordinates in a. Plain floats in tuples are several times
faster here than small numpy arrays.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import acos, sin, sqrt

Pose = tuple[float, float, float, float, float, float, float]
Quaternion = tuple[float, float, float, float]
Vector = tuple[float, float, float]
Segment = tuple[float, ...]
"""The precomputed motion between two poses: see `segment`."""

IDENTITY: Pose = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)


def compose(a: Pose, b: Pose) -> Pose:
    """First `b`, then `a`.

    >>> compose((1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0), (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    (0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)
    """
    ax, ay, az, i, j, k, w = a
    x, y, z, bi, bj, bk, bw = b
    # v + w t + q x t with t = 2 q x v rotates v with fewer products than q v q*
    t = j * z - k * y
    u = k * x - i * z
    v = i * y - j * x
    t += t
    u += u
    v += v
    return (
        ax + x + w * t + j * v - k * u,
        ay + y + w * u + k * t - i * v,
        az + z + w * v + i * u - j * t,
        w * bi + i * bw + j * bk - k * bj,
        w * bj + j * bw + k * bi - i * bk,
        w * bk + k * bw + i * bj - j * bi,
        w * bw - i * bi - j * bj - k * bk,
    )


def inverse(a: Pose) -> Pose:
    """The inverse motion.

    >>> inverse((1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0))[:3]
    (-1.0, -2.0, -3.0)
    """
    x, y, z, i, j, k, w = a
    back = (-i, -j, -k, w)
    rx, ry, rz = rotate(back, (x, y, z))
    return (-rx, -ry, -rz, *back)


def between(target: Pose, source: Pose) -> Pose:
    """`inverse(target)` composed with `source`; both are given in the same frame.

    >>> here, there = (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), (3.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    >>> between(here, there)[:3]
    (2.0, 2.0, 0.0)
    """
    x, y, z, i, j, k, w = target
    sx, sy, sz, si, sj, sk, sw = source
    return compose((0.0, 0.0, 0.0, -i, -j, -k, w), (sx - x, sy - y, sz - z, si, sj, sk, sw))


def rotate(q: Quaternion, v: Vector) -> Vector:
    """Rotate a vector by a unit quaternion (x, y, z, w).

    >>> rotate((0.0, 0.0, 1.0, 0.0), (1.0, 2.0, 3.0))
    (-1.0, -2.0, 3.0)
    """
    i, j, k, w = q
    x, y, z = v
    t = 2.0 * (j * z - k * y)
    u = 2.0 * (k * x - i * z)
    s = 2.0 * (i * y - j * x)
    return x + w * t + j * s - k * u, y + w * u + k * t - i * s, z + w * s + i * u - j * t


def multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    """First the rotation `b`, then `a`.

    >>> multiply((0.0, 0.0, 1.0, 0.0), (1.0, 0.0, 0.0, 0.0))
    (0.0, 1.0, 0.0, 0.0)
    """
    i, j, k, w = a
    bi, bj, bk, bw = b
    return (
        w * bi + i * bw + j * bk - k * bj,
        w * bj + j * bw + k * bi - i * bk,
        w * bk + k * bw + i * bj - j * bi,
        w * bw - i * bi - j * bj - k * bk,
    )


def slerp(a: Quaternion, b: Quaternion, ratio: float) -> Quaternion:
    """Interpolate from `a` (ratio 0) to `b` (ratio 1), at constant speed along the shorter arc.

    >>> [round(part, 3) for part in slerp((0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 1.0, 0.0), 0.5)]
    [0.0, 0.0, 0.707, 0.707]
    """
    return interpolate((0.0, 0.0, 0.0, *a), (0.0, 0.0, 0.0, *b), ratio)[3:]


def interpolate(a: Pose, b: Pose, ratio: float) -> Pose:
    """Interpolate from pose `a` to pose `b`: linearly in position, with `slerp` in attitude.

    >>> interpolate(IDENTITY, (2.0, 4.0, 0.0, 0.0, 0.0, 0.0, 1.0), 0.25)[:3]
    (0.5, 1.0, 0.0)
    """
    x, y, z, i, j, k, w = a
    bx, by, bz, bi, bj, bk, bw = b
    rest = 1.0 - ratio
    dot = i * bi + j * bj + k * bk + w * bw
    same = dot if dot >= 0.0 else -dot
    if same >= 1.0:  # little or no rotation: linear interpolation is as good
        p, r = rest, ratio
    else:
        angle = acos(same)
        scale = 1.0 / sin(angle)
        p = sin(rest * angle) * scale
        r = sin(ratio * angle) * scale
    if dot < 0.0:
        r = -r
    return (
        rest * x + ratio * bx,
        rest * y + ratio * by,
        rest * z + ratio * bz,
        p * i + r * bi,
        p * j + r * bj,
        p * k + r * bk,
        p * w + r * bw,
    )


def segment(a: Pose, b: Pose) -> Segment | None:
    """Precompute the numbers that `interpolate` needs for two poses; None when there is no rotation between them.

    (x, dx, y, dy, z, dz), then the quaternions a and b over the sine of the angle between them, and the angle: at a ratio
    r the attitude is a * sin(angle - r * angle) + b * sin(r * angle).

    >>> half_turn = segment(IDENTITY, (2.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0))
    >>> half_turn[1], round(half_turn[-1], 4)  # 2 m along x; the angle between the quaternions is half that of the rotation
    (2.0, 1.5708)
    >>> segment(IDENTITY, (2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)) is None
    True
    """
    x, y, z, i, j, k, w = a
    bx, by, bz, bi, bj, bk, bw = b
    dot = i * bi + j * bj + k * bk + w * bw
    same = dot if dot >= 0.0 else -dot
    if same >= 1.0:
        return None
    angle = acos(same)
    p = 1.0 / sin(angle)
    r = p if dot >= 0.0 else -p
    return (x, bx - x, y, by - y, z, bz - z, p * i, p * j, p * k, p * w, r * bi, r * bj, r * bk, r * bw, angle)


def canonical(pose: Pose) -> Pose:
    """The same pose with the quaternion's sign as tf2 returns it (tf2 converts through a matrix).

    >>> canonical((0.0, 0.0, 0.0, 0.0, 0.0, -0.6, -0.8))[5:]  # the same rotation
    (0.6, 0.8)
    """
    x, y, z, i, j, k, w = pose
    if w > 0.5:
        return pose
    if w < -0.5:
        return x, y, z, -i, -j, -k, -w
    ii, jj, kk = i * i, j * j, k * k
    lead = (k if jj < kk else j) if ii < jj else (k if ii < kk else i)
    return (x, y, z, -i, -j, -k, -w) if lead < 0.0 else pose


def normalized(pose: Pose) -> Pose:
    """The same pose with a quaternion of length 1.

    >>> normalized((1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 2.0))
    (1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0)
    """
    x, y, z, i, j, k, w = pose
    length = sqrt(i * i + j * j + k * k + w * w)
    return x, y, z, i / length, j / length, k / length, w / length


def are_units(poses: Iterable[Pose]) -> bool:
    """Whether all quaternions have length 1 and no number is missing (NaN).

    >>> are_units([IDENTITY]), are_units([IDENTITY, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5)])
    (True, False)
    """
    return all(-1e-12 < i * i + j * j + k * k + w * w - 1.0 + 0.0 * (x + y + z) < 1e-12 for x, y, z, i, j, k, w in poses)


def matrix(pose: Pose) -> list[list[float]]:
    """The homogeneous matrix, four rows of four.

    >>> matrix(IDENTITY)[0]
    [1.0, 0.0, 0.0, 0.0]
    """
    q = pose[3:]
    columns = [rotate(q, axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))]
    return [[*(column[row] for column in columns), pose[row]] for row in range(3)] + [[0.0, 0.0, 0.0, 1.0]]
