"""Two interpreters on the wall clock that share one ROS graph, joined by a socket.

What one side says is applied by the other as soon as it arrives, as over a network; neither waits for the other.
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
"""A neighbour that does not answer in this time is passed over: it is stopped, or is no neighbour [s]."""


class Link:
    """One side of the connection; made by both, one of them with `calling`.

    When it is made, each side knows the other's graph. `on_end(link)` is called once, when the other side is gone.

    Raises:
        Broken: when nobody answers at the other end.
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
            step()  # one speaks, the other listens: two long introductions at once would fill the socket
        for work in (self._keep_hearing, self._keep_saying):
            threading.Thread(target=work, name="coursekit-link", daemon=True).start()

    def flush(self, seconds: float) -> None:
        """Wait until what was said before is on its way, at most `seconds`."""
        self._sent.clear()
        self._news.set()
        self._sent.wait(0.0 if self._ended.is_set() else seconds)

    def end(self) -> None:
        """Hang up: the other side's nodes leave this graph."""
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
            pass  # it ended
        except Exception as error:
            if not self._ended.is_set():
                print(f"[coursekit] What another program sent made no sense, so it is left out: {error!r}", file=sys.stderr)
        self.end()
