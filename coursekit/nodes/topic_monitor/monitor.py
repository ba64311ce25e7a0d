"""`ros2 run topic_monitor topic_monitor`: the reception rates of all topics named NAME_data or NAME_data_best_effort."""

from __future__ import annotations

import argparse
import re
import sys
from typing import Any

from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.utilities import remove_ros_args
from std_msgs.msg import Float32, Header

from coursekit.nodes.running import run
from coursekit.nodes.topic_monitor.statistics import TopicStatistics

DEPTH = 10
DISCOVERY_SECONDS = 0.1
_TOPIC = re.compile(r"/(?P<data_name>\w*)_data_?(?P<reliability>\w*)")
_NUMBER = re.compile(r"-?\d+")


class TopicMonitor(Node):
    """Subscribes to topics as they appear, logs when they come, go or get stale, and publishes reception_rate/TOPIC."""

    def __init__(self, options: argparse.Namespace) -> None:
        super().__init__("topic_monitor")
        self._options = options
        self._known: dict[str, TopicStatistics] = {}
        self._statuses: dict[str, str] = {}
        self._rates: dict[str, Any] = {}
        self.create_timer(DISCOVERY_SECONDS, self._look)
        self.create_timer(options.stats_calc_period, self._tell)

    def _look(self) -> None:
        for topic, kinds in self.get_topic_names_and_types():
            match = _TOPIC.fullmatch(topic)
            if match and topic not in self._known and "std_msgs/msg/Header" in kinds:
                self._watch(topic, match["reliability"] == "best_effort")

    def _watch(self, topic: str, best_effort: bool) -> None:
        self.get_logger().info(f"Subscribing to topic: {topic}")
        given = self._options
        known = self._known[topic] = TopicStatistics(
            window=given.window_size, depth=DEPTH, period=given.expected_period, latency=given.allowed_latency,
            stale=given.stale_time,
        )  # fmt: skip
        self._statuses[topic] = "Offline"
        self._rates[topic] = self.create_publisher(Float32, f"reception_rate{topic}", DEPTH)
        reliability = ReliabilityPolicy.BEST_EFFORT if best_effort else ReliabilityPolicy.RELIABLE
        qos = QoSProfile(depth=DEPTH, reliability=reliability)
        self.create_subscription(Header, topic, lambda msg: self._hear(topic, known, msg), qos)

    def _hear(self, topic: str, known: TopicStatistics, msg: Header) -> None:
        if match := _NUMBER.match(msg.frame_id):
            self.get_logger().info(f"{topic}: {match[0]}")
            known.heard(int(match[0]), self._now())

    def _now(self) -> float:
        return self.get_clock().now().nanoseconds * 1e-9

    def _tell(self) -> None:
        now = self._now()
        statuses = {topic: known.status(now) for topic, known in self._known.items()}
        if statuses != self._statuses:
            self._statuses = statuses
            lines = ["---------------", *(f"{topic}: {status}" for topic, status in statuses.items()), "---------------"]
            for line in lines:
                self.get_logger().info(line)
        for topic, known in self._known.items():
            self._rates[topic].publish(Float32(data=known.rate(now)))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("-d", "--display", action="store_true", help="Draw the rates in a window (there is none here)")
    options = (
        ("-t", "--expected-period", float, 0.5, "Seconds between two messages of a topic"),
        ("-s", "--stale-time", float, 1.0, "Seconds of silence after which a topic is stale"),
        ("-l", "--allowed-latency", float, 1.0, "Seconds that a message may take"),
        ("-c", "--stats-calc-period", float, 1.0, "Seconds between two calculations of the rates"),
        ("-n", "--window-size", int, 20, "Over how many messages a rate is calculated"),
    )
    for short, long, kind, default, text in options:
        parser.add_argument(short, long, type=kind, default=default, help=text)
    return parser


def main(args: list[str] | None = None) -> int:
    """Monitor until Ctrl-C."""
    parser = _parser()
    options = parser.parse_args(remove_ros_args(sys.argv if args is None else args)[1:])
    if options.display:
        parser.error("windows cannot be drawn here: `ros2 topic echo /reception_rate/TOPIC` shows a topic's rate")
    if min(options.expected_period, options.stats_calc_period, options.window_size) <= 0:
        parser.error("periods and the window's size are greater than 0")
    return run(lambda: TopicMonitor(options), args)
