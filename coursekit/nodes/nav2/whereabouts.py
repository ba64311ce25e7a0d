"""Where the robot is, and poses of other frames, seen from above."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import rclpy
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from rclpy.executors import SingleThreadedExecutor
from rclpy.time import Time
from tf2_ros import TransformException, TransformListener

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.scanning.planar import of_transform, plane, to_pose
from coursekit.nodes.scanning.scan_filter import WakingBuffer


class Whereabouts:
    """tf as a node of nav2 asks it; all raise TransformException where a transform is missing."""

    def __init__(self, node: Any, base: str, listener: Any = None) -> None:
        """`listener` is the node that hears tf, if it is another one: remappings of tf are meant for its namespace."""
        self.node, self.base = node, base
        self.buffer = WakingBuffer(node=node)
        self._space = (listener or node).get_namespace()
        self._listener = TransformListener(self.buffer, listener or node)

    def close(self) -> None:
        """Listen no more."""
        self._listener.unregister()

    def wait_for_robot(self, frame: str, tell: Callable[[str], None]) -> None:
        """Come back when the robot's pose in a frame is known; until then `tell` hears twice a second why it is not.

        Meant for a callback: the node's own executor rests meanwhile, so tf is heard by ears of its own.
        """
        name = f"{self.node.get_name()}_waits_for_tf"
        names = ["--ros-args", "-r", f"__node:={name}", "-r", f"__ns:={self._space}"]
        ears = rclpy.create_node(name, namespace=self._space, cli_args=names, context=self.node.context)
        executor = SingleThreadedExecutor(context=self.node.context)
        executor.add_node(ears)
        listener = TransformListener(self.buffer, ears)
        known = self.buffer.wait_for_transform_async(frame, self.base, Time())
        try:
            while self.node.context.ok() and (fault := self._fault(frame)):
                tell(fault)
                executor.spin_until_future_complete(known, 0.5)
        finally:
            listener.unregister()
            executor.shutdown()
            ears.destroy_node()

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
        """A pose of a message in a frame; without a frame of its own it is taken as being in that one."""
        here = plane(msg.pose.position, msg.pose.orientation)
        return self.between(frame, msg.header.frame_id or frame) @ here


def stamped(pose: Pose2D, frame: str, stamp: Any) -> PoseStamped:
    """A pose as a message."""
    msg = PoseStamped()
    msg.header.frame_id, msg.header.stamp, msg.pose = frame, stamp, to_pose(pose)
    return msg


def path_message(poses: Any, frame: str, stamp: Any) -> Path:
    """Poses (n, 3) as a path."""
    msg = Path()
    msg.header.frame_id, msg.header.stamp = frame, stamp
    msg.poses = [stamped(Pose2D(*row), frame, stamp) for row in poses.tolist()]
    return msg
