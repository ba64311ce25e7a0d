"""The actions in the graph. In ROS 2: rclpy.action.graph."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rclpy.node import Node

NamesAndTypes = list[tuple[str, list[str]]]

_TOPIC = "/_action/feedback"
_TYPE_ENDING = "_FeedbackMessage"


def _actions(topics: NamesAndTypes) -> NamesAndTypes:
    """The actions whose feedback topics are among the topics."""
    return [
        (name.removesuffix(_TOPIC), [each.removesuffix(_TYPE_ENDING) for each in types])
        for name, types in topics
        if name.endswith(_TOPIC)
    ]


def get_action_client_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return the actions that a node is a client of."""
    return _actions(node.get_subscriber_names_and_types_by_node(remote_node_name, remote_node_namespace))


def get_action_server_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return the actions that a node serves."""
    return _actions(node.get_publisher_names_and_types_by_node(remote_node_name, remote_node_namespace))


def get_action_names_and_types(node: Node) -> NamesAndTypes:
    """Return all actions."""
    return _actions(node.get_topic_names_and_types())
