"""`tf2_monitor`: the delay and the frequency of transforms."""

from __future__ import annotations

import sys
from collections import deque
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from rclpy.utilities import remove_ros_args
from tf2_msgs.msg import TFMessage
from tf2_ros import Buffer, TransformException, TransformListener

from coursekit.processes.session import current

PERIOD_SECONDS = 0.5
PERIODS = 20
"""The number of periods between two reports: ten seconds."""
KEPT = 1000
NOBODY = "<no authority available>"


class Monitor(Node):
    """Measures the age of the transforms that arrive on /tf and /tf_static."""

    def __init__(self, chain_ends: tuple[str, str] | None) -> None:
        super().__init__("tf2_monitor_main")
        self.ends = chain_ends
        self.buffer = Buffer(node=self)
        self.delays: dict[str, deque[float]] = {}
        self.averages: deque[float] = deque(maxlen=KEPT)
        self.arrivals: deque[float] = deque(maxlen=KEPT)
        self.net_average = self.net_largest = 0.0
        self.create_subscription(TFMessage, "tf", self._take, QoSProfile(depth=100))
        static = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(TFMessage, "tf_static", self._take, static)
        self.listener = TransformListener(self.buffer, self, spin_thread=True)

    def age(self, stamp: Any) -> float:
        """Seconds since a stamp."""
        return (self.get_clock().now().nanoseconds - stamp.sec * 1_000_000_000 - stamp.nanosec) * 1e-9

    def _take(self, msg: TFMessage) -> None:
        total = 0.0
        for transform in msg.transforms:
            delay = self.age(transform.header.stamp)
            total += delay
            self.delays.setdefault(transform.child_frame_id, deque(maxlen=KEPT)).append(delay)
        self.averages.append(total / max(1, len(msg.transforms)))
        self.arrivals.append(self.get_clock().now().nanoseconds * 1e-9)

    def measure(self) -> None:
        """Measure the age of the whole chain."""
        if self.ends is None:
            return
        stamp = self.buffer.lookup_transform(*self.ends, Time()).header.stamp
        age = self.age(stamp)
        self.net_average = 0.01 * age + 0.99 * self.net_average
        self.net_largest = max(self.net_largest, age)

    def chain(self) -> list[str]:
        """The frames from the first end to the second."""
        if self.ends is None:
            return []
        first, second = self.ends
        return self.buffer._chain(second, Time(), first, Time(), second)

    def report(self, chain: list[str]) -> str:
        """The results as text."""
        lines = ["", "", "", f"RESULTS: for {'all Frames' if self.ends is None else ' to '.join(self.ends)}"]
        if self.ends is not None:
            lines.append(f"Chain is: {' -> '.join(chain)}")
            lines.append(f"Net delay     avg = {self.net_average:g}: max = {self.net_largest:g}")
        lines += ["", "Frames:"]
        for frame in sorted(self.delays):
            if self.ends is None or frame in chain:
                lines.append(f"Frame: {frame}, published by {NOBODY}, {_delays(self.delays[frame], ', ')}")
        lines += ["", "All Broadcasters:"]
        if self.arrivals:
            span = max(1e-8, self.arrivals[-1] - self.arrivals[0])
            lines.append(f"Node: {NOBODY} {len(self.arrivals) / span:g} Hz, {_delays(self.averages, ' ')}")
        return "\n".join(lines)


def _delays(delays: Any, between: str) -> str:
    return f"Average Delay: {sum(delays) / len(delays):g}{between}Max Delay: {max(0.0, *delays):g}"


def _run(monitor: Monitor) -> None:
    clock = current().clock
    chain: list[str] = []
    if monitor.ends is not None:
        first, second = monitor.ends
        print(f"Waiting for transform chain to become available between {first} and {second} ", end="", flush=True)
        while rclpy.ok() and not monitor.buffer.can_transform_core(first, second, Time())[0]:
            print(".", end="", flush=True)
            clock.sleep(1.0)
        print(flush=True)
        chain = monitor.chain()
    counter = 0
    while rclpy.ok():
        counter += 1
        monitor.measure()
        clock.sleep(PERIOD_SECONDS)
        if counter > PERIODS:
            counter = 0
            print(monitor.report(chain), flush=True)


def main() -> int:
    """Report until Ctrl-C."""
    rclpy.init(args=sys.argv)
    args = remove_ros_args(sys.argv)[1:]
    if len(args) not in (0, 2):
        print("TF_Monitor: usage: tf2_monitor framea frameb")
        return 255
    monitor = Monitor((args[0], args[1]) if args else None)
    try:
        _run(monitor)
    except TransformException as error:
        print(f"Transform Exception {error}")
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
    return 0
