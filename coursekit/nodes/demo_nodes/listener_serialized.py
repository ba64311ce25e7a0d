"""A listener that takes messages in serialized form."""

from rclpy.node import Node
from std_msgs.msg import String

from coursekit.nodes.demo_nodes.spinning import spin_demo


class SerializedSubscriber(Node):
    """Logs the serialized messages of `chatter`."""

    def __init__(self) -> None:
        super().__init__("serialized_subscriber")
        self.subscription = self.create_subscription(String, "chatter", self._heard, 10, raw=True)

    def _heard(self, data: bytes) -> None:
        self.get_logger().info(f'I heard: "{data!r}"')


def main(args: list[str] | None = None) -> None:
    """Listen until Ctrl-C."""
    spin_demo(SerializedSubscriber, args)
