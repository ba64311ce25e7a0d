"""Records messages at the instant of publishing, and on which side of the trial they were published."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from coursekit.core.graph import Graph
from coursekit.core.graph_node import GraphNode
from coursekit.core.qos import BEST_EFFORT, KEEP_ALL, Qos
from coursekit.core.topic import Publisher, Subscription
from coursekit.interfaces import load
from coursekit.joined.ghosts import GhostPublisher

from .plan import EVERY_NODE_S

Keep = Callable[[str, float, Any, bool], None]
"""A callback with topic, session time [s], fields, and whether a program of this interpreter published the message."""


class Recorder:
    """Subscribes as one node to each wanted topic as soon as it is published; `*` wants all topics of the programs."""

    def __init__(self, node: GraphNode, wanted: list[str], keep: Keep) -> None:
        self._graph = node.graph
        self._node = node
        self._wanted = set(wanted)
        self._keep = keep
        self._recorded: set[str] = set()
        self._graph.watch(self._look)
        self._look()

    def _look(self) -> None:
        for topic, publishers in list(self._graph.publishers.items()):
            if topic not in self._recorded and self._is_wanted(topic, publishers):
                self._recorded.add(topic)
                self._record(topic, publishers[0])

    def _is_wanted(self, topic: str, publishers: list[Publisher]) -> bool:
        if topic in self._wanted:
            return True
        own = any(publisher.node is not self._node for publisher in publishers)
        return "*" in self._wanted and topic not in EVERY_NODE_S and own

    def _record(self, topic: str, publisher: Publisher) -> None:
        qos = Qos(history=KEEP_ALL, reliability=BEST_EFFORT, durability=publisher.qos.durability)
        kind = load(publisher.type_name)
        self._graph.add_subscription(_Recording(self._graph, self._node, topic, kind, qos, self._keep))


class _Recording(Subscription):
    """Passes every message on instead of queueing it."""

    __slots__ = ("keep",)

    def __init__(self, graph: Graph, node: GraphNode, name: str, msg_type: Any, qos: Qos, keep: Keep) -> None:
        from rosidl_runtime_py import message_to_ordereddict

        super().__init__(graph, node, name, msg_type, qos)
        self.keep = keep
        self.reduce = message_to_ordereddict

    def push(self, entry: tuple[Any, int, Publisher]) -> None:
        """Record the message immediately."""
        fields, _, publisher = entry
        self.keep(self.name, self.graph.clock.steady() * 1e-9, fields, not isinstance(publisher, GhostPublisher))
