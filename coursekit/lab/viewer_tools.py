"""RViz's tools: 2D Goal Pose, 2D Pose Estimate and Publish Point, in the fixed frame."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from coursekit.view.scene_stage import Stage
from coursekit.words.gettext import gettext

if TYPE_CHECKING:
    from rclpy.node import Node

COVARIANCE = {0: 0.25, 7: 0.25, 35: (math.pi / 12) ** 2}
"""The covariance of 2D Pose Estimate: half a metre and fifteen degrees."""


class Tools:
    """Publishes the results of clicks; publishers are made on first use."""

    def __init__(self, node: Node, stage: Stage) -> None:
        self.node = node
        self.stage = stage
        self.told = ""
        """A text about the last published message."""
        self._publishers: dict[str, Any] = {}

    def use(self, message: dict[str, Any]) -> None:
        """Handle a browser message: {'tool': 'goal', 'x': ..., 'y': ..., 'yaw': ...}."""
        numbers = [message.get(name, 0.0) for name in ("x", "y", "z", "yaw")]
        if not all(isinstance(number, int | float) and math.isfinite(number) for number in numbers):
            return
        x, y, z, yaw = (float(number) + 0.0 for number in numbers)  # avoids -0.00
        if message.get("tool") == "goal":
            self.goal_pose(x, y, yaw)
        elif message.get("tool") == "estimate":
            self.pose_estimate(x, y, yaw)
        elif message.get("tool") == "point":
            self.publish_point(x, y, z)

    def goal_pose(self, x: float, y: float, yaw: float) -> None:
        """Publish a PoseStamped on /goal_pose."""
        from geometry_msgs.msg import PoseStamped

        msg = PoseStamped(header=self._header())
        _fill(msg.pose, x, y, yaw)
        self._publish("/goal_pose", msg, f"({x:.2f}, {y:.2f}), {math.degrees(yaw):.0f}°")

    def pose_estimate(self, x: float, y: float, yaw: float) -> None:
        """Publish a PoseWithCovarianceStamped on /initialpose."""
        from geometry_msgs.msg import PoseWithCovarianceStamped

        msg = PoseWithCovarianceStamped(header=self._header())
        _fill(msg.pose.pose, x, y, yaw)
        for index, value in COVARIANCE.items():
            msg.pose.covariance[index] = value
        self._publish("/initialpose", msg, f"({x:.2f}, {y:.2f}), {math.degrees(yaw):.0f}°")

    def publish_point(self, x: float, y: float, z: float) -> None:
        """Publish a PointStamped on /clicked_point."""
        from geometry_msgs.msg import Point, PointStamped

        msg = PointStamped(header=self._header(), point=Point(x=float(x), y=float(y), z=float(z)))
        self._publish("/clicked_point", msg, f"({x:.2f}, {y:.2f}, {z:.2f})")

    def _header(self) -> Any:
        from rclpy.time import Time
        from std_msgs.msg import Header

        return Header(frame_id=self.stage.fixed_frame, stamp=Time(nanoseconds=self.stage.now()).to_msg())

    def _publish(self, topic: str, msg: Any, words: str) -> None:
        if topic not in self._publishers:
            self._publishers[topic] = self.node.create_publisher(type(msg), topic, 1)
        self._publishers[topic].publish(msg)
        self.told = gettext(f"{topic}: {words} in {self.stage.fixed_frame}")


def _fill(pose: Any, x: float, y: float, yaw: float) -> None:
    pose.position.x, pose.position.y = float(x), float(y)
    pose.orientation.z, pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)


__all__ = ["Tools"]
