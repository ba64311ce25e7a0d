"""A talker that alternates a number and a text: C++ would loan their memory, Python cannot."""

from __future__ import annotations

from rclpy.logging import get_logger
from std_msgs.msg import Float64, String

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run

NOT_LOANED = "Currently used middleware can't loan messages. Local allocator will be used."


class LoanedTalker(CppNode):
    """Publishes a count on chatter_pod and the next one as a greeting on chatter, each second."""

    def __init__(self) -> None:
        super().__init__("loaned_message_talker")
        self._count = 1
        self._rclcpp = get_logger("rclcpp")
        self._numbers = self.create_publisher(Float64, "chatter_pod", 7)
        self._texts = self.create_publisher(String, "chatter", 7)
        self._timer = self.create_timer(1.0, self._say)

    def _say(self) -> None:
        number, text = Float64(data=float(self._count)), String(data=f"Hello World: {self._count + 1}")
        self._count += 2
        self._rclcpp.info(NOT_LOANED, once=True)  # rclcpp logs it at the first loan of each type
        self.get_logger().info(f"Publishing: '{number.data:f}'")
        self._numbers.publish(number)
        self._rclcpp.info(NOT_LOANED, once=True)
        self.get_logger().info(f"Publishing: '{text.data}'")
        self._texts.publish(text)


def main(args: list[str] | None = None) -> int:
    """Talk until Ctrl-C."""
    return run(LoanedTalker, args)
