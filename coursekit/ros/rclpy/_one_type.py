"""One type per name: all endpoints of a topic or service in a context share it, as with Fast DDS, Humble's middleware."""

from __future__ import annotations

from typing import Any

from coursekit.core.graph_node import GraphNode
from rclpy._rclpy_names import RCLError

TOPIC_ENDS = ("publisher", "subscription")


def check_type(node: GraphNode, kind: str, name: str, msg_type: type[Any]) -> None:
    """Raise RCLError if another endpoint of a topic or service in the node's context has another type.

    `kind` is "publisher", "subscription", "service" or "client".
    """
    is_topic = kind in TOPIC_ENDS
    graph, wanted = node.graph, msg_type._TYPE_NAME
    ends = (graph.publishers, graph.subscriptions) if is_topic else (graph.servers, graph.clients)
    there = [end for known in ends for end in known.get(name, ())]  # type: ignore[attr-defined]
    for end in there:
        if node.participant is not None and end.node.participant is node.participant and end.type_name != wanted:
            said = _of_topic if is_topic else _of_service
            raise RCLError(
                f"{said(kind, name, wanted)}; in this process {end.node.full_name} has it with {end.type_name}: "
                "destroy that node first (in a notebook, reset() destroys all)"
            )


def check_action_type(node: Any, kind: str, name: str, goal_type: Any) -> None:
    """Raise ValueError if an action's goal service has another type in the context of a node's handle.

    `kind` is "client" or "server".
    """
    try:
        node.name_for("client" if kind == "client" else "service", name, goal_type)
    except RCLError as error:
        raise ValueError(f"Failed to create action {kind}: {str(error).partition(': ')[2]}") from None


def _of_topic(kind: str, name: str, wanted: str) -> str:
    what = f"existing topic name rt{name} with incompatible type {_in_dds(wanted)}"
    return f"Failed to create {kind}: create_{kind}() called for {what}"


def _of_service(kind: str, name: str, wanted: str) -> str:
    what = f"existing request topic name rq{name}Request with incompatible type {_in_dds(wanted + '_Request')}"
    return f"failed to create {kind}: create_{kind}() called for {what}"


def _in_dds(type_name: str) -> str:
    package, kind, name = type_name.split("/")
    return f"{package}::{kind}::dds_::{name}_"
