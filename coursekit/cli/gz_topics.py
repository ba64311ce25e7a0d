"""`gz topic` and `gz service`: the contents of the newer Gazebo's own graph."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any

import rclpy
from rosidl_runtime_py import message_to_yaml
from rosidl_runtime_py.utilities import get_message

from coursekit.nodes.gz.bridge_types import gz_name
from coursekit.nodes.gz.transport import gz_context

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.node import Node

_HIDDEN = ("/rosout", "/parameter_events")


def _arguments(command: str, words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog=f"gz {command}")
    parser.add_argument("-l", "--list", action="store_true", help="list them")
    parser.add_argument("-i", "--info", action="store_true", help="who publishes and listens")
    parser.add_argument("-e", "--echo", action="store_true", help="print messages")
    parser.add_argument("-t", "--topic", "-s", "--service", dest="name", default="", help="its name")
    parser.add_argument("-n", "--num", type=int, default=0, help="print so many messages")
    return parser.parse_args(words)


def carry_out(command: str, words: list[str]) -> int:
    """List topics or services, or print messages. Returns the exit code."""
    told = _arguments(command, words)
    context = gz_context()
    try:
        node = rclpy.create_node("gz_topic", context=context, start_parameter_services=False, enable_rosout=False)
        if command == "service":
            for name, _ in node.get_service_names_and_types():
                if name.startswith("/world/"):
                    print(name)
            return 0
        topics = {name: types for name, types in node.get_topic_names_and_types() if name not in _HIDDEN}
        if told.list:
            print("\n".join(sorted(topics)))
            return 0
        name = "/" + told.name.strip("/")
        if name not in topics:
            print(f"No publishers on topic [{told.name}]. There are: {', '.join(sorted(topics)) or 'none'}", file=sys.stderr)
            return 255
        if told.info:
            count = node.count_publishers(name), node.count_subscribers(name)
            print(f"Publishers [Address, Message Type]:\n  {count[0]}, {gz_name(topics[name][0])}\nSubscribers: {count[1]}")
            return 0
        return _echo(node, context, name, topics[name][0], told.num)
    finally:
        context.try_shutdown()


def _echo(node: Node, context: Context, name: str, kind: str, most: int) -> int:
    seen: list[int] = []

    def show(msg: Any) -> None:
        print(message_to_yaml(msg))
        seen.append(1)

    node.create_subscription(get_message(kind), name, show, 10)
    executor = rclpy.executors.SingleThreadedExecutor(context=context)
    executor.add_node(node)
    while context.ok() and not 0 < most <= len(seen):
        executor.spin_once()
    return 0
