"""Trajectory messages as numbers: validated, sorted by the controller's joints, completed."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from builtin_interfaces.msg import Duration
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from .trajectory import Array, Point


def seconds(duration: Duration) -> float:
    """Convert a duration to seconds.

    >>> from builtin_interfaces.msg import Duration
    >>> seconds(Duration(sec=1, nanosec=500_000_000))
    1.5
    """
    return float(duration.sec + duration.nanosec * 1e-9)


def fault_of(msg: JointTrajectory, joints: Sequence[str], partial: bool, moving_end: bool, now_ns: int = 0) -> str:
    """Return the fault of a trajectory received now; '' for a valid one."""
    if not partial and len(msg.joint_names) != len(joints):
        return "Joints on incoming trajectory don't match the controller joints."
    if not msg.joint_names:
        return "Empty joint names on incoming trajectory."
    for name in msg.joint_names:
        if name not in joints:
            return f"Incoming joint {name} doesn't match the controller's joints."
    if len(set(msg.joint_names)) != len(msg.joint_names):
        return "A joint is named twice on incoming trajectory."
    if not msg.points:
        return "Empty trajectory received."
    if not moving_end and any(msg.points[-1].velocities):
        return "Velocity of last trajectory point is not zero."
    start = msg.header.stamp.sec + msg.header.stamp.nanosec * 1e-9
    end = start + seconds(msg.points[-1].time_from_start)
    if start and end < now_ns * 1e-9:
        return f"Received trajectory with non-zero start time ({start:f}) that ends in the past ({end:f})"
    before = -1.0
    for number, point in enumerate(msg.points):
        now = seconds(point.time_from_start)
        if number and now <= before:
            return (
                f"Time between points {number - 1} and {number} is not strictly increasing, it is {before:f} and {now:f} "
                "respectively"
            )
        before = now
        fault = _point_fault(point, len(msg.joint_names), number)
        if fault:
            return fault
    return ""


def _point_fault(point: JointTrajectoryPoint, count: int, number: int) -> str:
    for kind in ("positions", "velocities", "accelerations"):
        values = getattr(point, kind)
        if kind == "positions" and not values:
            return f"Point {number} has no positions: they are what is followed here."
        if values and len(values) != count:
            return f"Mismatch between joint_names size ({count}) and {kind} ({len(values)}) at point #{number}."
        if not all(map(math.isfinite, values)):
            return f"Point {number} has {kind} that are no finite numbers."
    return ""


def points_of(msg: JointTrajectory, joints: Sequence[str], at: Array) -> list[Point]:
    """Return the points in the order of the controller's joints; unnamed joints keep their positions (`at`)."""
    place = [list(joints).index(name) for name in msg.joint_names]

    def sorted_(values: Sequence[float], usual: Array) -> Array | None:
        if not values:
            return None
        points = usual.copy()
        points[place] = values
        return points

    zeros = np.zeros(len(joints))
    return [
        Point(
            seconds(point.time_from_start), sorted_(point.positions, at), sorted_(point.velocities, zeros),  # type: ignore[arg-type]
            sorted_(point.accelerations, zeros),
        )
        for point in msg.points
    ]  # fmt: skip


def message_of(point: Point, time: float = 0.0) -> JointTrajectoryPoint:
    """Convert a point to a message."""
    msg = JointTrajectoryPoint(positions=point.positions.tolist())
    for kind in ("velocities", "accelerations"):
        values = getattr(point, kind)
        setattr(msg, kind, [] if values is None else values.tolist())
    whole = math.floor(max(time, 0.0))
    msg.time_from_start = Duration(sec=whole, nanosec=int((max(time, 0.0) - whole) * 1e9))
    return msg


__all__ = ["fault_of", "message_of", "points_of", "seconds"]
