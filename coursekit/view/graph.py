"""A picture of a session's graph, as in rqt_graph but drawn by coursekit, with faults marked."""

from __future__ import annotations

from typing import Any

from . import graph_text
from .drawing import Drawing, svg
from .drawing_png import png
from .graph_facts import Facts, take
from .graph_faults import Fault, find
from .graph_picture import draw

VIEWS = ("nodes", "active", "all")
"""Only nodes; nodes and the topics that connect them; nodes and all topics."""


class GraphPicture:
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

    def svg(self) -> str:
        """Return the picture as SVG."""
        return svg(self.drawing(), title="graph of nodes and topics")

    def png(self) -> bytes:
        """Return the picture as PNG, at twice the size of the SVG."""
        return png(self.drawing())

    def text(self) -> str:
        """Return the graph as sorted text; deterministic."""
        return graph_text.described(
            self.facts,
            self.faults,
            services=self.services,
            actions=self.actions,
            dead_ends=self.view != "active",
        )

    def __repr__(self) -> str:
        return self.text()

    def _repr_mimebundle_(self, **_options: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        drawing = self.drawing()
        size = {"width": round(drawing.width), "height": round(drawing.height)}
        return {"text/plain": self.text(), "image/png": png(drawing)}, {"image/png": size}


__all__ = ["VIEWS", "GraphPicture"]
