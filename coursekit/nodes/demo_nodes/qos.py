"""Talker and listener with their reliability set on the command line."""

import argparse
import sys

import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String

from coursekit.nodes.running import to_the_end


class TalkerQos(Node):
    """Greets with a chosen QoS."""

    def __init__(self, qos: QoSProfile) -> None:
        super().__init__("talker_qos")
        self._count = 0
        reliable = qos.reliability.name == "RELIABLE"
        self.get_logger().info(f"{'Reliable' if reliable else 'Best effort'} talker")
        self._publisher = self.create_publisher(String, "chatter", qos)
        self._timer = self.create_timer(1.0, self._say)

    def _say(self) -> None:
        msg = String(data=f"Hello World: {self._count}")
        self._count += 1
        self.get_logger().info(f'Publishing: "{msg.data}"')
        self._publisher.publish(msg)


class ListenerQos(Node):
    """Listens with a chosen QoS."""

    def __init__(self, qos: QoSProfile) -> None:
        super().__init__("listener_qos")
        reliable = qos.reliability.name == "RELIABLE"
        self.get_logger().info(f"{'Reliable' if reliable else 'Best effort'} listener")
        self._subscription = self.create_subscription(String, "chatter", self._heard, qos)

    def _heard(self, msg: String) -> None:
        self.get_logger().info(f"I heard: [{msg.data}]")


def _run(make: type, argv: list[str]) -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--reliable", action="store_true", help="set qos profile to reliable")
    parser.add_argument("-n", "--number_of_cycles", type=int, default=20, help="callbacks before it ends")
    args = parser.parse_args(remove_ros_args(argv)[1:])
    rclpy.init(args=argv)
    node = make(QoSProfile(depth=10) if args.reliable else qos_profile_sensor_data)
    cycles = 0
    with to_the_end(node):
        while rclpy.ok() and cycles < args.number_of_cycles:
            rclpy.spin_once(node)
            cycles += 1


def talker(argv: list[str] | None = None) -> None:
    """Run the talker."""
    _run(TalkerQos, sys.argv if argv is None else argv)


def listener(argv: list[str] | None = None) -> None:
    """Run the listener."""
    _run(ListenerQos, sys.argv if argv is None else argv)
