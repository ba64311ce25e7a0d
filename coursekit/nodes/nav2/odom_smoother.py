"""The mean velocity of the last messages of odometry, as nav2_util::OdomSmoother has it."""

from __future__ import annotations

import math
from collections import deque
from typing import TYPE_CHECKING

from nav_msgs.msg import Odometry
from rclpy.time import Time

if TYPE_CHECKING:
    from rclpy.node import Node

SECONDS = 0.3
"""The time over which nav2's navigators take the mean [s]."""


class OdomSmoother:
    """Listens to odometry; `speed` is the mean of its last `seconds`."""

    def __init__(self, node: Node, topic: str, seconds: float = SECONDS) -> None:
        self._node, self._seconds = node, seconds
        self._kept: deque[Odometry] = deque()
        self._subscription = node.create_subscription(Odometry, topic, self.take, 10)

    def take(self, msg: Odometry) -> None:
        """Keep a message, and let go of those that are too old."""
        now = Time.from_msg(msg.header.stamp).nanoseconds
        while self._kept and now - Time.from_msg(self._kept[0].header.stamp).nanoseconds > self._seconds * 1e9:
            self._kept.popleft()
        self._kept.append(msg)

    def speed(self) -> float:
        """The length of the mean velocity in the plane [m/s]; 0 without a message."""
        if not self._kept:
            return 0.0
        velocities = [msg.twist.twist.linear for msg in self._kept]
        return math.hypot(sum(v.x for v in velocities), sum(v.y for v in velocities)) / len(velocities)

    def destroy(self) -> None:
        """Listen no longer."""
        self._node.destroy_subscription(self._subscription)
