"""The graph in `ros2 doctor --report`: its topics, and the compatibility of their endpoints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from . import api, checks

if TYPE_CHECKING:
    from rclpy.node import Node

Lines = checks.Lines
_EVERYWHERE = ("/parameter_events", "/rosout")


def report() -> Iterator[tuple[str, Lines]]:
    """Yield sections of (name, value) lines."""
    yield "QOS COMPATIBILITY LIST", pairs() or [("compatibility status", "No publisher/subscriber pairs found")]
    yield "TOPIC LIST", counts()


def pairs() -> Lines:
    """Return each publisher with each subscription of its topic, and whether they are compatible."""
    with api.command_node() as node:
        return [line for name, types in _topics() for line in _pairs(node, name, types)]


def counts() -> Lines:
    """Return the number of publishers and subscriptions of each topic."""
    with api.command_node() as node:
        return [line for name, _ in _topics() for line in _counts(node, name)] or [
            ("topic", "none"),
            ("publisher count", 0),
            ("subscriber count", 0),
        ]


def compatibility() -> checks.Check:
    """Check whether every publisher is compatible with the subscriptions of its topic."""
    faults: list[str] = []
    with api.command_node() as node:
        for topic, types in api.topics():
            told = [value for name, value in _pairs(node, topic, types) if name == "compatibility status"]
            faults += [f"on topic '{topic}': {line.removeprefix('ERROR: ')}" for line in told if line.startswith("ERROR")]
    if not faults:
        return checks.Check("middleware", "publishers and subscriptions fit")
    fault = "\n".join(f"QoS compatibility error found {report}" for report in faults)
    return checks.Check("middleware", "some do not fit", fault, "Give both sides a QoS that fits; see: ros2 topic info -v")


def both_ends() -> checks.Check:
    """Check whether every topic has as many publishers as subscriptions; a difference is only a warning."""
    told: list[str] = []
    with api.command_node() as node:
        for topic, _ in _topics():
            surplus = node.count_publishers(topic) - node.count_subscribers(topic)
            if surplus:
                have, lack = ("Publisher", "subscriber") if surplus > 0 else ("Subscriber", "publisher")
                told.append(f"{have} without {lack} detected on {topic}.")
    cure = "Fine if the other side comes later; a misspelled topic looks like this, too: ros2 topic list -v"
    return checks.Check("topic", "who publishes and who subscribes", "\n".join(told), cure, only_warning=True)


def _topics() -> list[tuple[str, list[str]]]:
    return [(name, types) for name, types in api.topics() if name not in _EVERYWHERE]


def _counts(node: Node, topic: str) -> Lines:
    return [
        ("topic", topic),
        ("publisher count", node.count_publishers(topic)),
        ("subscriber count", node.count_subscribers(topic)),
    ]


def _pairs(node: Node, topic: str, types: list[str]) -> Iterator[tuple[str, str]]:
    from rclpy.qos import QoSCompatibility, qos_check_compatible

    for publisher in node.get_publishers_info_by_topic(topic):
        for subscription in node.get_subscriptions_info_by_topic(topic):
            fit, reason = qos_check_compatible(publisher.qos_profile, subscription.qos_profile)
            yield "topic [type]", f"{topic} [{', '.join(types)}]"
            yield "publisher node", publisher.node_name
            yield "subscriber node", subscription.node_name
            yield "compatibility status", "OK" if fit == QoSCompatibility.OK else reason
