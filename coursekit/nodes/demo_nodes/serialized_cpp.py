"""Talker and listener that show each message in serialized form."""

from __future__ import annotations

from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import String

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run


class SerializedTalker(CppNode):
    """Publishes a counted greeting that it serializes itself."""

    def __init__(self) -> None:
        super().__init__("serialized_message_talker")
        self._count = 1
        self._publisher = self.create_publisher(String, "chatter", 7)
        self._timer = self.create_timer(1.0, self._say)

    def _say(self) -> None:
        msg = String(data=f"Hello World:{self._count}")
        self._count += 1
        data = serialize_message(msg)
        print(f"ROS message:\n{msg.data}\nserialized message:\n{data.hex(' ')} ")
        self._publisher.publish(data)


class SerializedListener(CppNode):
    """Prints the bytes and their message."""

    def __init__(self) -> None:
        super().__init__("serialized_message_listener")
        self._subscription = self.create_subscription(String, "chatter", self._heard, 10, raw=True)

    def _heard(self, data: bytes) -> None:
        said = deserialize_message(data, String).data
        print(f"I heard data of length: {len(data)}\n{data.hex(' ')} \nserialized data after deserialization: {said}")


def talker(args: list[str] | None = None) -> int:
    """Talk until Ctrl-C."""
    return run(SerializedTalker, args)


def listener(args: list[str] | None = None) -> int:
    """Listen until Ctrl-C."""
    return run(SerializedListener, args)
