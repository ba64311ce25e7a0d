"""Which windows of rqt run in a session, for whoever draws them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(eq=False)
class RqtWindow:
    """A running window."""

    kind: str
    """`rqt_graph`, `rqt_console`, `rqt_plot` or `rqt_gui`."""
    session: Any
    picture: str = ""
    """The name of the OpenCV window in which it draws; empty where it is a panel."""
    running: bool = True


Listener = Callable[[RqtWindow], bool]
_listeners: list[Listener] = []


def tell(window: RqtWindow) -> bool:
    """It has started or ended; whether somebody draws it."""
    drawn = [listener(window) for listener in list(_listeners)]  # all of them hear of it
    return any(drawn)


def watch(listener: Listener) -> None:
    """Call `listener(window)` at every start and end; it must not block, and says whether it draws the window."""
    _listeners.append(listener)


def unwatch(listener: Listener) -> None:
    """Take a listener back."""
    if listener in _listeners:
        _listeners.remove(listener)
