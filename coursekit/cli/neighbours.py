"""Programs that run beside each other on the wall clock, each in an interpreter of its own: how they find each other.

Each listens at `program-DOMAIN-PID` in the user's runtime folder, test runs at `test-DOMAIN-PID`; who comes calls those
that are there. Two test runs never meet, so that they do not disturb each other. Notebooks stay among themselves.
"""

from __future__ import annotations

import atexit
import contextlib
import os
import socket
import sys
import threading
from pathlib import Path

from coursekit.core.graph import Graph
from coursekit.joined.link import Link
from coursekit.joined.pipe import Broken
from coursekit.systems.locks import alone
from coursekit.systems.runtime_folder import folder
from coursekit.systems.user_socket import NobodyListens, accept, call, listen_at

FLUSH_SECONDS = 0.5
"""How long the last words of a program may take to be on their way [s]."""
_domains: dict[int, Neighbourhood] = {}
_joining = threading.Lock()


def meet(graph: Graph, domain_id: int) -> None:
    """Have the nodes of `graph` and those of the domain's other programs see each other, from now on.

    A second call for the same domain does nothing.
    """
    with _joining:
        if domain_id not in _domains:
            with contextlib.suppress(OSError):  # no safe folder: `coursekit doctor` says so; a program runs by itself then
                _domains[domain_id] = Neighbourhood(graph, domain_id)


class Neighbourhood:
    """The other programs of one domain, as this one is joined to them."""

    def __init__(self, graph: Graph, domain_id: int) -> None:
        self._graph = graph
        self._links: list[Link] = []
        kind = "test" if "pytest" in sys.modules else "program"
        self._path = folder() / f"{kind}-{domain_id}-{os.getpid()}"
        with alone(folder() / f"meeting-{domain_id}"):  # who listens later calls, so no two are joined twice
            found = neighbours(domain_id, ("program",) if kind == "test" else ("program", "test"))
            self._server = listen_at(self._path)
            for path in found:
                self._call(path)
        threading.Thread(target=self._accept, name="coursekit-neighbours", daemon=True).start()

    def _call(self, path: Path) -> None:
        try:
            self._join(call(path), calling=True)
        except NobodyListens:
            path.unlink(missing_ok=True)  # it ended without a word

    def _join(self, peer: socket.socket, *, calling: bool) -> None:
        try:
            self._links.append(Link(self._graph, peer, self._forget, calling=calling))
        except (Broken, OSError):
            peer.close()

    def _forget(self, link: Link) -> None:
        with contextlib.suppress(ValueError):
            self._links.remove(link)

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                self._join(accept(self._server, self._path), calling=False)

    def abandon(self) -> None:
        """In a forked child: let go of the sockets and of the nodes, which are the parent's, without a word."""
        for one in (self._server, *(link.peer for link in self._links)):
            one.close()
        self._graph.abandon()

    def leave(self) -> None:
        """Hang up, after the last words."""
        self._path.unlink(missing_ok=True)
        for link in list(self._links):
            link.flush(FLUSH_SECONDS)
            link.end()


def neighbours(domain_id: int, kinds: tuple[str, ...] = ("program", "test")) -> list[Path]:
    """Where programs of the domain listen; some may be gone."""
    found = [path for kind in kinds for path in folder().glob(f"{kind}-{domain_id}-*")]
    return sorted(path for path in found if path.name.rpartition("-")[2].isdecimal())


def _leave_all() -> None:
    for one in list(_domains.values()):
        one.leave()
    _domains.clear()


def _abandon_all() -> None:
    """A forked child is a program of its own, that meets others when it joins a domain."""
    for one in _domains.values():
        one.abandon()
    _domains.clear()


atexit.register(_leave_all)
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_abandon_all)
