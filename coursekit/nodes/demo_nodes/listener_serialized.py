"""A listener that takes the bytes of each message as they travel."""

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class SerializedSubscriber(Node):
    """Logs the serialized messages of `chatter`."""

    def __init__(self) -> None:
        super().__init__("serialized_subscriber")
        self.subscription = self.create_subscription(String, "chatter", self._heard, 10, raw=True)

    def _heard(self, data: bytes) -> None:
        self.get_logger().info(f'I heard: "{data!r}"')


def main(args: list[str] | None = None) -> None:
    """Listen until Ctrl-C."""
    rclpy.init(args=args)
    node = SerializedSubscriber()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    except ExternalShutdownException:
        sys.exit(1)
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
