"""`ros2 run topic_tools transform` and `relay_field`: a message is computed from each message of a topic."""

from __future__ import annotations

import argparse
import importlib
import os
import sys
from collections.abc import Callable
from typing import Any

import rclpy
import yaml
from rclpy.node import Node
from rclpy.qos import QoSPresetProfiles, QoSProfile
from rclpy.utilities import remove_ros_args
from ros2topic.api import POLICIES, get_msg_class, qos_profile_from_short_keys
from rosidl_runtime_py import set_message_fields
from rosidl_runtime_py.utilities import get_message

from coursekit.nodes.topic_tools.tool import source_of

POLICY_NAMES = ("history", "reliability", "durability")


class Computed(Node):
    """Publishes what `compute` returns for each message. RuntimeError if the topic has no publisher."""

    def __init__(self, name: str, args: argparse.Namespace) -> None:
        super().__init__(f"{name}_{os.getpid()}")
        topic = self.resolve_topic_name(args.input)
        kind = get_msg_class(self, topic, blocking=args.wait_for_start, include_hidden_topics=True)
        if kind is None:
            raise RuntimeError(f"ERROR: Wrong input topic: {topic}")
        self.kind = get_message(args.output_type)
        qos = self._chosen(args) or self._fitting(topic)
        self._out = self.create_publisher(self.kind, args.output_topic, qos)
        self.create_subscription(kind, topic, lambda msg: self._out.publish(self.compute(msg)), qos)

    def compute(self, m: Any) -> Any:
        """Return the message to publish for a message."""
        raise NotImplementedError

    def _chosen(self, args: argparse.Namespace) -> QoSProfile | None:
        own = {name: getattr(args, f"qos_{name}") for name in ("depth", *POLICY_NAMES)}
        if args.qos_profile is None and all(value is None for value in own.values()):
            return None
        return qos_profile_from_short_keys(args.qos_profile or "sensor_data", **own)

    def _fitting(self, topic: str) -> QoSProfile:
        source = source_of(self, topic)
        return source[1] if source else QoSPresetProfiles.get_from_short_key("sensor_data")


class Transform(Computed):
    """The value of a Python expression, in which `m` is the message or one of its fields."""

    def __init__(self, args: argparse.Namespace) -> None:
        self._field = [part for part in (args.field or "").split(".") if part]
        if args.field is not None and not self._field:
            raise RuntimeError(f"Invalid field value '{args.field}'")
        self._function = eval(f"lambda m: {args.expression}", _imported(args.modules))
        super().__init__("transform", args)

    def compute(self, m: Any) -> Any:
        """Return the expression's value."""
        for part in self._field:
            try:
                m = getattr(m, part)
            except AttributeError as fault:
                raise RuntimeError(f"Invalid field '{'.'.join(self._field)}': {fault}") from fault
        return self._function(m)


class RelayField(Computed):
    """A message in YAML, in which texts that are Python expressions of the message `m` are replaced by their values."""

    def __init__(self, args: argparse.Namespace) -> None:
        self._values = yaml.safe_load(args.expression)
        super().__init__("relay_field", args)

    def compute(self, m: Any) -> Any:
        """Return the message; its `now` and `auto` are the present time."""
        try:
            values = _evaluated(self._values, m)
        except AttributeError as fault:
            raise RuntimeError(f"Invalid field: {fault}") from fault
        message, now = self.kind(), self.get_clock().now().to_msg()
        for stamp in set_message_fields(message, values, expand_header_auto=True, expand_time_now=True):
            stamp(now)
        return message


def _imported(names: list[str]) -> dict[str, Any]:
    modules = {}
    for name in names:
        try:
            importlib.import_module(name)
            top = name.partition(".")[0]
            modules[top] = importlib.import_module(top)
        except ImportError:
            print(f"Failed to import module: {name}", file=sys.stderr)
    return modules


def _evaluated(value: Any, m: Any) -> Any:
    """Return a value of YAML with its expressions evaluated; a text that is none stays as it is.

    >>> _evaluated({"frame_id": "map", "x": "m + 1", "y": {"z": 2}}, 5)
    {'frame_id': 'map', 'x': 6, 'y': {'z': 2}}
    """
    if isinstance(value, dict):
        return {name: _evaluated(inner, m) for name, inner in value.items()}
    if isinstance(value, str) and (value == "m" or not value.isidentifier()):  # `map` is a frame, not a function of Python
        try:
            return eval(value, {"m": m})
        except (NameError, SyntaxError):
            pass
    return value


def _parser(what: str) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=what)
    parser.add_argument("input", help="Input topic")
    parser.add_argument("output_topic", help="Output topic")
    parser.add_argument("output_type", help="Type of the output topic, such as std_msgs/Float64")
    parser.add_argument("expression", help="Python expression of the message 'm'")
    parser.add_argument("--wait-for-start", action="store_true", help="Wait for the input topic")
    parser.add_argument("--qos-profile", choices=QoSPresetProfiles.short_keys(), help="Preset (default: sensor_data)")
    parser.add_argument("--qos-depth", metavar="N", type=int, help="Queue size")
    for name, policy in POLICIES:
        if name in POLICY_NAMES:
            parser.add_argument(f"--qos-{name}", choices=policy.short_keys(), help="Default: as the publishers offer")
    return parser


def _run(
    make: Callable[[argparse.Namespace], Node], name: str, parser: argparse.ArgumentParser, args: list[str] | None
) -> int:
    given = parser.parse_args(remove_ros_args(args=sys.argv if args is None else args)[1:])
    rclpy.init(args=args)
    try:
        node = make(given)
        try:
            rclpy.spin(node)
        except KeyboardInterrupt:
            print(f"{name} stopped cleanly")
        except BaseException:
            print(f"exception in {name}:", file=sys.stderr)
            raise
    finally:
        rclpy.try_shutdown()
    return 0


def transform(args: list[str] | None = None) -> int:
    """Run transform INTOPIC OUTTOPIC TYPE EXPRESSION [--import MODULE ...] [--field FIELD]."""
    parser = _parser("Publish the value of a Python expression of each message, or of one of its fields.")
    parser.add_argument("-i", "--import", dest="modules", nargs="+", default=["numpy"], help="Modules to import")
    parser.add_argument("--field", help="Field of the message that 'm' is, such as orientation.x")
    return _run(Transform, "transform", parser, args)


def relay_field(args: list[str] | None = None) -> int:
    """Run relay_field INTOPIC OUTTOPIC TYPE YAML."""
    return _run(RelayField, "relay_field", _parser("Publish a message in YAML with values of each message."), args)
