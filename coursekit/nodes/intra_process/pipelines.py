"""Two nodes in one process that pass numbers on without copying, as the address shows."""

from __future__ import annotations

import time

import rclpy
from std_msgs.msg import Int32

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.intra_process.handover import Handover
from coursekit.nodes.running import spin_to_the_end

FIRST = 42


def told(text: str, msg: Int32) -> str:
    """Return a line with a message's value and memory address."""
    return f"{text} {msg.data}, and address: 0x{id(msg):X}"


def _value(msg: Int32) -> int:
    return msg.data  # type: ignore[no-any-return]


class Producer(CppNode):
    """Publishes a counter every second."""

    def __init__(self, name: str, output: str, handover: Handover) -> None:
        super().__init__(name)
        self._count = 0
        self._handover = handover
        self._publisher = self.create_publisher(Int32, output, 10)
        self.create_timer(1.0, self._produce)

    def _produce(self) -> None:
        msg = Int32(data=self._count)
        self._count += 1
        print(told("Published message with value:", msg))
        self._handover.publish(self._publisher, msg)


class Consumer(CppNode):
    """Logs what it receives."""

    def __init__(self, name: str, source: str, handover: Handover) -> None:
        super().__init__(name)
        self._handover = handover
        self._subscription = self.create_subscription(Int32, source, self._consume, 10)

    def _consume(self, copy: Int32) -> None:
        print(told(" Received message with value:", self._handover.take(self._subscription.topic_name, copy)))


class IncrementerPipe(CppNode):
    """Receives a number, waits a second, and publishes the next one."""

    def __init__(self, name: str, source: str, output: str, handover: Handover) -> None:
        super().__init__(name)
        self._handover = handover
        self._publisher = self.create_publisher(Int32, output, 10)
        self._subscription = self.create_subscription(Int32, source, self._pass_on, 10)

    def publish(self, msg: Int32) -> None:
        """Publish a number to the next node."""
        self._handover.publish(self._publisher, msg)

    def _pass_on(self, copy: Int32) -> None:
        msg = self._handover.take(self._subscription.topic_name, copy)
        print(told("Received message with value:        ", msg))
        print("  sleeping for 1 second...")
        time.sleep(1.0)
        print("  done.")
        msg.data += 1
        print(told("Incrementing and sending with value:", msg))
        self.publish(msg)


def two_nodes(args: list[str] | None = None) -> int:
    """Run a producer and a consumer until Ctrl-C."""
    rclpy.init(args=args)
    handover = Handover(_value)
    return spin_to_the_end(Producer("producer", "number", handover), Consumer("consumer", "number", handover))


def cyclic(args: list[str] | None = None) -> int:
    """Pass a number back and forth between two nodes until Ctrl-C."""
    rclpy.init(args=args)
    handover = Handover(_value)
    pipes = [IncrementerPipe("pipe1", "topic1", "topic2", handover), IncrementerPipe("pipe2", "topic2", "topic1", handover)]
    msg = Int32(data=FIRST)
    print(told("Published first message with value: ", msg))
    pipes[0].publish(msg)
    return spin_to_the_end(*pipes)
