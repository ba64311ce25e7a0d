"""The node `draw_square`: drives turtle1 around a square of 2 m, with feedback from its pose."""

from __future__ import annotations

import math

from geometry_msgs.msg import Twist
from std_srvs.srv import Empty
from turtlesim.msg import Pose

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run
from coursekit.sim.turtle import normalize_angle

EDGE = 2.0
LINEAR, ANGULAR = 1.0, 0.4
"""The speeds of driving [m/s] and turning [rad/s]."""


class DrawSquare(CppNode):
    """A state machine: forward, stop, turn, stop, forward, ..."""

    def __init__(self) -> None:
        super().__init__("draw_square")
        self._pose: Pose | None = None
        self._goal = (0.0, 0.0, 0.0)
        self._state = self._begin
        self._publisher = self.create_publisher(Twist, "turtle1/cmd_vel", 1)
        self.create_subscription(Pose, "turtle1/pose", self._see, 1)
        self._reset = self.create_client(Empty, "reset")
        self.create_timer(0.016, self._tick)
        self._reset.call_async(Empty.Request())

    def _see(self, pose: Pose) -> None:
        self._pose = pose

    def _tick(self) -> None:
        if self._pose is not None:
            self._state(self._pose)

    def _begin(self, pose: Pose) -> None:
        self._aim_ahead(pose)
        self._forward(pose)

    def _forward(self, pose: Pose) -> None:
        if self._arrived(pose):
            self._state = self._stop_forward
            self._drive(0.0, 0.0)
        else:
            self._drive(LINEAR, 0.0)

    def _stop_forward(self, pose: Pose) -> None:
        if self._stands(pose):
            self.get_logger().info("Reached goal")
            self._state = self._turn
            self._aim(pose.x, pose.y, normalize_angle(pose.theta + math.pi / 2))
        else:
            self._drive(0.0, 0.0)

    def _turn(self, pose: Pose) -> None:
        if self._arrived(pose):
            self._state = self._stop_turn
            self._drive(0.0, 0.0)
        else:
            self._drive(0.0, ANGULAR)

    def _stop_turn(self, pose: Pose) -> None:
        if self._stands(pose):
            self.get_logger().info("Reached goal")
            self._aim_ahead(pose)
        else:
            self._drive(0.0, 0.0)

    def _aim_ahead(self, pose: Pose) -> None:
        self._state = self._forward
        x, y = pose.x + math.cos(pose.theta) * EDGE, pose.y + math.sin(pose.theta) * EDGE
        self._aim(x, y, pose.theta)

    def _aim(self, x: float, y: float, theta: float) -> None:
        self._goal = (x, y, theta)
        self.get_logger().info(f"New goal [{x:.6f} {y:.6f}, {theta:.6f}]")

    def _arrived(self, pose: Pose) -> bool:
        x, y, theta = self._goal
        return abs(pose.x - x) < 0.1 and abs(pose.y - y) < 0.1 and abs(pose.theta - theta) < 0.01

    @staticmethod
    def _stands(pose: Pose) -> bool:
        return pose.angular_velocity < 0.0001 and pose.linear_velocity < 0.0001

    def _drive(self, linear: float, angular: float) -> None:
        twist = Twist()
        twist.linear.x, twist.angular.z = linear, angular
        self._publisher.publish(twist)


def main(args: list[str] | None = None) -> int:
    """Draw until Ctrl-C."""
    return run(DrawSquare, args)
