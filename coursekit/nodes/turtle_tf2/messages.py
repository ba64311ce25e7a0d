"""turtle3 drives in a circle, and each of its positions is published as a point with time and frame."""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import PointStamped, Twist
from rclpy.node import Node
from turtlesim.msg import Pose
from turtlesim.srv import Spawn

from coursekit.nodes.running import run


class PointPublisher(Node):
    """Tries once a second to spawn turtle3; then drives it and publishes turtle3/turtle_point_stamped."""

    def __init__(self) -> None:
        super().__init__("turtle_tf2_message_broadcaster")
        self._spawn = self.create_client(Spawn, "spawn")
        self._asked: Any = None
        self._look = self.create_timer(1.0, self._try)

    def _try(self) -> None:
        log = self.get_logger()
        if self._asked is None:
            if not self._spawn.service_is_ready():
                log.info("Service is not ready")
                return
            self._asked = self._spawn.call_async(Spawn.Request(name="turtle3", x=4.0, y=2.0, theta=0.0))
        elif not self._asked.done():
            log.info("Spawn is not finished")
        else:
            log.info(f"Successfully spawned {self._asked.result().name}")
            self._look.cancel()
            self._begin()

    def _begin(self) -> None:
        self._drive = self.create_publisher(Twist, "turtle3/cmd_vel", 10)
        self._points = self.create_publisher(PointStamped, "turtle3/turtle_point_stamped", 10)
        self.create_subscription(Pose, "turtle3/pose", self._tell, 10)

    def _tell(self, pose: Pose) -> None:
        round_ = Twist()
        round_.linear.x = round_.angular.z = 1.0
        self._drive.publish(round_)
        msg = PointStamped()
        msg.header.stamp, msg.header.frame_id = self.get_clock().now().to_msg(), "world"
        msg.point.x, msg.point.y = pose.x, pose.y
        self._points.publish(msg)


def main() -> None:
    """Run turtle_tf2_message_broadcaster."""
    run(PointPublisher)
