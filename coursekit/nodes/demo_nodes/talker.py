"""Publishes a counted greeting on /chatter once a second."""

from rclpy.node import Node
from std_msgs.msg import String

from coursekit.nodes.cpp_node import as_cpp
from coursekit.nodes.demo_nodes.spinning import spin_demo
from coursekit.nodes.running import run


class Talker(Node):
    """Publishes greetings repeatedly."""

    def __init__(self, first: int = 0, quote: str = '"') -> None:
        super().__init__("talker")
        self._count = first
        self._quote = quote
        self._publisher = self.create_publisher(String, "chatter", 10)
        self._timer = self.create_timer(1.0, self._say)

    def _say(self) -> None:
        msg = String(data=f"Hello World: {self._count}")
        self._count += 1
        self.get_logger().info(f"Publishing: {self._quote}{msg.data}{self._quote}")
        self._publisher.publish(msg)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    spin_demo(Talker, args)


def main_cpp(args: list[str] | None = None) -> int:
    """Run it as demo_nodes_cpp's talker, which counts from 1."""
    return run(lambda: as_cpp(Talker)(1, "'"), args)
