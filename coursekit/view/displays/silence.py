"""Explanations for a display's topic without messages."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.nodes.rviz.kinds import KINDS

if TYPE_CHECKING:
    from rclpy.node import Node

    from .display import Display


def why_nothing(node: Node, display: Display) -> str:
    """Name the cause: another type, incompatible QoS, a missed earlier message, a silent publisher, or no publisher."""
    topic, wanted = display.config.topic, KINDS[display.kind].type
    resolved = dict(node.get_topic_names_and_types())
    if node.count_publishers(topic):
        types = [type_name for type_name in resolved.get(topic, []) if type_name != wanted]
        if types:
            return f"{topic} has the type {types[0]}, not {wanted}"
        return _unfit(node, display) or _missed(node, display) or f"{topic} has a publisher that has not published yet"
    others = sorted(name for name, kinds in resolved.items() if wanted in kinds and node.count_publishers(name))
    return f"Nobody publishes {topic}." + (f" There is: {', '.join(others[:4])}" if others else "")


def _unfit(node: Node, display: Display) -> str:
    """Name the publisher whose QoS is incompatible with the display's, in rclpy's words."""
    from rclpy.qos import QoSCompatibility, qos_check_compatible

    for info in node.get_publishers_info_by_topic(display.config.topic):
        verdict, reason = qos_check_compatible(info.qos_profile, display.quality)
        if verdict == QoSCompatibility.ERROR:
            return f"The QoS of {info.node_name} on {display.config.topic} does not fit: {reason.strip(' ;')}"
    return ""


def _missed(node: Node, display: Display) -> str:
    """Name a publisher that keeps messages for late joiners, which the display does not request."""
    from rclpy.qos import DurabilityPolicy

    topic, lasting = display.config.topic, DurabilityPolicy.TRANSIENT_LOCAL
    keepers = [info for info in node.get_publishers_info_by_topic(topic) if info.qos_profile.durability == lasting]
    if not keepers or display.quality.durability == lasting:
        return ""
    return (
        f"{keepers[0].node_name} keeps its last message on {topic}. To get what was published before, set the Durability "
        "Policy to Transient Local"
    )


__all__ = ["why_nothing"]
