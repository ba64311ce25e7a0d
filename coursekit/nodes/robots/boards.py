"""Which joint_state_publisher_gui nodes run in a session, for whoever draws their sliders."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from coursekit.nodes.robots.joint_model import JointModel

Listener = Callable[["Board"], None]


class Board(Protocol):
    """A running joint_state_publisher_gui."""

    session: Any
    running: bool
    model: JointModel

    @property
    def full_name(self) -> str: ...

    def move(self, name: str, position: float) -> None: ...
    def center(self) -> None: ...
    def randomize(self) -> None: ...


_KEY = "running joint_state_publisher_gui"
_listeners: list[Listener] = []


def running(session: Any) -> list[Board]:
    """The boards of a session, in the order of their start."""
    return list(_of(session))


def _of(session: Any) -> list[Board]:
    return session.locals.setdefault(_KEY, [])  # type: ignore[no-any-return]



def add(board: Board) -> None:
    """Enter one that has started."""
    _of(board.session).append(board)
    tell(board)


def remove(board: Board) -> None:
    """Take one out that has ended; harmless when it is out."""
    if board in _of(board.session):
        _of(board.session).remove(board)
        tell(board)


def tell(board: Board) -> None:
    """Something in it changed: its joints, a position, its start or end."""
    for listener in list(_listeners):
        listener(board)


def watch(listener: Listener) -> None:
    """Call `listener(board)` after every change; it must not block."""
    _listeners.append(listener)


def unwatch(listener: Listener) -> None:
    """Take a listener back."""
    if listener in _listeners:
        _listeners.remove(listener)
