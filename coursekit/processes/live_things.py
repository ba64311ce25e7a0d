"""The objects of a session that are drawn: simulators, windows, boards; their drawers are notified of each change."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic, TypeVar

T = TypeVar("T")


class LiveThings(Generic[T]):
    """The running objects of one kind, each with its `session`, and their listeners.

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
        """Return the objects of a session, in the order of their start."""
        return list(self._of(session))

    def add(self, thing: T) -> bool:
        """Add an object that has started; return whether it is drawn."""
        self._of(thing.session).append(thing)  # type: ignore[attr-defined]
        return self.tell(thing)

    def remove(self, thing: T) -> None:
        """Remove an object that has ended; harmless when it is already removed."""
        there = self._of(thing.session)  # type: ignore[attr-defined]
        if thing in there:
            there.remove(thing)
            self.tell(thing)

    def tell(self, thing: T) -> bool:
        """Notify the listeners of a start, change or end; return whether the object is drawn."""
        drawn = [listener(thing) for listener in list(self._listeners)]  # notifies all of them
        return any(drawn)

    def watch(self, listener: Callable[[T], Any]) -> None:
        """Call `listener(thing)` at every start, change and end; it must not block. A true result means that it draws it."""
        self._listeners.append(listener)

    def unwatch(self, listener: Callable[[T], Any]) -> None:
        """Remove a listener."""
        if listener in self._listeners:
            self._listeners.remove(listener)

    def _of(self, session: Any) -> list[T]:
        there: list[T] = session.locals.setdefault(self._key, [])
        return there
