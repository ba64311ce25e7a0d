"""A picture of a session's graph, as in rqt_graph but drawn by coursekit, with faults marked."""

from __future__ import annotations

from typing import Any

from . import graph_text
from .drawing import Drawing
from .drawn import Drawn
from .graph_facts import Facts, take
from .graph_faults import Fault, find
from .graph_picture import draw

VIEWS = ("nodes", "active", "all")
"""Only nodes; nodes and the topics that connect them; nodes and all topics."""


class GraphPicture(Drawn):
    """The graph as it was at one moment.

    A notebook stores it as lines of text, which are compared in tests, and as a PNG, which is not: nbval compares
    every stored SVG byte for byte, so the smallest change of a colour would make all notebooks fail.

    >>> from coursekit.core.graph import Graph
    >>> from coursekit.core.virtual_clock import VirtualClock
    >>> graph = Graph(VirtualClock())
    >>> node = graph.add_node("talker", "/")
    >>> print(GraphPicture(graph).text())
    graph: 1 node, 0 topics
    nodes: /talker

    In ROS 2: `rqt_graph`.
    """

    title = "graph of nodes and topics"

    def __init__(
        self,
        graph: Any,
        view: str = "all",
        *,
        services: bool = False,
        actions: bool = False,
        hidden: bool = False,
        debug: bool = False,
    ) -> None:
        if view not in VIEWS:
            raise ValueError(f"There is no view '{view}' of the graph. There are: {', '.join(VIEWS)}")
        self.view = view
        self.services = services
        self.actions = actions
        self.facts: Facts = take(graph, hidden=hidden, debug=debug)
        self.faults: list[Fault] = find(self.facts)

    def drawing(self) -> Drawing:
        """Return the picture's shapes."""
        return draw(self.facts, self.faults, self.view, services=self.services, actions=self.actions)

    def text(self) -> str:
        """Return the graph as sorted text; deterministic."""
        return graph_text.described(
            self.facts,
            self.faults,
            services=self.services,
            actions=self.actions,
            dead_ends=self.view != "active",
        )


__all__ = ["VIEWS", "GraphPicture"]
