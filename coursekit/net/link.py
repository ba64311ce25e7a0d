"""One session's link to a network: its own thread makes all changes, in the order in which they arrive."""

from __future__ import annotations

import contextlib
import queue
import sys
import threading
import traceback
import weakref
from collections.abc import Callable
from typing import Any

from coursekit.systems.user_socket import HAS_UNIX

from .announcements import Announcer
from .direct import DirectLines
from .link_context import LinkContext
from .remote_graph import RemoteGraph
from .wire.token import ADMIN, Token, read_token

SETTLE_SECONDS = 5.0
"""Timeout for receiving the peers' announcements while joining [s]."""
CLOSE_SECONDS = 2.0
"""Timeout for leaving; work unfinished by then is left to the peers' own timeouts [s]."""


class Link:
    """Inspects a network first (`tokens`); this side stays invisible until `begin`."""

    def __init__(self, place: LinkContext, *, listen_only: bool = False) -> None:
        self.place = place
        self.listen_only = listen_only
        self.visitors = RemoteGraph(place, listen_only=listen_only)
        self.direct = self._listen_for_neighbours()
        self.announcer = Announcer(place, self.direct, listen_only=listen_only)
        self.since = place.graph.clock.now()
        self.is_up = True
        """Whether the router is reachable."""
        self.on_change: list[Callable[[], None]] = []
        """Called, by any thread, when the link is lost, comes back, or is left."""
        self.closed = False
        self._jobs: queue.SimpleQueue[Callable[[], None] | None] = queue.SimpleQueue()
        self._planned = threading.Event()
        self._worker = threading.Thread(target=self._work, name="coursekit-network", daemon=True)
        self._listeners: list[Any] = []
        _close_before_python_ends(self)

    def _listen_for_neighbours(self) -> DirectLines | None:
        if not HAS_UNIX:
            return None  # a notebook opens no port
        with contextlib.suppress(OSError):  # no safe folder: `coursekit doctor` reports it
            return DirectLines(self.place.address, self.place.id, self.visitors.take)
        return None

    def tokens(self) -> list[Token]:
        """Return the current announcements of the peers."""
        tokens = []
        for reply in self.place.session.liveliness().get(self._key, timeout=SETTLE_SECONDS):
            if reply.ok is not None:
                with contextlib.suppress(ValueError):
                    tokens.append(read_token(str(reply.ok.key_expr)))
        return tokens

    @property
    def _key(self) -> str:
        """The key expression of all tokens of the domain."""
        return f"{ADMIN}/{self.place.domain_id}/**"

    def begin(self) -> None:
        """Join the network, and wait until the current announcements of both sides are known."""
        there = {token.text() for token in self.tokens() if self.visitors.wants(token)}
        session = self.place.session  # the query above comes first: Zenoh does not answer a query whose key is subscribed to
        self._listeners = [
            session.info.declare_transport_events_listener(self._hear_transport),
            session.liveliness().declare_subscriber(self._key, self._hear_token, history=True),
        ]
        self.place.graph.watch(self._plan)
        self._worker.start()
        self._plan()
        self.visitors.wait_for(there, SETTLE_SECONDS)
        self.settle()

    def settle(self, seconds: float = SETTLE_SECONDS) -> bool:
        """Wait until all changes that have arrived so far are processed; return whether this was in time."""
        done = threading.Event()
        self._do(done.set)
        return done.wait(seconds)

    def close(self) -> None:
        """Leave at once, even if the router does not answer; harmless when already left."""
        if self.closed:
            return
        self.closed = True
        self.place.graph.unwatch(self._plan)
        self._jobs.put(None)
        leaving = threading.Thread(target=self._leave, name="coursekit-network-leave", daemon=True)
        try:
            leaving.start()
            leaving.join(CLOSE_SECONDS)
        except RuntimeError:  # at interpreter exit no thread can start
            self._leave()
        for tell_of_it in list(self.on_change):
            tell_of_it()

    def _leave(self) -> None:
        if self._worker.ident is not None:
            self._worker.join(CLOSE_SECONDS)
        for listener in self._listeners:
            listener.undeclare()
        with contextlib.suppress(Exception):
            self.announcer.close()
        self.visitors.close()
        if self.direct:
            self.direct.close()
        self.place.session.close()

    def _work(self) -> None:
        while (job := self._jobs.get()) is not None:
            try:
                job()
            except Exception:
                if not self.closed:
                    traceback.print_exc(file=sys.stderr)

    def _do(self, job: Callable[..., None], *args: Any) -> None:
        self._jobs.put((lambda: job(*args)) if args else job)

    def _plan(self) -> None:
        """Schedule a comparison of the graph with the announcements; many changes at once are compared once."""
        if not self._planned.is_set():
            self._planned.set()
            self._do(self._compare)

    def _compare(self) -> None:
        self._planned.clear()
        self.visitors.listen()
        if self.direct:
            self.direct.keep(self.visitors.sessions)
        self.announcer.compare()
        self.visitors.compare()

    def _hear_token(self, sample: Any) -> None:
        self._do(self.visitors.left if _is_end(sample) else self.visitors.came, str(sample.key_expr))

    def _hear_transport(self, event: Any) -> None:
        self._do(self._change, not _is_end(event))

    def _change(self, is_up: bool) -> None:
        if is_up == self.is_up or self.closed:
            return
        self.is_up = is_up
        if self.direct:
            self.direct.pause(not is_up)
        where = self.place.address
        self.place.tell(
            f"The link to {where} is there again."
            if is_up
            else f"The link to {where} is gone. Nothing is sent or heard; it is tried again until `%network off`."
        )
        for tell_of_it in list(self.on_change):
            tell_of_it()


def _is_end(event: Any) -> bool:
    return str(event.kind).endswith("DELETE")


_open: weakref.WeakSet[Link] = weakref.WeakSet()


def _close_before_python_ends(link: Link) -> None:
    """Close the link before Python ends: Zenoh's threads call Python, and `atexit` would be too late, with a hang."""
    if not _open:
        threading._register_atexit(_close_all)  # type: ignore[attr-defined]
    _open.add(link)


def _close_all() -> None:
    for link in list(_open):
        link.close()
