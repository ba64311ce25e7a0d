"""Odometry of wheels as message and tf, as published by all vehicle controllers."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage

from .controller import stamp

if TYPE_CHECKING:
    from rclpy.publisher import Publisher


class WheelOdometry:
    """Integrates a path; `frames` are the odometry frame and the robot's frame.

    `spreads` are the diagonals of the covariances of pose and twist; speeds are means of the last `window` steps.
    """

    def __init__(
        self,
        frames: tuple[str, str],
        out: Publisher,
        tf: Publisher | None,
        period_ns: int = 0,
        *,
        spreads: Sequence[Sequence[float]] = ((), ()),
        window: int = 1,
    ) -> None:
        self._frames, self._out, self._tf, self._period_ns = frames, out, tf, period_ns
        self._x = self._y = self._theta = 0.0
        self._told_ns = 0
        self._covariances = [np.diag(spread).ravel() if len(spread) else np.zeros(36) for spread in spreads]
        self._speeds: deque[tuple[float, float]] = deque(maxlen=max(window, 1))

    def go(self, now_ns: int, dt: float, way: float, bend: float) -> None:
        """Add a distance [m] and a rotation [rad] of one step; publish when due."""
        self._theta += bend / 2
        self._x, self._y = self._x + way * math.cos(self._theta), self._y + way * math.sin(self._theta)
        self._theta += bend / 2
        self._speeds.append((way / dt, bend / dt) if dt else (0.0, 0.0))
        if now_ns - self._told_ns >= self._period_ns:
            self._told_ns = now_ns
            ahead, turn = (sum(each) / len(self._speeds) for each in zip(*self._speeds, strict=True))
            self._tell(now_ns, ahead, turn)

    def restart(self) -> None:
        """Reset the pose to the origin."""
        self._x = self._y = self._theta = 0.0
        self._speeds.clear()

    def _tell(self, now_ns: int, ahead: float, turn: float) -> None:
        msg = Odometry(child_frame_id=self._frames[1])
        msg.header.stamp, msg.header.frame_id = stamp(now_ns), self._frames[0]
        msg.pose.pose.position.x, msg.pose.pose.position.y = self._x, self._y
        turned = msg.pose.pose.orientation
        turned.z, turned.w = math.sin(self._theta / 2), math.cos(self._theta / 2)
        msg.twist.twist.linear.x, msg.twist.twist.angular.z = ahead, turn
        msg.pose.covariance, msg.twist.covariance = self._covariances
        self._out.publish(msg)
        if self._tf is not None:
            transform = TransformStamped(header=msg.header, child_frame_id=self._frames[1])
            transform.transform.translation.x, transform.transform.translation.y = self._x, self._y
            transform.transform.rotation = turned
            self._tf.publish(TFMessage(transforms=[transform]))


__all__ = ["WheelOdometry"]
