"""Two virtual clocks as one: the leader sets the follower's time limit, the follower stops when it has an event to send."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from coursekit.core.graph import Graph
from coursekit.core.virtual_clock import VirtualClock

from .mirror import Mirror
from .pipe import Broken, Pipe

Events = list[list[Any]]


class _Side:
    """The common part of both sides: `post` sends an event to the other side, `on_event` receives its events."""

    def __init__(self, clock: VirtualClock, graph: Graph, pipe: Pipe, on_event: Callable[[list[Any]], None]) -> None:
        self.clock = clock
        self.pipe = pipe
        self.mirror = Mirror(graph)
        self.on_event = on_event
        clock.partner = self

    def post(self, *event: Any) -> None:
        """Send an event that does not concern the graph: a word and JSON values."""
        self.mirror.post(list(event))

    def _apply(self, events: Any, body: bytes) -> bool:
        try:
            for event in self.mirror.apply(events, body):
                self.on_event(event)
        except Exception as error:  # any exception means that the other side's event was malformed
            raise Broken(f"it sent something malformed: {type(error).__name__}: {error}"[:200]) from None
        return bool(events)


class Leader(_Side):
    """The side with the ruling clock. `on_broken(reason)` is called, and must not return, when the other side fails."""

    def __init__(
        self,
        clock: VirtualClock,
        graph: Graph,
        pipe: Pipe,
        on_event: Callable[[list[Any]], None],
        on_broken: Callable[[str], None],
        patience: float,
    ) -> None:
        super().__init__(clock, graph, pipe, on_event)
        self._on_broken = on_broken
        self._patience = patience
        self._next: int | None = 0
        """Time of the follower's next scheduled event [ns]; None for none."""

    def meet(self, deadline: int | None) -> bool:
        """Called when nothing is ready, before time advances to `deadline`; return whether the follower sent an event."""
        events, body = self.mirror.collect()
        if not events and (self._next is None or (deadline is not None and self._next > deadline)):
            return False
        try:
            self.pipe.send({"now": self.clock.steady(), "until": deadline, "events": events}, body)
            return self._heard(*self.pipe.receive(self._patience), deadline)
        except Broken as broken:
            self._on_broken(str(broken))
            raise

    def _heard(self, answer: dict[str, Any], body: bytes, deadline: int | None) -> bool:
        now, following = answer.get("now"), answer.get("next")
        if type(now) is not int or type(following) not in (int, type(None)) or type(answer.get("events")) is not list:
            raise Broken("it sent something malformed")
        if now < self.clock.steady() or (deadline is not None and now > deadline):
            raise Broken("it did not keep to the clock")
        self._next = following
        if answer["events"]:
            self.clock.jump(now)
        return self._apply(answer["events"], body)


class Follower(_Side):
    """The side that runs up to the leader's limit. When the leader is gone, its interpreter exits."""

    def __init__(self, clock: VirtualClock, graph: Graph, pipe: Pipe, on_event: Callable[[list[Any]], None]) -> None:
        super().__init__(clock, graph, pipe, on_event)
        self._until: int | None = 0
        self._owes = False

    def meet(self, deadline: int | None) -> bool:
        """Called when nothing is ready, before time advances to `deadline`; return whether the leader sent an event."""
        try:
            if self._owes:
                events, body = self.mirror.collect()
                if not events and deadline is not None and (self._until is None or deadline <= self._until):
                    return False
                now = self.clock.steady() if events or self._until is None else self._until
                self.pipe.send({"now": now, "next": deadline, "events": events}, body)
            order, body = self.pipe.receive()
        except Broken:
            os._exit(1)
        self._owes = True
        self.clock.jump(order["now"])
        self._until = order["until"]
        self._apply(order["events"], body)
        return True
