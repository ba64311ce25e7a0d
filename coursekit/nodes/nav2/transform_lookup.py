"""The robot's pose, and poses of other frames, in the plane."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import rclpy
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from rclpy.executors import SingleThreadedExecutor
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener

from coursekit.geometry.plane import Array, Pose2D
from coursekit.nodes.scanning.planar import of_transform, plane, to_pose
from coursekit.nodes.scanning.scan_filter import WakingBuffer

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time as TimeMsg
    from rclpy.node import Node


class TransformLookup:
    """The transforms that a node of nav2 needs; lookups raise TransformException if a transform is missing."""

    def __init__(self, node: Node, base: str, listener: Node | None = None) -> None:
        """`listener` is the node that subscribes to tf, if it is another node: remappings of tf apply to its namespace."""
        self.node, self.base = node, base
        self.buffer = WakingBuffer(node=node)
        self._space = (listener or node).get_namespace()
        self._listener = TransformListener(self.buffer, listener or node)
        self._apart: TransformListener | None = None

    def close(self) -> None:
        """Destroy the subscriptions to tf."""
        self._listener.unregister()
        if self._apart is not None:
            self._apart.executor.shutdown(0)
            self._apart.node.destroy_node()
            self._apart = None

    def buffer_for_plugins(self) -> Buffer:
        """Return a buffer with a thread of its own: the calls of plugins may wait for transforms in it."""
        if self._apart is None:
            self._apart = TransformListener(Buffer(), self._tf_node("listens_for_plugins"), spin_thread=True)
        buffer: Buffer = self._apart.buffer
        return buffer

    def _tf_node(self, what: str) -> Any:
        """Make a node that subscribes to tf."""
        name = f"{self.node.get_name()}_{what}"
        names = ["--ros-args", "-r", f"__node:={name}", "-r", f"__ns:={self._space}"]
        return rclpy.create_node(name, namespace=self._space, cli_args=names, context=self.node.context)

    def wait_for_robot(self, frame: str, tell: Callable[[str], None]) -> None:
        """Wait until the robot's pose in a frame is known; until then, call `tell` twice a second with the reason.

        This is for callbacks: they block the node's own executor, so a temporary node subscribes to tf.
        """
        listening = self._tf_node("waits_for_tf")
        executor = SingleThreadedExecutor(context=self.node.context)
        executor.add_node(listening)
        listener = TransformListener(self.buffer, listening)
        known = self.buffer.wait_for_transform_async(frame, self.base, Time())
        try:
            while self.node.context.ok() and (fault := self._fault(frame)):
                tell(fault)
                executor.spin_until_future_complete(known, 0.5)
        finally:
            listener.unregister()
            executor.shutdown()
            listening.destroy_node()

    def _fault(self, frame: str) -> str:
        try:
            self.robot(frame)
        except TransformException as fault:
            return str(fault)
        return ""

    def robot(self, frame: str) -> Pose2D:
        """The robot's newest pose in a frame."""
        return of_transform(self.buffer.lookup_transform_core(frame, self.base, Time()))

    def between(self, target: str, source: str) -> Pose2D:
        """The newest pose of a frame in another."""
        return Pose2D() if target == source else of_transform(self.buffer.lookup_transform_core(target, source, Time()))

    def pose_in(self, frame: str, msg: PoseStamped) -> Pose2D:
        """Transform a message's pose to a frame; a pose without a frame ID counts as given in that frame."""
        here = plane(msg.pose.position, msg.pose.orientation)
        return self.between(frame, msg.header.frame_id or frame) @ here


def stamped(pose: Pose2D, frame: str, stamp: TimeMsg) -> PoseStamped:
    """A pose as a message."""
    msg = PoseStamped()
    msg.header.frame_id, msg.header.stamp, msg.pose = frame, stamp, to_pose(pose)
    return msg


def path_message(poses: Array, frame: str, stamp: TimeMsg) -> Path:
    """Poses (n, 3) as a path."""
    msg = Path()
    msg.header.frame_id, msg.header.stamp = frame, stamp
    msg.poses = [stamped(Pose2D(*row), frame, stamp) for row in poses.tolist()]
    return msg
