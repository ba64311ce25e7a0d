"""Sides of a network on loopback, within one interpreter: each has its graph and its Zenoh session, all share a router."""

from __future__ import annotations

import contextlib
import threading
import time

from coursekit.core.clock import WallClock
from coursekit.core.graph import Graph
from coursekit.net.link import Link
from coursekit.net.link_context import LinkContext
from coursekit.net.zenoh_session import open_client, open_router
from coursekit.systems.ports import free_port

LIMIT = 20.0
"""Ends a wait in vain; what is waited for comes by itself, as soon as it happens [s]."""


class Side:
    """One notebook or robot."""

    def __init__(self, address: str, *, domain_id: int = 0, listen_only: bool = False) -> None:
        self.graph = Graph(WallClock())
        self.said: list[str] = []
        self.told = threading.Condition()
        place = LinkContext(self.graph, domain_id, open_client(address), address, self.hear)
        self.link = Link(place, listen_only=listen_only)

    def hear(self, sentence: str) -> None:
        with self.told:
            self.said.append(sentence)
            self.told.notify_all()

    def until_told(self, part: str) -> str:
        first_line = lambda: next((line for line in self.said if part in line), None)  # noqa: E731
        with self.told:
            assert self.told.wait_for(first_line, LIMIT), (part, self.said)
            return first_line()

    def until(self, holds) -> None:
        """Wait for the graph to be as it should be."""
        changed = threading.Event()
        self.graph.watch(changed.set)
        give_up = time.monotonic() + LIMIT
        while not holds():
            assert time.monotonic() < give_up, sorted(node.full_name for node in self.graph.nodes)
            changed.wait(give_up - time.monotonic())
            changed.clear()
        self.graph.unwatch(changed.set)

    def names(self) -> list[str]:
        return sorted(node.full_name for node in self.graph.nodes)


class Inbox:
    """A queue of ready things that tells when something is put into it, as an executor's does."""

    def __init__(self, source) -> None:
        self.full = threading.Event()
        self.source = source
        source.attach(self, source)

    def put(self, _item) -> None:
        self.full.set()

    def take(self):
        """The next message, request or response."""
        give_up = time.monotonic() + LIMIT
        while (taken := self.source.take()) is None:
            self.source.queued = False
            if not self.source.has_work():
                assert self.full.wait(give_up - time.monotonic()), "nothing came"
                self.full.clear()
        self.source.queued = False
        return taken


@contextlib.contextmanager
def network():
    """A router, and a function that makes a side of it."""
    address = f"tcp/127.0.0.1:{free_port()}"
    router, sides = open_router([address]), []

    def make(*, begin: bool = True, **options) -> Side:
        side = Side(address, **options)
        sides.append(side)
        if begin:
            side.link.begin()
        return side

    make.address = address
    try:
        yield make
    finally:
        for side in sides:
            side.link.close()
        router.close()
