"""`ros2 topic echo`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.qos import qos_profile_sensor_data
from rclpy.task import Future
from rosidl_runtime_py import message_to_csv, message_to_yaml
from rosidl_runtime_py.utilities import get_message

from . import api, topic_qos

if TYPE_CHECKING:
    from argparse import Namespace

    from rclpy.node import Node

DEFAULT_TRUNCATE_LENGTH = 128


def register(verbs: Any) -> None:
    """Add the verb."""
    parser = verbs.add_parser("echo", help="Output messages from a topic")
    parser.add_argument("topic_name", help="Name of the ROS topic to listen to (e.g. '/chatter')").completer = (
        api.complete_topics
    )
    parser.add_argument("message_type", nargs="?", help="Type of the ROS message (e.g. 'std_msgs/msg/String')")
    topic_qos.add_arguments(parser, "sensor_data")
    parser.add_argument("--csv", action="store_true", help="Output all recursive fields separated by commas")
    parser.add_argument("--field", default=None, help="Echo a selected field of a message, e.g. pose.position.x")
    parser.add_argument("-f", "--full-length", action="store_true", help="Output all elements of arrays and strings")
    parser.add_argument(
        "-l", "--truncate-length", type=_not_negative, default=DEFAULT_TRUNCATE_LENGTH, help="Where to truncate"
    )
    parser.add_argument("--spin-time", type=float, default=None, help="Spin time in seconds for discovery")
    parser.add_argument("--no-arr", action="store_true", help="Don't print array fields of messages")
    parser.add_argument("--no-str", action="store_true", help="Don't print string fields of messages")
    parser.add_argument("--flow-style", action="store_true", help="Print collections in the block style")
    parser.add_argument("--lost-messages", action="store_true", help="DEPRECATED: Does nothing")
    parser.add_argument("--no-lost-messages", action="store_true", help="Don't report when a message is lost")
    parser.add_argument("--raw", action="store_true", help="Echo the raw binary representation")
    parser.add_argument("--filter", dest="filter_expr", help="Python expression of m; false ones are not shown")
    parser.add_argument("--once", action="store_true", help="Print the first message received and then exit")
    parser.add_argument("--timeout", type=float, default=None, help="Seconds to wait for a message")
    parser.set_defaults(main=main)


def _not_negative(text: str) -> int:
    number = int(text)
    if number < 0:
        raise ValueError(text)
    return number


def main(args: Namespace) -> int:
    """Print messages until Ctrl-C, or only the first one."""
    if args.csv and args.raw:
        return _refuse("Invalid: --csv and --raw cannot be used together")
    if args.field is not None:
        args.field = [part for part in args.field.split(".") if part]
        if not args.field:
            return _refuse("Invalid field value '.'")
    with api.command_node(**api.on_clock(args)) as node:
        kind = _message_type(node, args)
        if kind is None:
            return _refuse("Could not determine the type for the passed topic")
        return _Echo(node, args, kind).run()


def _refuse(text: str) -> int:
    api.say_error(text)
    return 1


def _message_type(node: Node, args: Namespace) -> Any:
    """Return the class of the topic's messages: as given, or as published."""
    if args.message_type:
        try:
            return get_message(args.message_type)
        except (AttributeError, ModuleNotFoundError, ValueError):
            raise api.Unhappy("The passed message type is invalid") from None
    types = dict(node.get_topic_names_and_types()).get(api.full_name(args.topic_name))
    if types is None:
        api.say_error(f"WARNING: topic [{args.topic_name}] does not appear to be published yet")
        return None
    if len(types) > 1:
        raise api.Unhappy(
            f"Cannot echo topic '{args.topic_name}', as it contains more than one type: [{', '.join(types)}]"
        )
    return get_message(types[0])


class _Echo:
    """One run of the command."""

    def __init__(self, node: Node, args: Namespace, kind: Any) -> None:
        self._node = node
        self._args = args
        self._done = Future()
        self._failed = False
        self._limit = None if args.full_length else args.truncate_length
        self._accepts = compile(args.filter_expr, "--filter", "eval") if args.filter_expr else None
        self._qos = self._profile()
        node.create_subscription(kind, args.topic_name, self._show, self._qos, raw=args.raw)

    def _profile(self) -> Any:
        publishers = self._node.get_publishers_info_by_topic(api.full_name(self._args.topic_name))
        if topic_qos.is_chosen(self._args) or not publishers:
            return topic_qos.chosen(self._args, qos_profile_sensor_data)
        profile, remarks = topic_qos.fitting(publishers)
        for remark in remarks:
            print(remark)
        return profile

    def run(self) -> int:
        """Spin; returns 0 unless a field does not exist."""
        rclpy.spin_until_future_complete(self._node, self._done, timeout_sec=self._args.timeout)
        return 1 if self._failed else 0

    def _show(self, msg: Any) -> None:
        if self._done.done() or not self._wanted(msg):
            return
        if self._args.once:
            self._done.set_result(True)
        if self._args.raw:
            print(msg + bytes(-len(msg) % 4), end="\n---\n")  # as on a network, padded to whole words
            return
        for name in self._args.field or ():
            try:
                msg = getattr(msg, name)
            except AttributeError as error:
                api.say_error(f"Invalid field '{'.'.join(self._args.field)}': {error}")
                self._failed = True
                if not self._done.done():
                    self._done.set_result(False)
                return
        print(self._text(msg))

    def _wanted(self, msg: Any) -> bool:
        return self._accepts is None or bool(eval(self._accepts, {"m": msg}))

    def _text(self, msg: Any) -> str:
        args = self._args
        is_message = hasattr(msg, "SLOT_TYPES")
        if args.csv:
            if not is_message:
                return str(msg)
            return message_to_csv(msg, truncate_length=self._limit, no_arr=args.no_arr, no_str=args.no_str)
        if not is_message:
            return f"{msg}\n---"
        body = message_to_yaml(
            msg, truncate_length=self._limit, no_arr=args.no_arr, no_str=args.no_str, flow_style=args.flow_style
        )
        return f"{body}---"
