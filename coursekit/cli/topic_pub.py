"""`ros2 topic pub`."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile
from rosidl_runtime_py import set_message_fields
from rosidl_runtime_py.utilities import get_message

from coursekit.processes.session import current
from coursekit.rcl.names import is_hidden
from coursekit.suggestions import did_you_mean

from . import api, topic_qos

if TYPE_CHECKING:
    from argparse import Namespace

    from rclpy.node import Node

_LOOK_SECONDS = 0.1
_ROUNDS = 5
"""The number of seconds after which a waiting command reports the topic it waits for."""
NOTHING_SENT = 1
"""Exit code of a command that was ended while it waited for subscriptions."""


def register(verbs: Any) -> None:
    """Add the verb."""
    parser = verbs.add_parser("pub", help="Publish a message to a topic")
    parser.add_argument("topic_name", help="Name of the ROS topic to publish to (e.g. '/chatter')").completer = (
        api.complete_topics
    )
    parser.add_argument("message_type", help="Type of the ROS message (e.g. 'std_msgs/String')").completer = (
        api.complete_interfaces("msg")
    )
    values = parser.add_argument("values", nargs="?", default="{}", help="Values to fill the message with in YAML format")
    values.completer = api.complete_values("message_type")  # type: ignore[attr-defined]
    parser.add_argument("-r", "--rate", type=positive, default=1.0, help="Publishing rate in Hz (default: 1)")
    parser.add_argument("-p", "--print", type=int, default=1, help="Only print every N-th published message")
    many = parser.add_mutually_exclusive_group()
    many.add_argument("-1", "--once", action="store_true", help="Publish one message and exit")
    many.add_argument("-t", "--times", type=int, default=0, help="Publish this number of times and then exit")
    parser.add_argument("-w", "--wait-matching-subscriptions", type=int, default=None, help="Wait for so many")
    parser.add_argument("--keep-alive", type=float, default=0.1, help="Keep the node alive for N seconds after the last")
    parser.add_argument("-n", "--node-name", help="Name of the created publishing node")
    topic_qos.add_arguments(parser, "reliable, transient local, depth 1")
    parser.set_defaults(main=main)


def positive(text: str) -> float:
    """Parse a number above zero."""
    try:
        number = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError("Expects a floating point number") from None
    if not number > 0:
        raise argparse.ArgumentTypeError("The value must be greater than zero")
    return number


def main(args: Namespace) -> int:
    """Publish messages."""
    try:
        kind = get_message(args.message_type)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise api.Unhappy("The passed message type is invalid") from None
    values = api.yaml_values(args.values)
    options = {"name": args.node_name} if args.node_name else {}
    with api.command_node(**options, **api.on_clock(args)) as node:
        return _publish(node, kind, values, args)


def _publish(node: Node, kind: Any, values: dict[str, Any], args: Namespace) -> int:
    profile = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = node.create_publisher(kind, args.topic_name, topic_qos.chosen(args, profile))
    times = 1 if args.once else args.times
    if not _wait_for_listeners(publisher, args, times):
        return NOTHING_SENT
    msg = kind()
    stamps = _fill(msg, values)
    print("publisher: beginning loop")
    count = 0
    while rclpy.ok() and (not times or count < times):
        count += 1
        for set_stamp in stamps:
            set_stamp(node.get_clock().now().to_msg())
        if args.print and count % args.print == 0:
            print(f"publishing #{count}: {msg!r}\n")
        publisher.publish(msg)
        if not times or count < times:
            _pause(node, 1.0 / args.rate, args.use_sim_time)
    current().clock.sleep(args.keep_alive)
    return 0


def _pause(node: Node, seconds: float, simulated: bool) -> None:
    """Wait, on the node's clock if it follows /clock."""
    if not simulated:
        current().clock.sleep(seconds)
        return
    end = node.get_clock().now() + Duration(seconds=seconds)
    while rclpy.ok() and node.get_clock().now() < end:
        rclpy.spin_once(node, timeout_sec=_LOOK_SECONDS)


def _wait_for_listeners(publisher: Any, args: Namespace, times: int) -> bool:
    """Wait for subscriptions; False when the command was ended before."""
    wanted = args.wait_matching_subscriptions
    wanted = (1 if times else 0) if wanted is None else wanted
    rounds = 0
    while publisher.get_subscription_count() < wanted:
        print(f"Waiting for at least {wanted} matching subscription(s)...")
        rounds += 1
        if rounds == _ROUNDS:
            _say_who_listens(publisher.topic_name)
        for _ in range(10):
            current().clock.sleep(0.1)
            if not rclpy.ok():
                return False
            if publisher.get_subscription_count() >= wanted:
                break
    return True


def _say_who_listens(topic: str) -> None:
    """Report that no node subscribes to a topic, and suggest the one that was probably meant."""
    listening = {
        subscription.name
        for node in api.graph().nodes
        for subscription in node.subscriptions
        if not is_hidden(subscription.name)
    }
    meant = did_you_mean(topic, sorted(listening - {topic}))
    if topic not in listening and meant:
        api.say_error(f"Still waiting: no node subscribes to {topic}. {meant} {api.ENDS_WAITING}")


def _fill(msg: Any, values: dict[str, Any]) -> list[Any]:
    """Set the fields. Returns setters for the stamps that should be the time of publishing."""
    try:
        return set_message_fields(msg, values, expand_header_auto=True, expand_time_now=True)
    except Exception as error:
        raise api.Unhappy(f"Failed to populate field: {error}") from None
