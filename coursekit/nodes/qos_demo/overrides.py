"""A talker and a listener whose QoS can be set with parameters: qos_overrides./TOPIC.publisher.depth and so on."""

from __future__ import annotations

from collections.abc import Iterable

from rclpy.node import Node
from rclpy.qos import QoSPolicyKind, QoSProfile
from rclpy.qos_overriding_options import InvalidQosOverridesError, QosCallbackResult, QoSOverridingOptions
from rclpy.time import Time
from sensor_msgs.msg import Image
from std_msgs.msg import String

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run

TOPIC = "qos_overrides_chatter"
MEBIBYTE = 1024 * 1024
MOST = 10  # the largest depth that is allowed
IN_CPP = (QoSPolicyKind.DEPTH, QoSPolicyKind.DURABILITY, QoSPolicyKind.HISTORY, QoSPolicyKind.RELIABILITY)


def options(reason: str, kinds: Iterable[QoSPolicyKind] = ()) -> QoSOverridingOptions:
    """The policies that may be overridden: these, or the default ones; a depth of more than ten is rejected."""

    def judge(qos: QoSProfile) -> QosCallbackResult:
        return QosCallbackResult(successful=qos.depth <= MOST, reason="" if qos.depth <= MOST else reason)

    if not kinds:
        return QoSOverridingOptions.with_default_policies(callback=judge)
    return QoSOverridingOptions(kinds, callback=judge)


_PY = "expected qos depth less than 10"
_CPP = "expected history depth less or equal than 10"


class TextTalker(Node):
    """Publishes a greeting each second, as the Python demo does."""

    def __init__(self) -> None:
        super().__init__("qos_overrides_talker")
        self._count = 0
        self._publisher = self.create_publisher(String, TOPIC, 10, qos_overriding_options=options(_PY))
        self.create_timer(1.0, self._say)

    def _say(self) -> None:
        msg = String(data=f"Hello World: {self._count}")
        self._count += 1
        self.get_logger().info(f'Publishing: "{msg.data}"')
        self._publisher.publish(msg)


class TextListener(Node):
    """Logs greetings, as the Python demo does."""

    def __init__(self) -> None:
        super().__init__("qos_overrides_listener")
        self.create_subscription(String, TOPIC, self._heard, 10, qos_overriding_options=options(_PY))

    def _heard(self, msg: String) -> None:
        self.get_logger().info(f"I heard: [{msg.data}]")


class ImageTalker(CppNode):
    """Publishes an image every three seconds, each a mebibyte larger than the last, as the C++ demo does."""

    def __init__(self) -> None:
        super().__init__("qos_overrides_talker")
        self._count = 0
        self._publisher = self.create_publisher(Image, TOPIC, 1, qos_overriding_options=options(_CPP, IN_CPP))
        self.create_timer(3.0, self._publish)

    def _publish(self) -> None:
        self._count += 1
        now = self.get_clock().now()
        msg = Image(data=bytes(self._count * MEBIBYTE))
        msg.header.stamp = now.to_msg()
        self.get_logger().info(f"Publishing an image, sent at [{now.nanoseconds * 1e-9:f}]")
        self._publisher.publish(msg)


class ImageListener(CppNode):
    """Logs the latency of each image, as the C++ demo does."""

    def __init__(self) -> None:
        super().__init__("qos_overrides_listener")
        self.create_subscription(Image, TOPIC, self._heard, 1, qos_overriding_options=options(_CPP, IN_CPP))

    def _heard(self, msg: Image) -> None:
        took = (self.get_clock().now() - Time.from_msg(msg.header.stamp)).nanoseconds * 1e-9
        self.get_logger().info(f"I heard an image. Message single trip latency: [{took:f}]")


def talker(args: list[str] | None = None) -> int:
    """Run the talker of the Python demo."""
    return run(TextTalker, args)


def listener(args: list[str] | None = None) -> int:
    """Run the listener of the Python demo."""
    return run(TextListener, args)


def talker_cpp(args: list[str] | None = None) -> int:
    """Run the talker of the C++ demo."""
    return run(ImageTalker, args, refuses=(InvalidQosOverridesError,))


def listener_cpp(args: list[str] | None = None) -> int:
    """Run the listener of the C++ demo."""
    return run(ImageListener, args, refuses=(InvalidQosOverridesError,))
