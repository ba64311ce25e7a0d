"""Points of turtle3, logged in the frame of another turtle as soon as the transform at their time is known."""

from __future__ import annotations

from collections import deque
from typing import Any

import tf2_geometry_msgs  # noqa: F401  (teaches tf2 to transform points)
from geometry_msgs.msg import PointStamped
from rclpy.node import Node
from rclpy.task import Future
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener

from coursekit.nodes.running import run

QUEUE = 100  # the maximum number of points that wait for their transform


class PoseDrawer(Node):
    """Logs transformed points; as with tf2_ros::MessageFilter in C++, a point waits until it can be transformed."""

    def __init__(self) -> None:
        super().__init__("turtle_tf2_pose_drawer")
        self._target = str(self.declare_parameter("target_frame", "turtle1").value)
        self._buffer = Buffer(node=self)
        self._listener = TransformListener(self._buffer, self)
        self._waiting: deque[Future] = deque()
        self.create_subscription(PointStamped, "/turtle3/turtle_point_stamped", self._heard, 10)

    def _heard(self, msg: PointStamped) -> None:
        if len(self._waiting) >= QUEUE:
            self._waiting.popleft().cancel()
        stamp = Time.from_msg(msg.header.stamp)
        known = self._buffer.wait_for_transform_async(self._target, msg.header.frame_id, stamp)
        self._waiting.append(known)
        known.add_done_callback(lambda done: self._tell(done, msg))

    def _tell(self, done: Any, msg: PointStamped) -> None:
        if done in self._waiting:
            self._waiting.remove(done)
        if done.cancelled():
            return
        try:
            point = self._buffer.transform(msg, self._target).point
        except TransformException as fault:
            self.get_logger().warning(f"Failure {fault}\n")
            return
        place = f"x:{point.x:f} y:{point.y:f} z:{point.z:f}"
        self.get_logger().info(f"Point of turtle3 in frame of turtle1: {place}\n")


def main(args: list[str] | None = None) -> int:
    """Run turtle_tf2_message_filter until Ctrl-C."""
    return run(PoseDrawer, args)
