"""`ros2 doctor hello`: do computers reach each other, by a topic and by multicast?"""

from __future__ import annotations

import contextlib
import socket
from collections import Counter
from typing import TYPE_CHECKING, Any

from ros2multicast.api import DEFAULT_GROUP, DEFAULT_PORT, join, send

from coursekit.processes.session import current

from . import api
from .topic_pub import positive

if TYPE_CHECKING:
    from argparse import Namespace

    from rclpy.node import Node


def register(verbs: Any) -> None:
    """Add the verb."""
    parser = verbs.add_parser("hello", help="Check network connectivity between multiple hosts")
    parser.add_argument("-t", "--topic", nargs="?", default="/canyouhearme", help="Name of ROS topic to publish to")
    parser.add_argument(
        "-ep", "--emit-period", metavar="N", type=positive, default=0.1, help="Time period to publish/send one message"
    )
    parser.add_argument(
        "-pp", "--print-period", metavar="N", type=positive, default=1.0, help="Time period to print summary table"
    )
    parser.add_argument("--ttl", type=int, help="TTL for multicast send")
    parser.add_argument("-1", "--once", action="store_true", help="Send once and exit")
    parser.set_defaults(main=main)


class _Summary:
    """The messages sent and received within one print period."""

    def __init__(self) -> None:
        self.published = 0
        self.sent = 0
        self.heard: Counter[str] = Counter()
        self.received: Counter[str] = Counter()

    def show(self, topic: str, period: float) -> None:
        """Print the summary."""
        print("MULTIMACHINE COMMUNICATION SUMMARY")
        print(f"Topic: {topic}, Published Msg Count: {self.published}")
        print("Subscribed from:")
        _show_table(self.heard, period)
        print(f"Multicast Group/Port: {DEFAULT_GROUP}/{DEFAULT_PORT}, Sent Msg Count: {self.sent}")
        print("Received from:")
        _show_table(self.received, period)
        print("-" * 60)


def _show_table(counter: Counter[str], period: float) -> None:
    for row in (("Hostname", f"Msg Count /{period}s"), *counter.items()):
        print("{:<15} {:<20} {:<10}".format("", *row))


def _count(counter: Counter[str], text: str) -> None:
    """Count a greeting from another computer."""
    name = text.rpartition(" ")[2]
    if name != socket.gethostname():
        counter[name] += 1


def main(args: Namespace) -> None:
    """Send greetings, receive those of others, and print a summary."""
    from std_msgs.msg import String

    with api.command_node("_ros2doctor_hello") as node, contextlib.closing(_listening()) as datagrams:
        hello = _Hello(node.create_publisher(String, args.topic, 10), datagrams, args)
        node.create_subscription(String, args.topic, lambda msg: _count(hello.summary.heard, msg.data), 10)
        hello.run(node)


def _listening() -> socket.socket:
    """Return a non-blocking socket for multicast datagrams."""
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP)
    receiver.setblocking(False)
    with contextlib.suppress(OSError):  # without a network no datagrams arrive
        join(receiver)
    return receiver


class _Hello:
    """Sends and receives greetings repeatedly."""

    def __init__(self, publisher: Any, datagrams: socket.socket, args: Namespace) -> None:
        self._publisher = publisher
        self._datagrams = datagrams
        self._args = args
        self.summary = _Summary()

    def run(self, node: Node) -> None:
        """Send and receive until Ctrl-C, or once."""
        import rclpy

        rounds = 1 if self._args.once else max(1, round(self._args.print_period / self._args.emit_period))
        while rclpy.ok():
            for _ in range(rounds):
                self._greet()
                self._listen(node)
            self.summary.show(self._args.topic, self._args.print_period)
            if self._args.once:
                return
            self.summary = _Summary()

    def _greet(self) -> None:
        from std_msgs.msg import String

        text = f"hello, it's me {socket.gethostname()}"
        self._publisher.publish(String(data=text))
        self.summary.published += 1
        with contextlib.suppress(OSError):  # no network: the summary shows that none was sent
            send(text.encode(), ttl=self._args.ttl)
            self.summary.sent += 1

    def _listen(self, node: Node) -> None:
        """Receive on the topic and by multicast until the next greeting is due."""
        import rclpy

        end = current().clock.steady() + int(self._args.emit_period * 1e9)
        while rclpy.ok() and (left := end - current().clock.steady()) > 0:
            rclpy.spin_once(node, timeout_sec=left / 1e9)
        with contextlib.suppress(OSError):  # no more datagrams
            while True:
                _count(self.summary.received, self._datagrams.recv(4096).decode(errors="replace"))
