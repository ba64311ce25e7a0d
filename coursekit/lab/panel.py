"""The common parts of all panels: a text form, few messages to the browser, and an end that leaves nothing behind."""

from __future__ import annotations

import threading
from base64 import b64decode
from typing import Any

from coursekit.processes.session import current
from coursekit.words.gettext import gettext

from .bundle import forms_of, with_text
from .docking import View
from .hidden import HiddenNode
from .past import Past, cursor_of
from .script import script, style

UPDATE_SECONDS = 0.2
"""A panel tells the browser at most five times a second what has changed."""

STILLS = 30
"""So many stills are kept for pages that are loaded anew; older views are taken out."""

_open: list[Panel] = []
_ended: list[Panel] = []


def static(name: str, *shared: str) -> str:
    """A file of the browser's side, after what all panels share (`panel.js`, `panel.css`) and what some do.

    Every panel brings the shared style along: the own one has to win also over that of a panel which opens later.
    """
    if name.endswith(".js"):
        return script("panel.js", *shared, name)
    return "\n".join([style("panel.css"), *(_own_style(one) for one in (*shared, name))])


def _own_style(name: str) -> str:
    kind = name.removesuffix(".css")
    return style(name).replace(f".ck-{kind} ", f".ck-panel.ck-{kind} ")


def end_panels(why: str = "") -> int:
    """End every open panel, with a still of it where a page shows it; how many there were."""
    count = len(_open)
    for panel in list(_open):
        panel.end(why or gettext("It has ended."))
    while len(_ended) > STILLS:
        _ended.pop(0).close()
    return count


def open_panels() -> list[Panel]:
    """The panels that are open, oldest first."""
    return list(_open)


class Panel(View):
    """The base of the panels. A subclass gives `shown` (for the browser) and `text` (for everybody else).

    What the browser says arrives as messages with a 'type'; 'x' calls the method `on_x`. It may arrive in any thread,
    also while a cell runs: such a method starts something and returns.
    """

    closed = True
    """Until it is open, and after `close`."""
    of_cell = True
    """Whether it ends when the cell that made it is run again."""
    keeps_states = False
    """Whether what `shown` gives is kept, and shown again when the cursor goes back to it."""

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
        self.past, self.cursor = Past(), cursor_of(self.session)
        self.cursor.watchers.append(self.look_back)
        self.on_msg(self._hear)
        _open.append(self)

    # -- for a subclass

    @property
    def hidden(self) -> HiddenNode:
        """The panel's node."""
        assert self._hidden is not None
        return self._hidden

    def shown(self) -> dict[str, Any]:
        """The browser's present content."""
        return {}

    def text(self) -> str:
        """The panel's content, in lines; the same every time on the virtual clock."""
        return type(self).__name__

    def changed(self, *_anything: Any) -> None:
        """Tell the browser, soon; nothing happens while no browser shows the panel."""
        if not self._seen or self.closed:
            return
        with self._lock:
            if self._alarm is None:
                due = self.session.clock.steady() + round(UPDATE_SECONDS * 1e9)
                self._alarm = self.session.clock.call_at(due, self._push)

    def look_again(self, seconds: float) -> None:
        """Tell the browser again after a while, as `changed` does: what falls silent brings no news by itself.

        One such look is planned at a time, however often this is asked for.
        """
        if self._follow_up is None or self._follow_up.function is None:
            due = self.session.clock.steady() + round(seconds * 1e9)
            self._follow_up = self.session.clock.call_at(due, self.changed)

    def look_back(self) -> None:
        """The cursor has moved: show that time, if this panel knows it."""
        if self.keeps_states and self._seen:
            self.tell(type="past", on=self.cursor.time is not None)
            self._push()

    def known_since(self) -> int | None:
        """The oldest time that it can show again [ns]; None: it keeps none."""
        span = self.past.span()
        return span[0] if span else None

    def tell(self, **message: Any) -> None:
        """Send a message of its own."""
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

    def _hear(self, _widget: Any, message: dict[str, Any], _buffers: Any) -> None:
        kind = str(message.get("type", ""))
        if self.closed:
            if kind == "ready" and self._farewell is not None:  # the page was loaded anew
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
        """Leave the graph; a page goes on showing what there was, under a veil that says why."""
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
        """The subclass's part of the end."""

    # -- without the browser

    def __repr__(self) -> str:
        return self.text()

    def _repr_mimebundle_(self, **options: Any) -> Any:
        return with_text(super()._repr_mimebundle_(**options), self.text())


__all__ = ["Panel", "end_panels", "open_panels", "static"]
