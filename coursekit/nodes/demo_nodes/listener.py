"""Prints what it hears on /chatter."""

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    """Logs every message."""

    def __init__(self) -> None:
        super().__init__("listener")
        self._subscription = self.create_subscription(String, "chatter", self._heard, 10)

    def _heard(self, msg: String) -> None:
        self.get_logger().info(f"I heard: [{msg.data}]")


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    rclpy.init(args=args)
    node = Listener()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    except ExternalShutdownException:
        sys.exit(1)
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
