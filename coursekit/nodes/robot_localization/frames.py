"""Transforms for a filter: at a time, or the newest if there is none for that time."""

from __future__ import annotations

from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener

from coursekit.geometry.pose import IDENTITY, Pose
from coursekit.nodes.robot_localization.geometry import pose_of


class Frames:
    """The transforms that a node receives."""

    def __init__(self, node: Node) -> None:
        self._buffer = Buffer(node=node)
        self._listener = TransformListener(self._buffer, node)

    def pose(self, target: str, source: str, stamp_ns: int) -> Pose:
        """The pose of a frame in another; raises TransformException if it is not known."""
        if target == source:
            return IDENTITY
        try:
            transform = self._buffer.lookup_transform_core(target, source, Time(nanoseconds=max(stamp_ns, 0)))
        except TransformException:
            transform = self._buffer.lookup_transform_core(target, source, Time())
        return pose_of(transform.transform.translation, transform.transform.rotation)
