"""Topics and their types, and QoS profiles from the words of the command line."""

from __future__ import annotations

from argparse import ArgumentParser, ArgumentTypeError
from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.duration import Duration
from rclpy.exceptions import InvalidTopicNameException
from rclpy.expand_topic_name import expand_topic_name
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
)
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden
from rclpy.validate_full_topic_name import validate_full_topic_name
from ros2cli.node.strategy import NodeStrategy
from rosidl_runtime_py import get_message_interfaces, message_to_yaml
from rosidl_runtime_py.utilities import get_message

from coursekit.processes.session import current

if TYPE_CHECKING:
    from argparse import Namespace

POLL_SECONDS = 0.1
POLICIES = (
    ("history", HistoryPolicy),
    ("reliability", ReliabilityPolicy),
    ("durability", DurabilityPolicy),
    ("liveliness", LivelinessPolicy),
)


def unsigned_int(string: str) -> int:
    """A whole number of 0 or more, for argparse.

    >>> unsigned_int("3")
    3
    """
    return int(_number(string, int, "value must be non-negative integer", 0))


def positive_int(string: str) -> int:
    """A whole number above 0, for argparse."""
    return int(_number(string, int, "value must be a positive integer", 1))


def positive_float(inval: str) -> float:
    """A number above 0, for argparse."""
    try:
        value = float(inval)
    except ValueError:
        raise ArgumentTypeError("Expects a floating point number") from None
    if value <= 0.0:
        raise ArgumentTypeError("Value must be positive")
    return value


def _number(text: str, kind: Any, fault: str, least: int) -> Any:
    try:
        value = kind(text)
    except ValueError:
        raise ArgumentTypeError(fault) from None
    if value < least:
        raise ArgumentTypeError(fault)
    return value


def get_topic_names_and_types(*, node: Any, include_hidden_topics: bool = False) -> list[Any]:
    """(name, types) of the topics."""
    topics = node.get_topic_names_and_types()
    return [(name, types) for name, types in topics if include_hidden_topics or not topic_or_service_is_hidden(name)]


def get_topic_names(*, node: Any, include_hidden_topics: bool = False) -> list[str]:
    """Names of the topics."""
    return [name for name, _ in get_topic_names_and_types(node=node, include_hidden_topics=include_hidden_topics)]


def get_msg_class(node: Any, topic: str, blocking: bool = False, include_hidden_topics: bool = False) -> Any:
    """The class of a topic's messages; None when no node has the topic. With `blocking`, wait until a node has it.

    Raises:
        RuntimeError: for an invalid name, a topic of several types, or a type that is not installed.
    """
    message_class = _class_of(node, topic, include_hidden_topics)
    if message_class is None:
        print(f"WARNING: topic [{topic}] does not appear to be published yet")
    while message_class is None and blocking and rclpy.ok():
        current().clock.sleep(POLL_SECONDS)
        message_class = _class_of(node, topic, include_hidden_topics)
    return message_class


def _class_of(node: Any, topic: str, include_hidden_topics: bool) -> Any:
    try:
        name = expand_topic_name(topic, node.get_name(), node.get_namespace())
        validate_full_topic_name(name)
    except (ValueError, InvalidTopicNameException) as error:
        raise RuntimeError(error) from None
    types = dict(get_topic_names_and_types(node=node, include_hidden_topics=include_hidden_topics)).get(name)
    if not types:
        return None
    if len(types) > 1:
        raise RuntimeError(f"Cannot echo topic '{topic}', as it contains more than one type: [{', '.join(types)}]")
    try:
        return get_message(types[0])
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(f"The message type '{types[0]}' is invalid") from None


def profile_configure_short_keys(
    profile: QoSProfile,
    reliability: str | None = None,
    durability: str | None = None,
    depth: int | None = None,
    history: str | None = None,
    liveliness: str | None = None,
    liveliness_lease_duration_s: float | None = None,
) -> None:
    """Set the policies of a profile by their short keys; None leaves a policy unchanged."""
    words = {"history": history, "durability": durability, "reliability": reliability, "liveliness": liveliness}
    for name, policy in POLICIES:
        word = words[name]
        if word:
            setattr(profile, name, policy.get_from_short_key(word))
    if liveliness_lease_duration_s and liveliness_lease_duration_s >= 0:
        profile.liveliness_lease_duration = Duration(seconds=liveliness_lease_duration_s)
    if depth and depth >= 0:
        profile.depth = depth
    elif profile.durability == DurabilityPolicy.TRANSIENT_LOCAL and not profile.depth:
        profile.depth = 1


def qos_profile_from_short_keys(preset_profile: str, *args: Any, **kwargs: Any) -> QoSProfile:
    """The preset of that name, changed by the arguments of profile_configure_short_keys.

    >>> qos_profile_from_short_keys("sensor_data", reliability="reliable").reliability.name
    'RELIABLE'
    """
    preset = QoSPresetProfiles.get_from_short_key(preset_profile)
    profile = QoSProfile(**{name.lstrip("_"): getattr(preset, name.lstrip("_")) for name in preset.__slots__})
    profile_configure_short_keys(profile, *args, **kwargs)
    return profile


def add_qos_arguments(
    parser: ArgumentParser, entity_type: str, default_profile_str: str = "default", extra_message: str = ""
) -> None:
    """Add `--qos-profile`, `--qos-depth`, and one option for each policy."""
    base = QoSPresetProfiles.get_from_short_key(default_profile_str)
    parser.add_argument(
        "--qos-profile",
        choices=QoSPresetProfiles.short_keys(),
        default=default_profile_str,
        help=f"Preset of quality of service to {entity_type} with (default: {default_profile_str})",
    )
    parser.add_argument("--qos-depth", metavar="N", type=int, help=f"Queue size (default: {base.depth})")
    for name, policy in POLICIES:
        default = f"{getattr(base, name).short_key} {extra_message}".strip()
        parser.add_argument(f"--qos-{name}", choices=policy.short_keys(), help=f"The {name} (default: {default})")
    parser.add_argument("--qos-liveliness-lease-duration-seconds", type=float, help="The liveliness lease duration [s]")


class TopicNameCompleter:
    """Names of topics, for argcomplete."""

    def __init__(self, *, include_hidden_topics_key: str | None = None) -> None:
        self.include_hidden_topics_key = include_hidden_topics_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The names of the existing topics."""
        key = self.include_hidden_topics_key
        hidden = bool(key and getattr(parsed_args, key))
        with NodeStrategy(parsed_args) as node:
            return get_topic_names(node=node, include_hidden_topics=hidden)


def message_type_completer(**_: Any) -> list[str]:
    """All message types, for argcomplete."""
    return [f"{package}/{name}" for package, names in sorted(get_message_interfaces().items()) for name in sorted(names)]


class TopicTypeCompleter:
    """The type of the topic on the command line, else all types, for argcomplete."""

    def __init__(self, *, topic_name_key: str | None = None) -> None:
        self.topic_name_key = topic_name_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The types."""
        if self.topic_name_key is not None:
            with NodeStrategy(parsed_args) as node:
                known = dict(get_topic_names_and_types(node=node, include_hidden_topics=True))
            types = known.get(getattr(parsed_args, self.topic_name_key))
            if types:
                return list(types)
        return message_type_completer()


class TopicMessagePrototypeCompleter:
    """The default values of the type on the command line, for argcomplete."""

    def __init__(self, *, topic_type_key: str | None = None) -> None:
        self.topic_type_key = topic_type_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The values as YAML."""
        return [message_to_yaml(get_message(getattr(parsed_args, str(self.topic_type_key)))())]
