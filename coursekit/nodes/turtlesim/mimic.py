"""The node `turtle_mimic`: copies the velocities of one turtle to another. Remap input/pose, output/cmd_vel."""

from __future__ import annotations

from geometry_msgs.msg import Twist
from turtlesim.msg import Pose

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run


class Mimic(CppNode):
    """Subscribes to poses and publishes their velocities."""

    def __init__(self) -> None:
        super().__init__("turtle_mimic")
        self._publisher = self.create_publisher(Twist, "output/cmd_vel", 1)
        self.create_subscription(Pose, "input/pose", self._copy, 1)

    def _copy(self, pose: Pose) -> None:
        twist = Twist()
        twist.linear.x, twist.angular.z = pose.linear_velocity, pose.angular_velocity
        self._publisher.publish(twist)


def main(args: list[str] | None = None) -> int:
    """Copy until Ctrl-C."""
    return run(Mimic, args)
