"""Frames around the turtles: of a turtle, fixed to a turtle, circling a turtle, or given on the command line."""

from __future__ import annotations

import math
import sys
from typing import Any

import numpy as np
import tf_transformations
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster
from turtlesim.msg import Pose

from coursekit.nodes.running import run


def quaternion_from_euler(ai: float, aj: float, ak: float) -> Any:
    """A rotation by roll, pitch and yaw as an array of x, y, z and w.

    >>> quaternion_from_euler(0, 0, math.pi).round(3)
    array([0., 0., 1., 0.])
    """
    return np.array(tf_transformations.quaternion_from_euler(ai, aj, ak))


def transform(node: Node, parent: str, child: str, x: float, y: float, z: float = 0.0) -> TransformStamped:
    """A transform stamped now, without rotation."""
    msg = TransformStamped(child_frame_id=child)
    msg.header.stamp = node.get_clock().now().to_msg()
    msg.header.frame_id = parent
    place = msg.transform.translation
    place.x, place.y, place.z = x, y, z
    return msg


def turn(msg: TransformStamped, roll: float, pitch: float, yaw: float) -> TransformStamped:
    """Set the rotation of a transform and return it."""
    q = msg.transform.rotation
    q.x, q.y, q.z, q.w = map(float, quaternion_from_euler(roll, pitch, yaw))
    return msg


class FramePublisher(Node):
    """Broadcasts the pose of the turtle `turtlename` in the frame world."""

    def __init__(self) -> None:
        super().__init__("turtle_tf2_frame_publisher")
        self.turtle = str(self.declare_parameter("turtlename", "turtle").value)
        self._broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, f"/{self.turtle}/pose", self._tell, 1)

    def _tell(self, pose: Pose) -> None:
        msg = transform(self, "world", self.turtle, pose.x, pose.y)
        self._broadcaster.sendTransform(turn(msg, 0.0, 0.0, pose.theta))


class FixedFrameBroadcaster(Node):
    """Broadcasts the frame carrot1, two metres beside turtle1, ten times a second."""

    def __init__(self) -> None:
        super().__init__("fixed_frame_tf2_broadcaster")
        self._broadcaster = TransformBroadcaster(self)
        self.create_timer(0.1, self._tell)

    def _tell(self) -> None:
        self._broadcaster.sendTransform(transform(self, "turtle1", "carrot1", 0.0, 2.0))


class DynamicFrameBroadcaster(Node):
    """Broadcasts the frame carrot1, which circles turtle1 at ten metres."""

    def __init__(self) -> None:
        super().__init__("dynamic_frame_tf2_broadcaster")
        self._broadcaster = TransformBroadcaster(self)
        self.create_timer(0.1, self._tell)

    def _tell(self) -> None:
        seconds, _ = self.get_clock().now().seconds_nanoseconds()
        x, y = 10.0 * math.sin(seconds * math.pi), 10.0 * math.cos(seconds * math.pi)
        self._broadcaster.sendTransform(transform(self, "turtle1", "carrot1", x, y))


class StaticFramePublisher(Node):
    """Broadcasts one static transform: child x y z roll pitch yaw, in the frame world."""

    def __init__(self, child: str, numbers: list[float]) -> None:
        super().__init__("static_turtle_tf2_broadcaster")
        self._broadcaster = StaticTransformBroadcaster(self)
        self._broadcaster.sendTransform(turn(transform(self, "world", child, *numbers[:3]), *numbers[3:]))


def turtle() -> None:
    """Run turtle_tf2_broadcaster."""
    run(FramePublisher)


def fixed() -> None:
    """Run fixed_frame_tf2_broadcaster."""
    run(FixedFrameBroadcaster)


def dynamic() -> None:
    """Run dynamic_frame_tf2_broadcaster."""
    run(DynamicFrameBroadcaster)


def static() -> int:
    """Run static_turtle_tf2_broadcaster."""
    if len(sys.argv) != 8:
        print(
            "Invalid number of parameters. Usage: \n"
            "$ ros2 run turtle_tf2_py static_turtle_tf2_broadcaster child_frame_name x y z roll pitch yaw"
        )
        return 1
    if sys.argv[1] == "world":
        print('Your static turtle name cannot be "world"')
        return 2
    run(lambda: StaticFramePublisher(sys.argv[1], [float(word) for word in sys.argv[2:]]))
    return 0
