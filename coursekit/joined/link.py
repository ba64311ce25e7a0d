"""Two interpreters on the wall clock that share one ROS graph, connected by a socket.

Events from one side are applied by the other on arrival, as over a network; neither waits for the other.
"""

from __future__ import annotations

import contextlib
import socket
import sys
import threading
from collections.abc import Callable

from coursekit.core.graph import Graph

from .mirror import Mirror
from .pipe import Broken, SocketPipe

HELLO_SECONDS = 2.0
"""Timeout for a neighbour's greeting [s]; one that does not answer is stopped, or not a neighbour."""


class Link:
    """One side of the connection; created by both sides, by one of them with `calling`.

    Once it is created, each side knows the other's graph. `on_end(link)` is called once, when the other side is gone.

    Raises:
        Broken: when the other end does not answer.
    """

    def __init__(self, graph: Graph, peer: socket.socket, on_end: Callable[[Link], None], *, calling: bool) -> None:
        self.peer = peer
        self._pipe = SocketPipe(peer)
        self._on_end = on_end
        self._news = threading.Event()
        self._sent = threading.Event()
        self._ended = threading.Event()
        self.mirror = Mirror(graph, on_news=self._news.set)
        for step in (self._say, self._hear_first) if calling else (self._hear_first, self._say):
            step()  # one side sends while the other receives: two long introductions at once would fill the socket
        for work in (self._keep_hearing, self._keep_saying):
            threading.Thread(target=work, name="coursekit-link", daemon=True).start()

    def flush(self, seconds: float) -> None:
        """Wait until all earlier events are sent, at most `seconds`."""
        self._sent.clear()
        self._news.set()
        self._sent.wait(0.0 if self._ended.is_set() else seconds)

    def end(self) -> None:
        """Close the connection: the other side's nodes leave this graph."""
        if self._ended.is_set():
            return
        self._ended.set()
        self._news.set()
        with contextlib.suppress(OSError):
            self.peer.shutdown(socket.SHUT_RDWR)
        self.peer.close()
        self.mirror.end()
        self._on_end(self)

    def _say(self, always: bool = True) -> None:
        events, body = self.mirror.collect()
        if events or always:
            self._pipe.send({"events": events}, body)

    def _hear_first(self) -> None:
        self._apply(HELLO_SECONDS)

    def _apply(self, seconds: float | None = None) -> None:
        header, body = self._pipe.receive(seconds)
        self.mirror.apply(header["events"], body)

    def _keep_saying(self) -> None:
        with contextlib.suppress(Broken, OSError):
            while not self._ended.is_set():
                self._news.wait()
                self._news.clear()
                self._say(always=False)
                self._sent.set()
        self.end()

    def _keep_hearing(self) -> None:
        try:
            while True:
                self._apply()
        except (Broken, OSError):
            pass  # the connection ended
        except Exception as error:
            if not self._ended.is_set():
                print(f"[coursekit] What another program sent made no sense, so it is left out: {error!r}", file=sys.stderr)
        self.end()
