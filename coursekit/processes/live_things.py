"""The things of a session that others draw: simulators, windows, boards; the drawers hear of each change."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic, TypeVar

T = TypeVar("T")


class LiveThings(Generic[T]):
    """The running things of one kind, each with its `session`, and those who listen.

    >>> from types import SimpleNamespace
    >>> from coursekit.processes.session import Session
    >>> lamps, lamp = LiveThings("lamps"), SimpleNamespace(session=Session(virtual=True))
    >>> lamps.watch(lambda changed: True)
    >>> lamps.add(lamp), lamps.running(lamp.session) == [lamp]
    (True, True)
    """

    def __init__(self, name: str) -> None:
        self._key = f"running {name}"
        self._listeners: list[Callable[[T], Any]] = []

    def running(self, session: Any) -> list[T]:
        """Those of a session, in the order of their start."""
        return list(self._of(session))

    def add(self, thing: T) -> bool:
        """Enter one that has started; whether somebody draws it."""
        self._of(thing.session).append(thing)  # type: ignore[attr-defined]
        return self.tell(thing)

    def remove(self, thing: T) -> None:
        """Take one out that has ended; harmless when it is out."""
        there = self._of(thing.session)  # type: ignore[attr-defined]
        if thing in there:
            there.remove(thing)
            self.tell(thing)

    def tell(self, thing: T) -> bool:
        """It has started, changed or ended; whether somebody draws it."""
        drawn = [listener(thing) for listener in list(self._listeners)]  # all of them hear of it
        return any(drawn)

    def watch(self, listener: Callable[[T], Any]) -> None:
        """Call `listener(thing)` at every start, change and end; it must not block. A true value says that it draws it."""
        self._listeners.append(listener)

    def unwatch(self, listener: Callable[[T], Any]) -> None:
        """Take a listener back."""
        if listener in self._listeners:
            self._listeners.remove(listener)

    def _of(self, session: Any) -> list[T]:
        there: list[T] = session.locals.setdefault(self._key, [])
        return there
