"""Nodes with their publishers, subscriptions, services and clients."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, NamedTuple

from rclpy.action.graph import get_action_client_names_and_types_by_node, get_action_server_names_and_types_by_node
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden
from ros2cli.node.strategy import NodeStrategy

if TYPE_CHECKING:
    from argparse import Namespace

HIDDEN_NODE_PREFIX = "_"
INFO_NONUNIQUE_WARNING_TEMPLATE = (
    'There are {num_nodes} nodes in the graph with the exact name "{node_name}". '
    "You are seeing information about only one of them."
)


class NodeName(NamedTuple):
    """A node's name, its namespace, and its full name."""

    name: str
    namespace: str
    full_name: str


class TopicInfo(NamedTuple):
    """A topic, service or action and its types."""

    name: str
    types: list[str]


def get_absolute_node_name(node_name: str) -> str | None:
    """A name with its optional leading slash added; None for an empty name.

    >>> get_absolute_node_name("talker")
    '/talker'
    """
    if not node_name:
        return None
    return node_name if node_name.startswith("/") else f"/{node_name}"


def parse_node_name(node_name: str) -> NodeName:
    """The parts of a full name.

    >>> parse_node_name("robot1/camera")
    NodeName(name='camera', namespace='/robot1', full_name='/robot1/camera')
    """
    full_name = node_name if node_name.startswith("/") else f"/{node_name}"
    namespace, _, name = full_name.rpartition("/")
    return NodeName(name, namespace or "/", full_name)


def has_duplicates(values: Iterable[Any]) -> bool:
    """Whether a value occurs more than once."""
    return any(count > 1 for count in Counter(values).values())


def _is_hidden_name(name: str) -> bool:
    return any(part.startswith(HIDDEN_NODE_PREFIX) for part in name.split("/"))


def get_node_names(*, node: Any, include_hidden_nodes: bool = False) -> list[NodeName]:
    """The nodes of the graph."""
    names = [
        NodeName(name, namespace, f"{namespace.rstrip('/')}/{name}")
        for name, namespace, *_ in node.get_node_names_and_namespaces()
    ]
    return [entry for entry in names if include_hidden_nodes or not _is_hidden_name(entry.full_name)]


def get_topics(remote_node_name: str, func: Any, *, include_hidden_topics: bool = False) -> list[TopicInfo]:
    """The result of `func(name, namespace)` for a node, as TopicInfo."""
    remote = parse_node_name(remote_node_name)
    topics = [TopicInfo(name, types) for name, types in func(remote.name, remote.namespace)]
    return [entry for entry in topics if include_hidden_topics or not topic_or_service_is_hidden(entry.name)]


def get_subscriber_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Topics that a node subscribes to."""
    ask = node.get_subscriber_names_and_types_by_node
    return get_topics(remote_node_name, ask, include_hidden_topics=include_hidden)


def get_publisher_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Topics that a node publishes."""
    return get_topics(remote_node_name, node.get_publisher_names_and_types_by_node, include_hidden_topics=include_hidden)


def get_service_client_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Services that a node calls."""
    return get_topics(remote_node_name, node.get_client_names_and_types_by_node, include_hidden_topics=include_hidden)


def get_service_server_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Services that a node serves."""
    return get_topics(remote_node_name, node.get_service_names_and_types_by_node, include_hidden_topics=include_hidden)


def get_action_server_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Actions that a node serves."""

    def ask(name: str, namespace: str) -> Any:
        return get_action_server_names_and_types_by_node(node, name, namespace)

    return get_topics(remote_node_name, ask, include_hidden_topics=include_hidden)


def get_action_client_info(*, node: Any, remote_node_name: str, include_hidden: bool = False) -> list[TopicInfo]:
    """Actions that a node is a client of."""

    def ask(name: str, namespace: str) -> Any:
        return get_action_client_names_and_types_by_node(node, name, namespace)

    return get_topics(remote_node_name, ask, include_hidden_topics=include_hidden)


class NodeNameCompleter:
    """Full names of nodes, for argcomplete."""

    def __init__(self, *, include_hidden_nodes_key: str | None = None) -> None:
        self.include_hidden_nodes_key = include_hidden_nodes_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The names of the existing nodes."""
        key = self.include_hidden_nodes_key
        hidden = bool(key and getattr(parsed_args, key))
        with NodeStrategy(parsed_args) as node:
            return [name.full_name for name in self._names(node, hidden)]

    @staticmethod
    def _names(node: Any, hidden: bool) -> list[NodeName]:
        return get_node_names(node=node, include_hidden_nodes=hidden)
