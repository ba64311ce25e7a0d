"""How fast a frame moves, from its poses at two times."""

from __future__ import annotations

from math import acos, sqrt

from .buffer import FrameBuffer
from .pose import Vector, multiply, rotate

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
    """Linear and angular velocity (m/s, rad/s) of `tracking` seen from `observation`, written in `reference`.

    The linear part is that of `point` (in `point_frame`) if it were fixed to the tracked frame. Times in nanoseconds;
    the average is over `interval` around `time`, but ends at the newest data. Raises as a lookup does.
    """
    latest = buffer.latest_common_time(observation, tracking)
    end = min(time + interval // 2, latest)
    start = max(interval + 10_000, end) - interval
    begin_pose = buffer.lookup(observation, tracking, start).pose
    end_pose = buffer.lookup(observation, tracking, end).pose
    seconds = (end - start) * 1e-9
    linear = tuple((b - a) / seconds for a, b in zip(begin_pose[:3], end_pose[:3], strict=True))
    angular = tuple(part / seconds for part in _turn(begin_pose[3:], end_pose[3:]))
    into = buffer.lookup(reference, observation, time).pose[3:]
    linear, angular = rotate(into, linear), rotate(into, angular)
    at = buffer.lookup(reference, point_frame, time).pose
    there = rotate(at[3:], point)
    origin = buffer.lookup(reference, tracking, time).pose
    arm = tuple(a + t - o for a, t, o in zip(at[:3], there, origin[:3], strict=True))
    swing = _cross(angular, arm)
    return tuple(a + b for a, b in zip(linear, swing, strict=True)), angular  # type: ignore[return-value]


def _turn(a: tuple[float, ...], b: tuple[float, ...]) -> Vector:
    """The rotation vector from attitude `a` to `b`, in the frame that both are given in."""
    i, j, k, w = multiply(b, (-a[0], -a[1], -a[2], a[3]))  # type: ignore[arg-type]
    if w < 0.0:
        i, j, k, w = -i, -j, -k, -w
    length = sqrt(i * i + j * j + k * k)
    scale = 2.0 * acos(min(1.0, w)) / length if length > 1e-12 else 2.0
    return i * scale, j * scale, k * scale


def _cross(a: Vector, b: tuple[float, ...]) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
