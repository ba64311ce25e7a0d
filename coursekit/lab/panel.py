"""The common parts of all panels: a text form, few messages to the browser, and a clean shutdown."""

from __future__ import annotations

import threading
from base64 import b64decode
from typing import Any

from coursekit.processes.session import current
from coursekit.words.gettext import gettext

from .bundle import forms_of, with_text
from .docking import View
from .panel_history import PanelHistory, cursor_of
from .panel_node import HiddenNode
from .script import script, style

UPDATE_SECONDS = 0.2
"""The update period: a panel sends its changes to the browser at most five times a second."""

STILLS = 30
"""How many stills of ended panels are kept for reloaded pages; older panels are removed."""

_open: list[Panel] = []
_ended: list[Panel] = []


def static(name: str, *shared: str) -> str:
    """Return a front-end file, preceded by the parts shared by all panels (`panel.js`, `panel.css`) and by some.

    Every panel includes the shared style. A panel's own style must also override that of a panel opened later.
    """
    if name.endswith(".js"):
        return script("panel.js", *shared, name)
    return "\n".join([style("panel.css"), *(_own_style(file) for file in (*shared, name))])


def _own_style(name: str) -> str:
    kind = name.removesuffix(".css")
    return style(name).replace(f".ck-{kind} ", f".ck-panel.ck-{kind} ")


def end_panels(why: str = "") -> int:
    """End every open panel; a page that shows one keeps a still of it. Returns the number of panels."""
    count = len(_open)
    for panel in list(_open):
        panel.end(why or gettext("It has ended."))
    while len(_ended) > STILLS:
        _ended.pop(0).close()
    return count


def open_panels() -> list[Panel]:
    """Return the open panels, oldest first."""
    return list(_open)


class Panel(View):
    """The base of the panels. A subclass implements `shown` (for the browser) and `text` (for all other outputs).

    The browser sends messages with a 'type'; type 'x' calls the method `on_x`. A message may arrive in any thread,
    also while a cell runs: an `on_` method must start its work and return.
    """

    closed = True
    """True before the panel is open, and after `close`."""
    of_cell = True
    """Whether the panel ends when the cell that made it is run again."""
    keeps_states = False
    """Whether the results of `shown` are recorded, and shown again when the cursor goes back in time."""

    def __init__(self, node_name: str = "") -> None:
        super().__init__()
        self.session = current()
        self.closed = False
        self._hidden: HiddenNode | None = HiddenNode(node_name) if node_name else None
        self._seen = False
        self._farewell: tuple[dict[str, Any], list[bytes]] | None = None
        self._lock = threading.Lock()
        self._alarm: Any = None
        self._follow_up: Any = None
        self.past, self.cursor = PanelHistory(), cursor_of(self.session)
        self.cursor.watchers.append(self.look_back)
        self.on_msg(self._hear)
        _open.append(self)

    # -- for subclasses

    @property
    def hidden(self) -> HiddenNode:
        """The panel's node."""
        assert self._hidden is not None
        return self._hidden

    def shown(self) -> dict[str, Any]:
        """Return the current content for the browser."""
        return {}

    def text(self) -> str:
        """Return the panel's content as text; the same on every run of the virtual clock."""
        return type(self).__name__

    def changed(self, *_anything: Any) -> None:
        """Schedule an update of the browser; does nothing while no browser shows the panel."""
        if not self._seen or self.closed:
            return
        with self._lock:
            if self._alarm is None:
                due = self.session.clock.steady() + round(UPDATE_SECONDS * 1e9)
                self._alarm = self.session.clock.call_at(due, self._push)

    def look_again(self, seconds: float) -> None:
        """Schedule another update, as `changed` does: a topic that falls silent triggers none by itself.

        Only one such update is pending at a time, however often this is called.
        """
        if self._follow_up is None or self._follow_up.function is None:
            due = self.session.clock.steady() + round(seconds * 1e9)
            self._follow_up = self.session.clock.call_at(due, self.changed)

    def look_back(self) -> None:
        """Handle a moved cursor: show that time, if this panel records its states."""
        if self.keeps_states and self._seen:
            self.tell(type="past", on=self.cursor.time is not None)
            self._push()

    def known_since(self) -> int | None:
        """Return the oldest recorded time [ns]; None if nothing is recorded."""
        span = self.past.span()
        return span[0] if span else None

    def tell(self, **message: Any) -> None:
        """Send a message to the browser."""
        if not self.closed:
            self.send(message)

    # -- with the browser

    def _push(self) -> None:
        with self._lock:
            self._alarm = None
        state = self.shown()
        if self.keeps_states:
            size = sum(len(text) for text in state.values() if isinstance(text, str))
            self.past.keep(self.session.clock.steady(), state, size)
            if self.cursor.time is not None:
                state = self.past.at(self.cursor.time)
        self.tell(type="shown", **state)

    def _hear(self, _widget: object, message: dict[str, Any], _buffers: object) -> None:
        kind = str(message.get("type", ""))
        if self.closed:
            if kind == "ready" and self._farewell is not None:  # the page was reloaded
                message, pictures = self._farewell
                self.send({**message, "still": True}, pictures)
            return
        if kind == "ready":
            self._seen = True
            self._push()
            if self.cursor.time is not None:
                self.look_back()
            return
        react = getattr(self, f"on_{kind}", None)
        if react is not None and kind.isidentifier():
            react(message)

    # -- the end

    def end(self, why: str) -> None:
        """Leave the graph; a page keeps the last content, under an overlay with the reason `why`."""
        if self.closed:
            return
        still = forms_of(self._repr_mimebundle_()) if self._seen else None
        self._finish()
        if still is None:
            super().close()
            return
        text, picture = str(still.get("text/plain", "")), still.get("image/png", "")
        self._farewell = {"type": "ended", "why": why, "text": text}, [b64decode(picture)] if picture else []
        _ended.append(self)
        self.send(self._farewell[0])

    def close(self) -> None:
        """Leave the graph and the page."""
        if self in _ended:
            _ended.remove(self)
        self._finish()
        super().close()

    def _finish(self) -> None:
        if self.closed:
            return
        self.closed = True
        if self in _open:
            _open.remove(self)
        self.cursor.watchers.remove(self.look_back)
        for planned in (self._alarm, self._follow_up):
            if planned is not None:
                planned.cancel()
        self.leave()
        if self._hidden is not None:
            self._hidden.close()

    def leave(self) -> None:
        """Release the subclass's resources at the end."""

    # -- without the browser

    def __repr__(self) -> str:
        return self.text()

    def _repr_mimebundle_(self, **options: Any) -> Any:
        return with_text(super()._repr_mimebundle_(**options), self.text())


__all__ = ["Panel", "end_panels", "open_panels", "static"]
