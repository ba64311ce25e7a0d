"""`ros2 run topic_monitor data_publisher [NAME]`: publishes a counter with a configurable payload and QoS."""

from __future__ import annotations

import argparse
import sys
from typing import Any

import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rclpy.signals import SignalHandlerOptions
from rclpy.utilities import remove_ros_args
from std_msgs.msg import Header

from coursekit.nodes.running import to_the_end

LAST = -1
"""The number of the last message, which announces the end of the topic to monitors."""


class DataPublisher(Node):
    """Publishes 0, 1, 2, ... and the payload as the frame_id of headers on NAME_data."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.topic = f"{options.data_name}_data{'_best_effort' if options.best_effort else ''}"
        super().__init__(f"{self.topic}_pub")
        self.count = 0
        self.ended = False
        self._most = options.end_after
        self._payload = "a" * options.payload_size
        self._publisher = self.create_publisher(Header, self.topic, self._profile(options))
        self.get_logger().info(f"Publishing on topic: {self.topic}")
        self.get_logger().info(f"Payload size: {options.payload_size}")
        self._next()
        self.create_timer(options.period, self._next)

    def _profile(self, options: argparse.Namespace) -> QoSProfile:
        log = self.get_logger().info
        log(f"Reliability: {'best effort' if options.best_effort else 'reliable'}")
        log(f"History: keep {'all' if options.keep_all else 'last'}")
        log(f"Depth: {options.depth}")
        log(f"Durability: {'transient local' if options.transient_local else 'volatile'}")
        return QoSProfile(
            depth=options.depth,
            history=HistoryPolicy.KEEP_ALL if options.keep_all else HistoryPolicy.KEEP_LAST,
            reliability=ReliabilityPolicy.BEST_EFFORT if options.best_effort else ReliabilityPolicy.RELIABLE,
            durability=DurabilityPolicy.TRANSIENT_LOCAL if options.transient_local else DurabilityPolicy.VOLATILE,
        )

    def _next(self) -> None:
        if self._most is not None and self.count >= self._most:
            self.say(LAST)
            self.ended = True
            return
        self.say(self.count)
        self.count += 1

    def say(self, number: int) -> None:
        """Publish a number."""
        self._publisher.publish(Header(frame_id=f"{number}_{self._payload}"))
        self.get_logger().info(f'Publishing: "{number}"')


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    options: tuple[tuple[str, dict[str, Any]], ...] = (
        ("--best-effort", {"action": "store_true", "help": "Publish with the reliability 'best effort'"}),
        ("--transient-local", {"action": "store_true", "help": "Publish with the durability 'transient local'"}),
        ("--depth", {"type": int, "default": 10, "help": "How many messages the history keeps"}),
        ("--keep-all", {"action": "store_true", "help": "Publish with the history 'keep all'"}),
        ("--payload-size", {"type": int, "default": 0, "help": "Bytes of data to send along"}),
        ("--period", {"type": float, "default": 0.5, "help": "Seconds between two messages"}),
        ("--end-after", {"type": int, "help": "How many messages to publish before it ends"}),
    )
    parser.add_argument("data_name", nargs="?", default="topic1", help="Name of the data, as topics are named")
    for flag, given in options:
        parser.add_argument(flag, **given)
    return parser


def main(args: list[str] | None = None) -> int:
    """Count until Ctrl-C or the requested number; announce the end with a last message."""
    options = _parser().parse_args(remove_ros_args(sys.argv if args is None else args)[1:])
    rclpy.init(args=args, signal_handler_options=SignalHandlerOptions.NO)  # after Ctrl-C, a last message can be published
    node = DataPublisher(options)
    with to_the_end(node):
        try:
            while not node.ended:
                rclpy.spin_once(node)
        except KeyboardInterrupt:
            node.say(LAST)
    return 0
