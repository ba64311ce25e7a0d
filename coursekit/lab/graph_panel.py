"""The graph in a notebook: a still picture, or a live view that follows changes."""

from __future__ import annotations

from typing import Any

from coursekit.cli.session_client import domain_id
from coursekit.processes.session import current
from coursekit.view.graph import VIEWS, GraphPicture
from coursekit.view.graph_text import details

from .panel import Panel, static

_OPTIONS = ("services", "actions", "hidden", "debug")


def graph(view: str = "all", *, live: bool = False, **options: bool) -> GraphPicture | GraphPanel:
    """Show the graph of nodes and topics, as rqt_graph draws it.

    `view` is 'nodes', 'active' (topics that connect nodes) or 'all'; `services`, `actions`, `hidden` (names that
    begin with '_') and `debug` (/rosout, /parameter_events, parameter services) add more. `live=True` follows every
    change, and shows the details of a clicked node or topic.

    >>> %ros2 run demo_nodes_py talker &
    [talker: running]
    >>> %ros2 run demo_nodes_py listener &
    [listener: running]
    >>> wait(1)
    >>> graph()
    graph: 2 nodes, 1 topic
    nodes: /listener, /talker
    topic /chatter [std_msgs/msg/String]: /talker -> /listener
    """
    unknown = sorted(set(options) - set(_OPTIONS))
    if unknown:
        raise TypeError(f"graph() has no option '{unknown[0]}'. It has: live, {', '.join(_OPTIONS)}")
    if live:
        return GraphPanel(view, **options)
    return GraphPicture(current().graph(domain_id()), view, **options)


class GraphPanel(Panel):
    """A live picture of the graph; `picture()` returns the current one."""

    _esm = static("graph.js", "drawing.js")
    _css = static("graph.css")
    keeps_states = True

    def __init__(self, view: str = "all", **options: bool) -> None:
        self._graph = current().graph(domain_id())
        self._view = view
        self._options = {name: options.get(name, False) for name in _OPTIONS}
        self._chosen = ""
        self.picture()  # raises for an unknown view
        super().__init__()
        self._graph.watch(self.changed)

    def picture(self) -> GraphPicture:
        """Return a picture of the current graph."""
        return GraphPicture(self._graph, self._view, **self._options)

    def details(self, name: str) -> str:
        """Return the output of `ros2 node info` or `ros2 topic info -v` for a node or topic."""
        return details(self._graph, name)

    def text(self) -> str:
        """Return the graph as text."""
        return self.picture().text()

    def shown(self) -> dict[str, Any]:
        """Return the picture and the selection."""
        said = self.details(self._chosen) if self._chosen else ""
        return {
            "svg": self.picture().svg(),
            "view": self._view,
            "options": self._options,
            "chosen": self._chosen,
            "details": said,
        }

    def on_view(self, message: dict[str, Any]) -> None:
        """Switch to another view."""
        if message.get("view") in VIEWS:
            self._view = str(message["view"])
        self._push()

    def on_option(self, message: dict[str, Any]) -> None:
        """Switch an option on or off."""
        if message.get("name") in _OPTIONS:
            self._options[str(message["name"])] = bool(message.get("on"))
        self._push()

    def on_choose(self, message: dict[str, Any]) -> None:
        """Select the clicked node or topic; '' closes the details."""
        self._chosen = str(message.get("name", ""))
        self._push()

    def leave(self) -> None:
        """Stop watching the graph."""
        self._graph.unwatch(self.changed)


__all__ = ["GraphPanel", "graph"]
