"""Conversion between ROS's messages and the tuples of coursekit.tf."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from builtin_interfaces.msg import Time as TimeMsg
from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from rclpy.time import Time
from std_msgs.msg import Header

from coursekit.tf import Pose

_new: Any = object.__new__


def nanoseconds(time: Any, what: str = "time") -> int:
    """A time or a duration, as a message or of rclpy's types, in nanoseconds; raises TypeError for other types."""
    if type(time) is Time:
        return time._ns
    if hasattr(time, "sec") and hasattr(time, "nanosec"):
        return int(time.sec) * 1_000_000_000 + int(time.nanosec)
    if hasattr(time, "nanoseconds"):
        return int(time.nanoseconds)
    raise TypeError(f"{what} must have sec and nanosec, or nanoseconds.")


def pose_of(transform: Any, faults: tuple[str, str]) -> Pose:
    """The pose in a geometry_msgs/Transform; raises TypeError with one of `faults` for parts of a wrong type."""
    t, r = transform.translation, transform.rotation
    if not issubclass(type(t), Vector3):
        raise TypeError(faults[0])
    if not issubclass(type(r), Quaternion):
        raise TypeError(faults[1])
    return t._x, t._y, t._z, r._x, r._y, r._z, r._w


def _maker() -> Callable[[str, str, int, Pose], TransformStamped]:
    """Return the function below. In a closure, the lookup of the names that it uses is fastest."""

    def stamped(target: str, source: str, stamp: int, pose: Pose) -> TransformStamped:
        msg = _new(TransformStamped)
        msg._header = header = _new(Header)
        header._stamp = time = _new(TimeMsg)
        time._sec, time._nanosec = divmod(stamp, 1_000_000_000)
        header._frame_id = target
        msg._child_frame_id = source
        msg._transform = transform = _new(Transform)
        transform._translation = t = _new(Vector3)
        transform._rotation = r = _new(Quaternion)
        t._x, t._y, t._z, r._x, r._y, r._z, r._w = pose
        return msg

    return stamped


stamped = _maker()
"""stamped(target, source, stamp_ns, pose): the geometry_msgs/TransformStamped."""
