"""The talker and the listener of the demos."""

from collections.abc import Callable
from typing import Any

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import String

from coursekit.nodes.running import to_the_end


class Talker(Node):
    """Publishes, twice a second by default, `publish_count` times; 0 means without end."""

    NAME, TOLD = "qos_talker", "Publishing: {}"

    def __init__(
        self,
        topic: str,
        qos: QoSProfile,
        *,
        events: Any = None,
        publish_count: int = 0,
        assert_period: float = 0.0,
        period: float = 0.5,
    ) -> None:
        super().__init__(self.NAME)
        self.get_logger().info("Talker starting up")
        self.published = 0
        self._most = publish_count
        self._publisher = self.create_publisher(String, topic, qos, event_callbacks=events)
        self._timer = self.create_timer(period, self.publish)
        self._pause: Any = None
        self._asserting = assert_period and self.create_timer(assert_period, self.assert_liveliness)

    def publish(self) -> None:
        """Publish one message; the last one ends the timer."""
        msg = String(data=f"Talker says {self.published}")
        self.get_logger().info(self.TOLD.format(msg.data))
        self.published += 1
        if self._most and self.published >= self._most:
            self._timer.cancel()
        self._publisher.publish(msg)

    def assert_liveliness(self) -> None:
        """Say that the publisher lives."""
        self._publisher.assert_liveliness()

    def pause_for(self, seconds: float) -> None:
        """Stop publishing for that time; a pause in progress is not extended."""
        if self._pause is None:
            self._timer.cancel()
            self._pause = self.create_timer(seconds, self._go_on)

    def _go_on(self) -> None:
        self.destroy_timer(self._pause)
        self._pause = None
        self.publish()
        self._timer.reset()

    def stop(self) -> None:
        """Stop publishing and asserting liveliness."""
        self._timer.cancel()
        if self._asserting:
            self._asserting.cancel()


class Listener(Node):
    """Logs received messages; with `later`, only after `start_listening`."""

    NAME, TOLD = "qos_listener", "I heard: {}"

    def __init__(self, topic: str, qos: QoSProfile, *, events: Any = None, later: bool = False) -> None:
        super().__init__(self.NAME)
        self._made: Any = None
        self._make: Callable[[], Any] = lambda: self.create_subscription(
            String, topic, self._heard, qos, event_callbacks=events
        )
        if not later:
            self.start_listening()

    def start_listening(self) -> None:
        """Subscribe, unless already subscribed."""
        if self._made is None:
            self._made = self._make()
            self._subscribed()

    def _subscribed(self) -> None:
        self.get_logger().info("Subscription created")

    def _heard(self, msg: String) -> None:
        self.get_logger().info(self.TOLD.format(msg.data))


def spin(listener: Node, talker: Node, goes_on: Callable[[SingleThreadedExecutor], bool] = lambda _: True) -> int:
    """Spin both until Ctrl-C, or until `goes_on` is false."""
    executor = SingleThreadedExecutor()
    executor.add_node(listener)
    executor.add_node(talker)
    with to_the_end():
        while rclpy.ok() and goes_on(executor):
            executor.spin_once()
    return 0
