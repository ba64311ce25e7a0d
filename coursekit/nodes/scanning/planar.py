"""Conversion between messages and the plane: poses, the laser's mounting on the robot."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from geometry_msgs.msg import Pose, TransformStamped
from sensor_msgs.msg import LaserScan

from coursekit.geometry.plane import Array, Pose2D
from coursekit.geometry.rotation import yaw_of
from coursekit.slam.scan import Laser


def plane(position: Any, orientation: Any) -> Pose2D:
    """A position and a quaternion as a pose in the plane.

    >>> pose = to_pose(Pose2D(1.0, 2.0, 0.5))
    >>> round(plane(pose.position, pose.orientation).theta, 9)
    0.5
    """
    return Pose2D(position.x, position.y, yaw_of((orientation.x, orientation.y, orientation.z, orientation.w)))


def of_transform(msg: TransformStamped) -> Pose2D:
    """A transform as a pose in the plane."""
    return plane(msg.transform.translation, msg.transform.rotation)


def put(pose: Pose2D, position: Any, orientation: Any) -> None:
    """Write a pose in the plane to a position and a quaternion."""
    position.x, position.y, position.z = pose.x, pose.y, 0.0
    orientation.x = orientation.y = 0.0
    orientation.z, orientation.w = math.sin(pose.theta / 2), math.cos(pose.theta / 2)


def to_pose(pose: Pose2D) -> Pose:
    """Convert a pose in the plane to geometry_msgs/Pose."""
    msg = Pose()
    put(pose, msg.position, msg.orientation)
    return msg


def points_of(path: Any) -> Array:
    """The positions of a nav_msgs/Path, shape (n, 2) [m]."""
    return np.array([(pose.pose.position.x, pose.pose.position.y) for pose in path.poses]).reshape(-1, 2)


def ends_of(ranges: Array, angles: Any) -> Array:
    """The end points of the beams of a planar sensor in its own frame, shape (n, 3) [m].

    >>> ends_of(np.array([2.0]), np.array([0.0])).tolist()
    [[2.0, 0.0, 0.0]]
    """
    return np.column_stack([ranges * np.cos(angles), ranges * np.sin(angles), np.zeros(len(ranges))])


def upside_down(q: Any) -> bool:
    """Whether a quaternion's z axis points down.

    >>> from geometry_msgs.msg import Quaternion
    >>> upside_down(Quaternion()), upside_down(Quaternion(x=1.0, w=0.0))
    (False, True)
    """
    return 1 - 2 * (q.x * q.x + q.y * q.y) < 0


def laser_of(scan: LaserScan, seat: TransformStamped, farthest: float) -> Laser:
    """The sensor of a scan: its fields, and the transform base → laser; hits beyond `farthest` [m] are ignored."""
    return Laser(
        angle_min=scan.angle_min,
        angle_increment=scan.angle_increment,
        range_min=scan.range_min if math.isfinite(scan.range_min) else 0.0,
        range_max=min(farthest, scan.range_max if scan.range_max > 0 else math.inf),
        offset=of_transform(seat),
        flipped=upside_down(seat.transform.rotation),
    )


def fault_of(scan: LaserScan) -> str:
    """The reason why a scan cannot be used; empty if it can.

    >>> fault_of(LaserScan(ranges=[1.0, 2.0]))
    'angle_increment is 0: all beams would point the same way'
    """
    if not len(scan.ranges):
        return "it has no ranges"
    if not math.isfinite(scan.angle_min) or not math.isfinite(scan.angle_increment):
        return "angle_min or angle_increment is not finite"
    if scan.angle_increment == 0.0 and len(scan.ranges) > 1:
        return "angle_increment is 0: all beams would point the same way"
    return ""


def expected_beams(scan: LaserScan) -> int:
    """The number of ranges that follows from the scan's angles; 0 if it is undefined.

    >>> expected_beams(LaserScan(angle_min=-1.0, angle_max=1.0, angle_increment=0.5))
    5
    """
    span = scan.angle_max - scan.angle_min
    if not scan.angle_increment or not math.isfinite(span):
        return 0
    return round(span / scan.angle_increment) + 1
