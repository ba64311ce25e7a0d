"""Discovery among programs that run side by side on the wall clock, each in its own interpreter.

Each program listens at `program-DOMAIN-PID` in the user's runtime folder, a test run at `test-DOMAIN-PID`. A new
program connects to the existing ones. Test runs are never connected to each other, to avoid interference. Notebooks
do not take part.
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
"""The timeout for sending a program's last messages [s]."""
_domains: dict[int, Neighbourhood] = {}
_joining = threading.Lock()


def meet(graph: Graph, domain_id: int) -> None:
    """Connect the nodes of `graph` with those of the domain's other programs.

    A second call for the same domain does nothing.
    """
    with _joining:
        if domain_id not in _domains:
            with contextlib.suppress(OSError):  # no safe folder: `coursekit doctor` reports it; the program runs alone
                _domains[domain_id] = Neighbourhood(graph, domain_id)


class Neighbourhood:
    """The connections to the other programs of one domain."""

    def __init__(self, graph: Graph, domain_id: int) -> None:
        self._graph = graph
        self._links: list[Link] = []
        kind = "test" if "pytest" in sys.modules else "program"
        self._path = folder() / f"{kind}-{domain_id}-{os.getpid()}"
        with alone(folder() / f"meeting-{domain_id}"):  # later listeners call earlier ones, so no two are joined twice
            paths = neighbours(domain_id, ("program",) if kind == "test" else ("program", "test"))
            self._server = listen_at(self._path)
            for path in paths:
                self._call(path)
        threading.Thread(target=self._accept, name="coursekit-neighbours", daemon=True).start()

    def _call(self, path: Path) -> None:
        try:
            self._join(call(path), calling=True)
        except NobodyListens:
            path.unlink(missing_ok=True)  # it ended without closing its socket

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
        """In a forked child, silently drop the sockets and nodes, which belong to the parent."""
        for peer in (self._server, *(link.peer for link in self._links)):
            peer.close()
        self._graph.abandon()

    def leave(self) -> None:
        """Close the connections after sending the last messages."""
        self._path.unlink(missing_ok=True)
        for link in list(self._links):
            link.flush(FLUSH_SECONDS)
            link.end()


def neighbours(domain_id: int, kinds: tuple[str, ...] = ("program", "test")) -> list[Path]:
    """Return the addresses of the domain's programs; some may be stale."""
    paths = [path for kind in kinds for path in folder().glob(f"{kind}-{domain_id}-*")]
    return sorted(path for path in paths if path.name.rpartition("-")[2].isdecimal())


def _leave_all() -> None:
    for domain in list(_domains.values()):
        domain.leave()
    _domains.clear()


def _abandon_all() -> None:
    """In a forked child, drop all connections: it is a program of its own, and connects when it joins a domain."""
    for domain in _domains.values():
        domain.abandon()
    _domains.clear()


atexit.register(_leave_all)
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_abandon_all)
