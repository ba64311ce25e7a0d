"""What the tests of `ros2 bag` share."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from typing import Any

import rclpy
from std_msgs.msg import String

from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.storage import Message
from coursekit.bag.writer import BagWriter, WriteSettings
from coursekit.cli.parser import run
from coursekit.processes.session import Session
from tests.bag.made import CHATTER, text_bytes

SECOND = 10**9
START = 1_700_000_000 * SECOND


class Stage:
    """A session on the virtual clock, and what was heard in it."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.heard: list[tuple[str, float]] = []

    def ros2(self, line: str) -> Any:
        """Start a command."""
        return self.session.start(lambda: run(shlex.split(line)), name="ros2")

    def ask(self, line: str) -> str:
        """Carry out a command; its output."""
        process = self.ros2(line)
        process.wait(5)
        return str(process.output)

    def listen(self, topic: str, kind: Any = String, qos: Any = 50, text: Callable[[Any], str] = lambda m: m.data) -> None:
        """Note what comes on a topic, and when."""

        def main() -> None:
            rclpy.init()
            node = rclpy.create_node("ear")

            def note(message: Any) -> None:
                self.heard.append((text(message), (self.session.clock.now() - START) / SECOND))

            node.create_subscription(kind, topic, note, qos)
            try:
                rclpy.spin(node)
            except KeyboardInterrupt:
                pass

        self.session.start(main, name="ear")
        self.session.clock.sleep(0.001)

    def sleep_until(self, seconds: float) -> None:
        """Let the session go to a time."""
        self.session.clock.sleep(seconds - (self.session.clock.now() - START) / SECOND)


def write(name: str, count: int, topic: TopicMetadata = CHATTER, **settings: Any) -> None:
    """Make a bag."""
    writer = BagWriter(WriteSettings(name, **settings))
    writer.create_topic(topic)
    for number in range(count):
        writer.write(Message(topic.name, text_bytes(f"Hello {number}"), (100 + number) * SECOND))
    writer.close()


def lines(process: Any) -> list[str]:
    """What it logged, without times."""
    return [line.split("] ", 2)[0] + "] " + line.split("] ", 2)[2] for line in process.output.splitlines() if "] [" in line]


def stop(session: Session, process: Any) -> None:
    """Press Ctrl-C, and see it end well."""
    process.interrupt()
    assert process.wait(5) == 0
