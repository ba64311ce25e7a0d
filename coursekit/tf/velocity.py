"""The velocity of a frame, from its poses at two times."""

from __future__ import annotations

from math import acos, sqrt

from coursekit.geometry.pose import Quaternion, Vector, multiply, rotate

from .buffer import FrameBuffer

Velocity = tuple[Vector, Vector]


def velocity(
    buffer: FrameBuffer,
    tracking: str,
    observation: str,
    reference: str,
    point: Vector,
    point_frame: str,
    time: int,
    interval: int,
) -> Velocity:
    """Linear and angular velocity (m/s, rad/s) of `tracking` seen from `observation`, expressed in `reference`.

    The linear part is that of `point` (in `point_frame`) if it were fixed to the tracked frame. Times in nanoseconds;
    the average is over `interval` around `time`, but ends at the newest data. Raises as a lookup does.

    >>> buffer = FrameBuffer()
    >>> for second in (1, 2):
    ...     _ = buffer.set("map", "robot", second * 10**9, (0.5 * second, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    >>> linear, angular = velocity(buffer, "robot", "map", "map", (0.0, 0.0, 0.0), "robot", 2 * 10**9, 10**8)
    >>> round(linear[0], 6), angular
    (0.5, (0.0, 0.0, 0.0))
    """
    latest = buffer.latest_common_time(observation, tracking)
    end = min(time + interval // 2, latest)
    start = max(interval + 10_000, end) - interval
    begin_pose = buffer.lookup(observation, tracking, start).pose
    end_pose = buffer.lookup(observation, tracking, end).pose
    seconds = (end - start) * 1e-9
    moved = _scaled(_minus(end_pose[:3], begin_pose[:3]), 1.0 / seconds)
    turned = _scaled(_turn(begin_pose[3:], end_pose[3:]), 1.0 / seconds)
    into = buffer.lookup(reference, observation, time).pose[3:]
    linear, angular = rotate(into, moved), rotate(into, turned)
    at = buffer.lookup(reference, point_frame, time).pose
    origin = buffer.lookup(reference, tracking, time).pose
    arm = _minus(rotate(at[3:], point), _minus(origin[:3], at[:3]))
    return _minus(linear, _cross(arm, angular)), angular


def _turn(a: Quaternion, b: Quaternion) -> Vector:
    """The rotation vector from attitude `a` to `b`, in the frame in which both are given."""
    i, j, k, w = multiply(b, (-a[0], -a[1], -a[2], a[3]))
    if w < 0.0:
        i, j, k, w = -i, -j, -k, -w
    length = sqrt(i * i + j * j + k * k)
    scale = 2.0 * acos(min(1.0, w)) / length if length > 1e-12 else 2.0
    return i * scale, j * scale, k * scale


def _minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _scaled(a: Vector, factor: float) -> Vector:
    return a[0] * factor, a[1] * factor, a[2] * factor


def _cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
