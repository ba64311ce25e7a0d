"""A thermometer, and a listener that receives only extreme temperatures."""

from __future__ import annotations

from std_msgs.msg import Float32

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run

COLDEST, HOTTEST, STEP = -100.0, 150.0, 10.0  # degrees
TOO_COLD, TOO_HOT = -30.0, 100.0


class Thermometer(CppNode):
    """Publishes a rising temperature, and starts again at the end."""

    def __init__(self) -> None:
        super().__init__("content_filtering_publisher")
        self._degrees = COLDEST
        self._publisher = self.create_publisher(Float32, "temperature", 7)
        self.create_timer(self.declare_parameter("publish_ms", 1000).value / 1000, self._measure)

    def _measure(self) -> None:
        msg = Float32(data=self._degrees)
        self._degrees = COLDEST if self._degrees + STEP > HOTTEST else self._degrees + STEP
        self.get_logger().info(f"Publishing: '{msg.data:f}'")
        self._publisher.publish(msg)


class TimerHandle(CppNode):
    """Receives extreme temperatures. rclpy has no content filters, so others are dropped here, not by the middleware."""

    def __init__(self) -> None:
        super().__init__("content_filtering_subscriber")
        subscription = self.create_subscription(Float32, "temperature", self._heard, 10)
        self.get_logger().info(
            f'subscribed to topic "{subscription.topic_name}" with content filter options '
            f'"data < %0 OR data > %1, {{{TOO_COLD:f}, {TOO_HOT:f}}}"'
        )

    def _heard(self, msg: Float32) -> None:
        if msg.data < TOO_COLD or msg.data > TOO_HOT:
            self.get_logger().info(f"I receive an emergency temperature data: [{msg.data:f}]")


def publisher(args: list[str] | None = None) -> int:
    """Measure until Ctrl-C."""
    return run(Thermometer, args)


def subscriber(args: list[str] | None = None) -> int:
    """Listen until Ctrl-C."""
    return run(TimerHandle, args)
