"""What `ros2 doctor --report` says of the graph: its topics, and who can hear whom."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from . import ask

Lines = list[tuple[str, str]]
_EVERYWHERE = ("/parameter_events", "/rosout")


def report() -> Iterator[tuple[str, Lines]]:
    """Sections of (name, value) lines."""
    topics = [(name, types) for name, types in ask.topics() if name not in _EVERYWHERE]
    with ask.command_node() as node:
        pairs = [line for name, types in topics for line in _pairs(node, name, types)]
        counts = [line for name, _ in topics for line in _counts(node, name)]
    yield "QOS COMPATIBILITY LIST", pairs or [("compatibility status", "No publisher/subscriber pairs found")]
    yield "TOPIC LIST", counts or [("topic", "none"), ("publisher count", "0"), ("subscriber count", "0")]


def _counts(node: Any, topic: str) -> Lines:
    return [
        ("topic", topic),
        ("publisher count", str(node.count_publishers(topic))),
        ("subscriber count", str(node.count_subscribers(topic))),
    ]


def _pairs(node: Any, topic: str, types: list[str]) -> Iterator[tuple[str, str]]:
    from rclpy.qos import QoSCompatibility, qos_check_compatible

    for publisher in node.get_publishers_info_by_topic(topic):
        for subscription in node.get_subscriptions_info_by_topic(topic):
            fit, reason = qos_check_compatible(publisher.qos_profile, subscription.qos_profile)
            yield "topic [type]", f"{topic} [{', '.join(types)}]"
            yield "publisher node", publisher.node_name
            yield "subscriber node", subscription.node_name
            yield "compatibility status", "OK" if fit == QoSCompatibility.OK else f"{fit.name}: {reason}".strip()
