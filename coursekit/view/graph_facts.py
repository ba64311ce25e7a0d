"""A snapshot of a graph: nodes, publishers, subscriptions, servers and clients, sorted and immutable."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from coursekit.core.qos import Qos
from coursekit.rcl.names import is_hidden

DEBUG_TOPICS = ("/parameter_events", "/rosout")
DEBUG_NODES = "/rqt_gui_py_node_"
"""The prefix of the names of rqt's own nodes."""
PARAMETER_SERVICES = (
    "describe_parameters",
    "get_parameter_types",
    "get_parameters",
    "list_parameters",
    "set_parameters",
    "set_parameters_atomically",
)
_GOAL_SERVICE = "/_action/send_goal"
_GOAL_TYPE = "_SendGoal"


@dataclass(frozen=True, order=True)
class End:
    """One end of a topic, service or action; `node` is the full name of its node."""

    name: str
    node: str
    type: str
    qos: Qos = field(default=Qos(), compare=False)


@dataclass(frozen=True)
class Facts:
    """The snapshot. `nodes` are unique full names; `duplicates` are names shared by several nodes, with their counts."""

    nodes: tuple[str, ...] = ()
    duplicates: tuple[tuple[str, int], ...] = ()
    namespaces: tuple[str, ...] = ()
    publishers: tuple[End, ...] = ()
    subscriptions: tuple[End, ...] = ()
    servers: tuple[End, ...] = ()
    clients: tuple[End, ...] = ()
    action_servers: tuple[End, ...] = ()
    action_clients: tuple[End, ...] = ()
    remote: tuple[str, ...] = ()
    """Names of nodes that run on other computers or in other notebooks."""
    gone: tuple[tuple[str, str], ...] = ()
    """(topic, node) pairs for topics whose last publisher has left while subscriptions remain."""

    @property
    def topics(self) -> list[str]:
        """The names of the topics, sorted."""
        return names_of(self.publishers, self.subscriptions)

    @property
    def services(self) -> list[str]:
        """The names of the services, sorted."""
        return names_of(self.servers, self.clients)

    @property
    def actions(self) -> list[str]:
        """The names of the actions, sorted."""
        return names_of(self.action_servers, self.action_clients)


def names_of(*ends: Iterable[End]) -> list[str]:
    """Return the unique names of these ends, sorted.

    >>> names_of([End("/scan", "/lidar", "sensor_msgs/msg/LaserScan")], [End("/odom", "/base", "nav_msgs/msg/Odometry")])
    ['/odom', '/scan']
    """
    return sorted({end.name for group in ends for end in group})


def types_of(name: str, *ends: Iterable[End]) -> list[str]:
    """Return the types of the ends of that name, sorted.

    >>> types_of("/scan", [End("/scan", "/lidar", "sensor_msgs/msg/LaserScan")])
    ['sensor_msgs/msg/LaserScan']
    """
    return sorted({end.type for group in ends for end in group if end.name == name})


def nodes_at(name: str, ends: Iterable[End]) -> list[str]:
    """Return the nodes that have an end of that name, unique and sorted.

    >>> nodes_at("/tf", [End("/tf", "/odometry", "tf2_msgs/msg/TFMessage"), End("/tf", "/amcl", "tf2_msgs/msg/TFMessage")])
    ['/amcl', '/odometry']
    """
    return sorted({end.node for end in ends if end.name == name})


def take(graph: Any, *, hidden: bool = False, debug: bool = False) -> Facts:
    """Read a `coursekit.core.graph.Graph`.

    `hidden` includes names with a part that begins with '_' (nodes of commands and panels, topics of actions);
    `debug` includes /rosout, /parameter_events, rqt's own nodes and the parameter services of all nodes.
    """
    nodes = [node for node in list(graph.nodes) if hidden or not is_hidden(node.full_name)]
    nodes = [node for node in nodes if debug or not node.full_name.startswith(DEBUG_NODES)]
    counts = Counter(node.full_name for node in nodes)

    def ends(kind: str, of_services: bool = False) -> tuple[End, ...]:
        candidates = (end for node in nodes for end in list(getattr(node, kind)))
        skip = _is_parameter_service if of_services else _is_debug_topic
        return tuple(
            sorted(
                End(end.name, end.node.full_name, end.type_name, end.qos)
                for end in candidates
                if (hidden or not is_hidden(end.name)) and (debug or not skip(end))
            )
        )

    return Facts(
        nodes=tuple(sorted(counts)),
        duplicates=tuple(sorted((name, count) for name, count in counts.items() if count > 1)),
        remote=tuple(sorted({node.full_name for node in nodes if node.remote})),
        namespaces=tuple(sorted({node.namespace for node in nodes if node.namespace != "/"})),
        publishers=ends("publishers"),
        subscriptions=ends("subscriptions"),
        servers=ends("servers", True),
        clients=ends("clients", True),
        action_servers=_actions(nodes, "servers"),
        action_clients=_actions(nodes, "clients"),
        gone=tuple(sorted(pair for pair in dict(graph.gone).items() if hidden or not is_hidden(pair[1]))),
    )


def _is_debug_topic(endpoint: Any) -> bool:
    return endpoint.name in DEBUG_TOPICS


def _is_parameter_service(endpoint: Any) -> bool:
    return (
        endpoint.type_name.startswith("rcl_interfaces/")
        and endpoint.name.rpartition("/")[2] in PARAMETER_SERVICES
    )


def _actions(nodes: list[Any], kind: str) -> tuple[End, ...]:
    """Return the actions; they are recognised by the service for their goals."""
    return tuple(
        sorted(
            End(end.name.removesuffix(_GOAL_SERVICE), node.full_name, end.type_name.removesuffix(_GOAL_TYPE))
            for node in nodes
            for end in list(getattr(node, kind))
            if end.name.endswith(_GOAL_SERVICE)
        )
    )
