"""Which rviz2 nodes run in a session, for whoever draws their windows."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from .config import Config


class RvizWindow(Protocol):
    """A running rviz2."""

    session: Any
    config: Config
    running: bool

    @property
    def full_name(self) -> str: ...


Listener = Callable[[RvizWindow], bool]
_KEY = "running rviz2"
_listeners: list[Listener] = []


def running(session: Any) -> list[RvizWindow]:
    """The windows of a session, in the order of their start."""
    return list(_of(session))


def _of(session: Any) -> list[RvizWindow]:
    return session.locals.setdefault(_KEY, [])  # type: ignore[no-any-return]



def add(window: RvizWindow) -> bool:
    """Enter one that has started; whether somebody draws it."""
    _of(window.session).append(window)
    return tell(window)


def remove(window: RvizWindow) -> None:
    """Take one out that has ended; harmless when it is out."""
    if window in _of(window.session):
        _of(window.session).remove(window)
        tell(window)


def tell(window: RvizWindow) -> bool:
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
