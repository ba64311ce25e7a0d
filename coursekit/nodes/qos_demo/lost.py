"""Large images, and a listener that logs how many were lost."""

from __future__ import annotations

import argparse
import sys
from typing import Any

from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.qos_event import SubscriptionEventCallbacks
from rclpy.time import Time
from rclpy.utilities import remove_ros_args
from sensor_msgs.msg import Image

from coursekit.nodes.cpp_node import CppNode, as_cpp
from coursekit.nodes.running import run

TOPIC = "message_lost_chatter"
KIBIBYTES = 8192


class MessageLostTalker(CppNode):
    """Publishes an image of `size` bytes every three seconds."""

    def __init__(self, size: int) -> None:
        super().__init__("message_lost_talker")
        self._msg = Image(data=bytes(size))
        self._publisher = self.create_publisher(Image, TOPIC, 1)
        self.create_timer(3.0, self._publish)

    def _publish(self) -> None:
        now = self.get_clock().now()
        self._msg.header.stamp = now.to_msg()
        self.get_logger().info(f"Publishing an image, sent at [{now.nanoseconds * 1e-9:f}]")
        self._publisher.publish(self._msg)


class MessageLostListener(Node):
    """Logs the latency of each image, and each loss, with the texts of the C++ or the Python demo."""

    def __init__(self, name: str, qos: QoSProfile | int, told: str) -> None:
        super().__init__(name)
        self._told = told
        events = SubscriptionEventCallbacks(message_lost=self._lost)
        self.create_subscription(Image, TOPIC, self._heard, qos, event_callbacks=events)

    def _heard(self, msg: Image) -> None:
        took = (self.get_clock().now() - Time.from_msg(msg.header.stamp)).nanoseconds
        self.get_logger().info(self._told.format(nanoseconds=took, seconds=took * 1e-9))

    def _lost(self, event: Any) -> None:
        self.get_logger().info(
            f"Some messages were lost:\n>\tNumber of new lost messages: {event.total_count_change}"
            f" \n>\tTotal number of messages lost: {event.total_count}"
        )


def talker(args: list[str] | None = None) -> int:
    """Publish until Ctrl-C."""
    parser = argparse.ArgumentParser()
    parser.add_argument("-s", type=int, default=KIBIBYTES, metavar="SIZE", help="Message size in KiB, default to 8192 KiB")
    size = parser.parse_known_args(remove_ros_args(sys.argv if args is None else args)[1:])[0].s
    if size < 0:
        parser.error(f"-s must be followed by a positive integer, got: '{size}'")
    return run(lambda: MessageLostTalker(size * 1024), args)


def listener(args: list[str] | None = None) -> int:
    """Run the listener of the Python demo."""
    told = "I heard an Image. Message single trip latency: [{nanoseconds}]\n---"
    return run(lambda: MessageLostListener("message_lost_listener", 1, told), args)


def listener_cpp(args: list[str] | None = None) -> int:
    """Run the listener of the C++ demo."""
    qos = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    told = "I heard an image. Message single trip latency: [{seconds:f}]"
    return run(lambda: as_cpp(MessageLostListener)("MessageLostListener", qos, told), args)
