"""The daemon of `ros2`: the session already knows the graph, so only the daemon's reported state remains.

The daemon counts as running until it is stopped. A restarted one has a hidden node, as on a robot.
"""

from __future__ import annotations

import uuid
import weakref
from typing import Any

from rcl_interfaces.msg import Log, ParameterEvent

from coursekit.core.graph import Graph
from coursekit.core.graph_node import GraphNode
from coursekit.core.qos import TRANSIENT_LOCAL, Qos

_TOPICS: tuple[tuple[str, Any, Qos], ...] = (
    ("/rosout", Log, Qos(depth=1000, durability=TRANSIENT_LOCAL)),
    ("/parameter_events", ParameterEvent, Qos(depth=1000)),
)
_changed: weakref.WeakKeyDictionary[Graph, GraphNode | None] = weakref.WeakKeyDictionary()
"""The node of a restarted daemon; None after a stop."""


def is_running(graph: Graph) -> bool:
    """Whether the daemon is running."""
    node = _changed.get(graph)
    return graph not in _changed or (node is not None and node in graph.nodes)


def start(graph: Graph, domain_id: int) -> bool:
    """Start the daemon; False when it is already running."""
    if is_running(graph):
        return False
    node = graph.add_node(f"_ros2cli_daemon_{domain_id}_{uuid.uuid4().hex}", "/")
    for name, kind, qos in _TOPICS:
        node.publisher(name, kind, qos)
    _changed[graph] = node
    return True


def stop(graph: Graph) -> bool:
    """Stop the daemon; False when it is not running."""
    if not is_running(graph):
        return False
    node = _changed.get(graph)
    _changed[graph] = None
    if node is not None:
        node.close()
    return True
