"""Small graphs for the tests of this room."""

from __future__ import annotations

from coursekit.core.graph import Graph
from coursekit.core.graph_node import GraphNode
from coursekit.core.qos import Qos
from coursekit.core.virtual_clock import VirtualClock
from coursekit.interfaces import load

STRING = load("std_msgs/msg/String")
TWIST = load("geometry_msgs/msg/Twist")
ADD = load("example_interfaces/srv/AddTwoInts")


def empty() -> Graph:
    """A graph without nodes."""
    return Graph(VirtualClock())


def node(
    graph: Graph,
    name: str,
    publishes: tuple[str, ...] = (),
    hears: tuple[str, ...] = (),
    qos: Qos | None = None,
) -> GraphNode:
    """A node with String topics."""
    namespace, _, last = name.rpartition("/")
    graph_node = graph.add_node(last, namespace or "/")
    for topic in publishes:
        graph_node.publisher(topic, STRING, qos or Qos())
    for topic in hears:
        graph_node.subscription(topic, STRING, qos or Qos())
    return graph_node


def chatter() -> Graph:
    """A talker and a listener."""
    graph = empty()
    node(graph, "/talker", publishes=("/chatter",))
    node(graph, "/listener", hears=("/chatter",))
    return graph
