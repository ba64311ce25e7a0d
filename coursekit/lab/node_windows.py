"""Windows of nodes: panels below the cell that started the node, until the node ends or a cell shows the same panel."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from coursekit.processes.live_things import LiveThings


class NodeWindows:
    """The windows of one kind. A panel takes a moment to create; if it is no longer wanted by then, it does not appear.

    Owners are the objects that open windows. They have a `session` and a flag `running`, and are compared by
    identity.
    """

    def __init__(self, owners: LiveThings[Any], make: Callable[[Any], Any]) -> None:
        self._owners = owners
        self._make = make
        self._lock = threading.Lock()
        self._known: set[int] = set()
        self._wanted: set[int] = set()
        self._panels: dict[int, Any] = {}

    def watch(self) -> None:
        """Show the windows of owners in this notebook's session."""
        self._owners.unwatch(self.hear)
        self._owners.watch(self.hear)

    def hear(self, owner: Any) -> bool:
        """Handle an owner that has started, changed or ended. Returns whether this notebook draws its window."""
        session = owner.session
        if session.embedded and not session.clock.virtual:
            if owner.running:
                self.show(owner)
            else:
                session.spawn(self.forget, owner)
        return bool(session.embedded)

    def show(self, owner: Any) -> None:
        """Open a window once, in another thread."""
        if id(owner) not in self._known:
            self._known.add(id(owner))
            self._wanted.add(id(owner))
            owner.session.spawn(self.open, owner)

    def open(self, owner: Any) -> None:
        """Create and display the window, unless it is no longer wanted."""
        from IPython.display import display

        panel = self._make(owner)
        panel.of_cell = False
        with self._lock:
            wanted = id(owner) in self._wanted
            if wanted:
                self._panels[id(owner)] = panel
                display(panel)
        if not wanted:
            panel.close()

    def hide(self, owner: Any) -> None:
        """Remove the window for good."""
        self._known.add(id(owner))
        with self._lock:
            self._wanted.discard(id(owner))
            panel = self._panels.pop(id(owner), None)
        if panel is not None:
            panel.close()

    def forget(self, owner: Any) -> None:
        """Remove the window of an owner that has ended."""
        self.hide(owner)
        self._known.discard(id(owner))


__all__ = ["NodeWindows"]
