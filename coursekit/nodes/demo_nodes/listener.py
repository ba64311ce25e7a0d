"""Logs the messages on /chatter."""

from rclpy.node import Node
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from std_msgs.msg import String

from coursekit.nodes.cpp_node import as_cpp
from coursekit.nodes.demo_nodes.spinning import spin_demo
from coursekit.nodes.running import run


class Listener(Node):
    """Logs every message."""

    def __init__(self, qos: QoSProfile | int = 10) -> None:
        super().__init__("listener")
        self._subscription = self.create_subscription(String, "chatter", self._heard, qos)

    def _heard(self, msg: String) -> None:
        self.get_logger().info(f"I heard: [{msg.data}]")


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    spin_demo(Listener, args)


def main_cpp(args: list[str] | None = None) -> int:
    """Run it as demo_nodes_cpp's listener."""
    return run(as_cpp(Listener), args)


def best_effort(args: list[str] | None = None) -> int:
    """Run demo_nodes_cpp's listener with the QoS of sensors."""
    return run(lambda: as_cpp(Listener)(qos_profile_sensor_data), args)
