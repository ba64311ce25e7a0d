"""Managed nodes: their states, and the transitions between them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import rclpy
from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState
from ros2node.api import NodeName, NodeNameCompleter
from ros2node.api import get_node_names as get_all_node_names
from ros2service.api import get_service_names_and_types

if TYPE_CHECKING:
    from rclpy.node import Node

_SERVICE = "get_state"


def get_node_names(*, node: Node, include_hidden_nodes: bool = False) -> list[NodeName]:
    """The nodes with a service for their state."""
    services = get_service_names_and_types(node=node, include_hidden_services=include_hidden_nodes)
    serving = {name for name, types in services if "lifecycle_msgs/srv/GetState" in types}
    nodes = get_all_node_names(node=node, include_hidden_nodes=include_hidden_nodes)
    return [other for other in nodes if f"{other.full_name}/{_SERVICE}" in serving]


def _call_all(node: Node, kind: Any, service: str, requests: dict[str, Any]) -> dict[str, Any]:
    """The response or the exception of each request, by node; None for nodes that are gone."""
    target = getattr(node, "node", node)
    clients = {name: target.create_client(kind, f"{name}/{service}") for name in requests}
    futures = {
        name: client.call_async(requests[name]) if client.wait_for_service(timeout_sec=0.0) else None
        for name, client in clients.items()
    }
    answers: dict[str, Any] = {}
    for name, future in futures.items():
        if future is not None:
            rclpy.spin_until_future_complete(target, future)
        answers[name] = None if future is None else future.exception() or future.result()
        target.destroy_client(clients[name])
    return answers


def call_get_states(*, node: Node, node_names: list[str]) -> dict[str, Any]:
    """The State of each node, or the exception of the call."""
    answers = _call_all(node, GetState, _SERVICE, {name: GetState.Request() for name in node_names})
    return {name: getattr(answer, "current_state", answer) for name, answer in answers.items()}


def _call_transitions(node: Node, names: list[str], service: str) -> dict[str, Any]:
    requests = {name: GetAvailableTransitions.Request() for name in names}
    answers = _call_all(node, GetAvailableTransitions, service, requests)
    return {name: getattr(answer, "available_transitions", answer) for name, answer in answers.items()}


def call_get_available_transitions(*, node: Node, states: dict[str, Any]) -> dict[str, Any]:
    """The currently available transitions of each node, or an exception."""
    return _call_transitions(node, list(states), "get_available_transitions")


def call_get_transition_graph(*, node: Node, states: dict[str, Any]) -> dict[str, Any]:
    """All transitions of each node, or an exception."""
    return _call_transitions(node, list(states), "get_transition_graph")


def call_change_states(*, node: Node, transitions: dict[str, Any]) -> dict[str, Any]:
    """Request transitions of nodes. Return for each node whether it succeeded, or an exception."""
    requests = {name: ChangeState.Request(transition=transition) for name, transition in transitions.items()}
    answers = _call_all(node, ChangeState, "change_state", requests)
    return {name: getattr(answer, "success", answer) for name, answer in answers.items()}


class LifecycleNodeNameCompleter(NodeNameCompleter):
    """Full names of managed nodes, for argcomplete."""

    @staticmethod
    def _names(node: Node, hidden: bool) -> list[NodeName]:
        return get_node_names(node=node, include_hidden_nodes=hidden)
