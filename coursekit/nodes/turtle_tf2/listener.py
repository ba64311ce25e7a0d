"""turtle2 follows a frame: it looks up the frame's position and drives there."""

from __future__ import annotations

import math

from geometry_msgs.msg import Twist
from rclpy.node import Node
from rclpy.task import Future
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener
from turtlesim.srv import Spawn

from coursekit.nodes.running import run

FOLLOWER = "turtle2"


class FrameListener(Node):
    """Spawns turtle2 and, once a second, sends it towards the frame `target_frame`."""

    def __init__(self) -> None:
        super().__init__("turtle_tf2_frame_listener")
        self.target = str(self.declare_parameter("target_frame", "turtle1").value)
        self._buffer = Buffer()
        self._listener = TransformListener(self._buffer, self)
        self._spawner = self.create_client(Spawn, "spawn")
        self._asked: Future | None = None
        self._spawned = False
        self._publisher = self.create_publisher(Twist, f"{FOLLOWER}/cmd_vel", 1)
        self.create_timer(1.0, self._step)

    def _step(self) -> None:
        if self._spawned:
            self._follow()
        elif self._asked is not None and self._asked.done():
            self.get_logger().info(f"Successfully spawned {self._asked.result().name}")
            self._spawned = True
        elif self._asked is None and self._spawner.service_is_ready():
            self._asked = self._spawner.call_async(Spawn.Request(name=FOLLOWER, x=4.0, y=2.0, theta=0.0))
        elif self._asked is None:
            self.get_logger().info("Service is not ready")

    def _follow(self) -> None:
        try:
            transform = self._buffer.lookup_transform(FOLLOWER, self.target, Time())
        except TransformException as error:
            self.get_logger().info(f"Could not transform {FOLLOWER} to {self.target}: {error}")
            return
        place, twist = transform.transform.translation, Twist()
        twist.angular.z = math.atan2(place.y, place.x)
        twist.linear.x = 0.5 * math.hypot(place.x, place.y)
        self._publisher.publish(twist)


def main() -> None:
    """Run turtle_tf2_listener."""
    run(FrameListener)
