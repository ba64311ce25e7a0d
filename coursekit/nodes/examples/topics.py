"""A minimal publisher and subscriber; the C++ examples greet with a comma and other quotes."""

from rclpy.duration import Duration
from rclpy.node import Node
from std_msgs.msg import String

from coursekit.nodes.cpp_node import CppNode, as_cpp
from coursekit.nodes.running import run


class MinimalPublisher(Node):
    """Publishes a counted greeting on /topic twice a second."""

    def __init__(self, greeting: str = "Hello World: ", quote: str = '"', name: str = "minimal_publisher") -> None:
        super().__init__(name)
        self._greeting = greeting
        self._quote = quote
        self._count = 0
        self._publisher = self.create_publisher(String, "topic", 10)
        self._timer = self.create_timer(0.5, self._say)

    def _say(self) -> None:
        msg = String(data=f"{self._greeting}{self._count}")
        self._count += 1
        self._publisher.publish(msg)
        self.get_logger().info(f"Publishing: {self._quote}{msg.data}{self._quote}")


class AcknowledgedPublisher(MinimalPublisher):
    """Reports before its end whether all subscribers have acknowledged its messages."""

    def __init__(self) -> None:
        super().__init__("Hello, world! ", "'", "minimal_publisher_with_wait_for_all_acked")
        self.context.on_shutdown(self._tell)

    def _tell(self) -> None:
        patience = Duration(nanoseconds=300_000_000)
        if self._publisher.wait_for_all_acked(patience):
            self.get_logger().info("All subscribers acknowledge messages")
        else:
            self.get_logger().info(f"Not all subscribers acknowledge messages during {patience.nanoseconds // 10**6} ms")


class MinimalSubscriber(Node):
    """Logs the messages on /topic."""

    def __init__(self, quote: str = '"') -> None:
        super().__init__("minimal_subscriber")
        self._quote = quote
        self._subscription = self.create_subscription(String, "topic", self._heard, 10)

    def _heard(self, msg: String) -> None:
        self.get_logger().info(f"I heard: {self._quote}{msg.data}{self._quote}")


def publisher(args: list[str] | None = None) -> int:
    """Publish until Ctrl-C."""
    return run(MinimalPublisher, args)


def publisher_cpp(args: list[str] | None = None) -> int:
    """Publish as the C++ examples do."""
    return run(lambda: as_cpp(MinimalPublisher)("Hello, world! ", "'"), args)


def publisher_acknowledged_cpp(args: list[str] | None = None) -> int:
    """Publish until Ctrl-C, and wait for the acknowledgements."""
    return run(as_cpp(AcknowledgedPublisher), args)


def subscriber(args: list[str] | None = None) -> int:
    """Listen until Ctrl-C."""
    return run(MinimalSubscriber, args)


def subscriber_cpp(args: list[str] | None = None) -> int:
    """Listen as the C++ examples do."""
    return run(lambda: as_cpp(MinimalSubscriber)("'"), args)


class MinimalTimer(CppNode):
    """Logs a greeting twice a second."""

    def __init__(self) -> None:
        super().__init__("minimal_timer")
        self._timer = self.create_timer(0.5, lambda: self.get_logger().info("Hello, world!"))


def timer_cpp(args: list[str] | None = None) -> int:
    """Log greetings until Ctrl-C."""
    return run(MinimalTimer, args)
