"""`gz topic`: what goes on in the newer Gazebo's own graph, and messages into it."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any

import rclpy
from geometry_msgs.msg import PoseStamped
from rosidl_runtime_py import message_to_yaml
from rosidl_runtime_py.utilities import get_message

from coursekit.nodes.gz.bridge_types import carrier_of, gz_name
from coursekit.nodes.gz.text_format import GzTextError, fill
from coursekit.nodes.gz.transport import gz_node

if TYPE_CHECKING:
    from rclpy.node import Node

_HIDDEN = ("/rosout", "/parameter_events")


def _arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="gz topic")
    parser.add_argument("-l", "--list", action="store_true", help="list the topics")
    parser.add_argument("-i", "--info", action="store_true", help="who publishes and listens")
    parser.add_argument("-e", "--echo", action="store_true", help="print messages")
    parser.add_argument("-t", "--topic", dest="name", default="", help="its name")
    parser.add_argument("-m", "--msgtype", default="", help="the type of what is published, such as gz.msgs.Twist")
    parser.add_argument("-p", "--pub", help='publish a message: "linear: {x: 0.5}"')
    parser.add_argument("-n", "--num", type=int, default=0, help="print so many messages")
    return parser.parse_args(words)


def carry_out(words: list[str]) -> int:
    """List topics, print messages, or publish one. Returns the exit code."""
    told = _arguments(words)
    with gz_node("gz_topic") as node:
        return _publish(node, told) if told.pub is not None else _look(node, told)


def _publish(node: Node, told: argparse.Namespace) -> int:
    """Publish one message."""
    try:
        message = get_message(carrier_of(told.msgtype))()
        fill(told.pub, told.msgtype, message.pose if isinstance(message, PoseStamped) else message)
    except (LookupError, GzTextError) as fault:
        why = fault.args[0]
        print(f"Unable to create message of type[{told.msgtype}] with data[{told.pub}].\n{why}", file=sys.stderr)
        return 255
    node.create_publisher(type(message), "/" + told.name.strip("/"), 10).publish(message)
    return 0


def _look(node: Node, told: argparse.Namespace) -> int:
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
    return _echo(node, name, topics[name][0], told.num)


def _echo(node: Node, name: str, kind: str, most: int) -> int:
    seen: list[int] = []

    def show(msg: Any) -> None:
        print(message_to_yaml(msg))
        seen.append(1)

    node.create_subscription(get_message(kind), name, show, 10)
    executor = rclpy.executors.SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    while node.context.ok() and not 0 < most <= len(seen):
        executor.spin_once()
    return 0
