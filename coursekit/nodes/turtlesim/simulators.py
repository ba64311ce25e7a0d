"""Which turtlesims run in a session, for whoever draws them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from coursekit.sim.turtle import World

Listener = Callable[["Simulator"], None]


class Simulator(Protocol):
    """A running turtlesim."""

    world: World
    session: Any
    running: bool
    frames: int

    @property
    def full_name(self) -> str: ...
    @property
    def namespace(self) -> str: ...

    def background(self) -> tuple[int, int, int]: ...


_KEY = "running turtlesim"
_listeners: list[Listener] = []


def running(session: Any) -> list[Simulator]:
    """The turtlesims of a session, in the order of their start."""
    return list(_of(session))


def _of(session: Any) -> list[Simulator]:
    return session.locals.setdefault(_KEY, [])  # type: ignore[no-any-return]



def add(simulator: Simulator) -> None:
    """Enter one that has started."""
    _of(simulator.session).append(simulator)
    tell(simulator)


def remove(simulator: Simulator) -> None:
    """Take one out that has ended; harmless when it is out."""
    if simulator in _of(simulator.session):
        _of(simulator.session).remove(simulator)
        tell(simulator)


def tell(simulator: Simulator) -> None:
    """Something in it changed: a frame, its start, its end."""
    for listener in list(_listeners):
        listener(simulator)


def watch(listener: Listener) -> None:
    """Call `listener(simulator)` after every frame, start and end; it must not block."""
    _listeners.append(listener)


def unwatch(listener: Listener) -> None:
    """Take a listener back."""
    if listener in _listeners:
        _listeners.remove(listener)
