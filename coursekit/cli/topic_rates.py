"""`ros2 topic hz`, `delay` and `bw`: statistics of a topic, printed about once a second."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from rosidl_runtime_py.utilities import get_message

from coursekit.processes.session import current

from . import api

if TYPE_CHECKING:
    from argparse import Namespace

    from rclpy.node import Node

WINDOW = 10000


def register(verbs: Any) -> None:
    """Add the verbs."""
    for name, text, make in (
        ("hz", "Print the average publishing rate to screen", Hz),
        ("delay", "Display delay of topic from timestamp in header", Delay),
        ("bw", "Display bandwidth used by topic", Bandwidth),
    ):
        parser = verbs.add_parser(name, help=text)
        parser.add_argument("topic_name", help="Name of the ROS topic to listen to").completer = api.complete_topics
        parser.add_argument(
            "-w", "--window", type=int, default=100 if name == "bw" else WINDOW, help="Window size in messages"
        )
        if name == "hz":
            parser.add_argument("--filter", dest="filter_expr", help="Only measure messages for which this is true")
            parser.add_argument("--wall-time", action="store_true", help="Use the session's time, not /clock")
        parser.set_defaults(main=lambda args, make=make: _run(args, make))


def _run(args: Namespace, make: Any) -> int:
    with api.command_node(**api.on_clock(args)) as node:
        name = api.full_name(args.topic_name)
        types = dict(node.get_topic_names_and_types()).get(name)
        if types is None:
            print(f"WARNING: topic [{args.topic_name}] does not appear to be published yet")
            while types is None and rclpy.ok():
                rclpy.spin_once(node, timeout_sec=0.1)
                types = dict(node.get_topic_names_and_types()).get(name)
        if not types:
            return 1
        meter = make(node, args)
        node.create_subscription(
            get_message(types[0]), args.topic_name, meter.count, qos_profile_sensor_data, raw=make is Bandwidth
        )
        node.create_timer(1.0, meter.report)
        rclpy.spin(node)
    return 0


def statistics(values: Sequence[float]) -> tuple[float, float, float, float]:
    """Return mean, minimum, maximum and standard deviation.

    >>> statistics([1.0, 3.0])
    (2.0, 1.0, 3.0, 1.0)
    """
    mean = sum(values) / len(values)
    deviation = math.sqrt(sum((value - mean) ** 2 for value in values) / len(values))
    return mean, min(values), max(values), deviation


class _Meter:
    """Counts messages and prints statistics."""

    def __init__(self, node: Node, args: Namespace) -> None:
        self.node = node
        self.args = args
        self.values: deque[float] = deque(maxlen=args.window - 1 if args.window > 1 else None)
        self.arrived = 0
        self.reported = 0

    def now(self) -> float:
        """Return seconds on the node's clock, or on the session's if requested."""
        if getattr(self.args, "wall_time", False):
            return float(current().clock.steady()) * 1e-9
        return float(self.node.get_clock().now().nanoseconds) * 1e-9

    def report(self) -> None:
        """Print the statistics, if messages have arrived since the last report."""
        if self.arrived == self.reported or not self.values:
            return
        self.reported = self.arrived
        self.show()

    def show(self) -> None:
        """Print the statistics."""
        raise NotImplementedError


class Hz(_Meter):
    """The publishing rate."""

    def __init__(self, node: Node, args: Namespace) -> None:
        super().__init__(node, args)
        self._last: float | None = None
        self._accepts = compile(args.filter_expr, "--filter", "eval") if args.filter_expr else None

    def count(self, msg: Any) -> None:
        """Count a message."""
        if self._accepts is not None and not eval(self._accepts, {"m": msg}):
            return
        now = self.now()
        if self._last is not None:
            self.values.append(now - self._last)
        self._last = now
        self.arrived += 1

    def show(self) -> None:
        mean, least, greatest, deviation = statistics(self.values)
        print(
            f"average rate: {1.0 / mean if mean else math.inf:.3f}\n"
            f"\tmin: {least:.3f}s max: {greatest:.3f}s std dev: {deviation:.5f}s window: {len(self.values) + 1}"
        )


class Delay(_Meter):
    """The age of messages at arrival."""

    def count(self, msg: Any) -> None:
        """Count a message."""
        if not hasattr(msg, "header"):
            raise api.Unhappy("msg does not have header")
        stamp = Time.from_msg(msg.header.stamp).nanoseconds
        if stamp:
            self.values.append(self.now() - stamp * 1e-9)
            self.arrived += 1

    def show(self) -> None:
        mean, least, greatest, deviation = statistics(self.values)
        print(
            f"average delay: {mean:.3f}\n"
            f"\tmin: {least:.3f}s max: {greatest:.3f}s std dev: {deviation:.5f}s window: {len(self.values)}"
        )


class Bandwidth(_Meter):
    """The bandwidth in bytes per second."""

    def __init__(self, node: Node, args: Namespace) -> None:
        super().__init__(node, args)
        self._sizes: deque[int] = deque(maxlen=args.window)
        self._times: deque[float] = deque(maxlen=args.window)
        print(f"Subscribed to [{api.full_name(args.topic_name)}]")

    def count(self, data: bytes) -> None:
        """Count a message."""
        size = -(-len(data) // 4) * 4  # as on a network, padded to whole words
        self._sizes.append(size)
        self._times.append(self.now())
        self.values.append(size)
        self.arrived += 1

    def show(self) -> None:
        if len(self._times) < 2:
            return
        total = sum(self._sizes)
        rate = total / max(self.now() - self._times[0], 1e-9)
        mean, least, most = (_bytes(size, rate) for size in (total / len(self._sizes), min(self._sizes), max(self._sizes)))
        print(f"{_bytes(rate, rate)}/s from {len(self._sizes)} messages")
        print(f"\tMessage size mean: {mean} min: {least} max: {most}")


def _bytes(size: float, rate: float) -> str:
    """Format a size in a unit suited to the rate [B/s]: all figures of a report share it.

    >>> _bytes(96, 960), _bytes(24, 1500), _bytes(2e6, 6e6)
    ('96 B', '0.02 KB', '2.00 MB')
    """
    if rate < 1000:
        return f"{size:.0f} B"
    return f"{size / 1e3:.2f} KB" if rate < 1e6 else f"{size / 1e6:.2f} MB"
