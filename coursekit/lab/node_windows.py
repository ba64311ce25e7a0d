"""Windows of nodes: panels that appear below the cell that started the node, until it ends or a cell shows the same."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from coursekit.processes.live_things import LiveThings


class NodeWindows:
    """The windows of one kind. A panel takes a moment to make: what is no longer wanted by then does not appear.

    Owners are what opens windows: they have a `session`, say whether they are `running`, and are told apart by identity.
    """

    def __init__(self, owners: LiveThings[Any], make: Callable[[Any], Any]) -> None:
        self._owners = owners
        self._make = make
        self._lock = threading.Lock()
        self._known: set[int] = set()
        self._wanted: set[int] = set()
        self._panels: dict[int, Any] = {}

    def watch(self) -> None:
        """Have the owners of this notebook's session show their windows in it."""
        self._owners.unwatch(self.hear)
        self._owners.watch(self.hear)

    def hear(self, owner: Any) -> bool:
        """An owner has started, changed or ended; whether its window is this notebook's to draw."""
        session = owner.session
        if session.embedded and not session.clock.virtual:
            if owner.running:
                self.show(owner)
            else:
                session.spawn(self.forget, owner)
        return bool(session.embedded)

    def show(self, owner: Any) -> None:
        """Have a window appear, once; it is made beside the caller."""
        if id(owner) not in self._known:
            self._known.add(id(owner))
            self._wanted.add(id(owner))
            owner.session.spawn(self.open, owner)

    def open(self, owner: Any) -> None:
        """Make and display the window, unless it is not wanted any more."""
        from IPython.display import display

        made = self._make(owner)
        made.of_cell = False
        with self._lock:
            wanted = id(owner) in self._wanted
            if wanted:
                self._panels[id(owner)] = made
                display(made)
        if not wanted:
            made.close()

    def hide(self, owner: Any) -> None:
        """Take the window away; it does not come back."""
        self._known.add(id(owner))
        with self._lock:
            self._wanted.discard(id(owner))
            panel = self._panels.pop(id(owner), None)
        if panel is not None:
            panel.close()

    def forget(self, owner: Any) -> None:
        """The owner has ended: its window goes."""
        self.hide(owner)
        self._known.discard(id(owner))


__all__ = ["NodeWindows"]
