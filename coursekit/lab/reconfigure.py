"""The window of rqt_reconfigure: the nodes of the graph, and the parameters of one of them."""

from __future__ import annotations

import threading
from typing import Any

import ipywidgets

from coursekit.cli.session_client import domain_id
from coursekit.processes.session import current
from coursekit.rcl.names import is_hidden
from coursekit.view.graph_facts import DEBUG_NODES
from coursekit.words.gettext import gettext

from .parameter_panel import ParameterPanel

_SERVICE = "/list_parameters"


class Reconfigure(ipywidgets.VBox):
    """A list of nodes that follows the graph; the chosen node's parameters are below it."""

    of_cell = False

    def __init__(self) -> None:
        self._session = current()
        self._graph = self._session.graph(domain_id())
        self._list = ipywidgets.Dropdown(description=gettext("Node"), options=[])
        self._panel: Any = None
        self._lock = threading.Lock()
        self._closed = False
        super().__init__([self._list])
        self._list.observe(self._choose, "value")
        self._graph.watch(self._look)
        self._look()

    @property
    def nodes(self) -> list[str]:
        """The nodes that can be chosen."""
        return list(self._list.options)

    def choose(self, node: str) -> None:
        """Show a node's parameters, as a click does."""
        self._list.value = node

    def close(self) -> None:
        """Stop watching the graph, and close the parameters."""
        self._closed = True
        self._graph.unwatch(self._look)
        self._show(None)
        super().close()

    def _look(self) -> None:
        """Update the list after a change of the graph, which any thread may have made."""
        with self._lock:
            nodes = self._with_parameters()
            if nodes == self._list.options:
                return
            chosen = self._list.value
            self._list.unobserve(self._choose, "value")  # new options choose the first for a moment
            self._list.options = nodes
            self._list.value = chosen if chosen in nodes else next(iter(nodes), None)
            self._list.observe(self._choose, "value")
            if self._list.value != chosen:
                self._choose({"new": self._list.value})

    def _with_parameters(self) -> tuple[str, ...]:
        names = [name.removesuffix(_SERVICE) for name in list(self._graph.servers) if name.endswith(_SERVICE)]
        return tuple(sorted(name for name in names if not is_hidden(name) and not name.startswith(DEBUG_NODES)))

    def _choose(self, change: dict[str, Any]) -> None:
        self._session.spawn(self._read, change["new"])

    def _read(self, node: str | None) -> None:
        """Ask the node for its parameters, in a thread of its own: it may take a while to answer."""
        try:
            panel = ParameterPanel(node) if node else None
        except (LookupError, TimeoutError) as error:
            self._show(ipywidgets.Label(str(error)))
            return
        if panel is not None:
            panel.of_cell = False
        if node == self._list.value and not self._closed:
            self._show(panel)
        elif panel is not None:
            panel.close()

    def _show(self, panel: Any) -> None:
        before, self._panel = self._panel, panel
        self.children = [self._list] if panel is None else [self._list, panel]
        if before is not None:
            before.close()


__all__ = ["Reconfigure"]
