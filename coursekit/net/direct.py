"""Short messages go straight to sessions of the same user on this computer that joined at the same address.

Such a socket has no router and no threads of an engine on its way, so it takes half the time. Zenoh announces everything
all the same, and carries what is long, latched or never dropped, and what goes to another computer.
"""

from __future__ import annotations

import contextlib
import hashlib
import itertools
import socket
import struct
import threading
import time
from collections.abc import Callable, Collection, Iterable
from pathlib import Path

from coursekit.systems.runtime_folder import folder
from coursekit.systems.user_socket import NobodyListens, accept, call, connect_at, listen_at

from .opening import BUSY_SECONDS
from .wire.attachment import SIZE, Attachment, read_attachment

LONGEST = 3072
"""Bytes of a message; longer ones Zenoh hands over in shared memory."""
NEW_SECONDS = 60.0
"""How long a socket at which nobody listens is left alone [s]."""
_LENGTHS = struct.Struct("<HHH")
Take = Callable[[str, str, bytes, Attachment], None]
"""Takes a message: its topic, the topic's type, its CDR bytes and what came with it."""


class Line:
    """To one other session; what it has no room for is dropped, as Zenoh does it."""

    def __init__(self, peer: socket.socket, paused: threading.Event) -> None:
        self._peer = peer
        self._paused = paused
        self._lock = threading.Lock()
        peer.settimeout(BUSY_SECONDS)

    def send(self, frame: bytes) -> bool:
        """Send a message, or drop it; False when the other session is gone."""
        with self._lock:
            try:
                if not self._paused.is_set() and self._peer.send(frame) < len(frame):
                    self.close()  # half a message is there: what follows could not be read
            except TimeoutError:
                pass
            except OSError:
                return False
        return True

    def close(self) -> None:
        """Hang up."""
        self._peer.close()


class DirectLines:
    """The lines of one session: `take` gets what comes in, `to` gives those by which others are reached."""

    def __init__(self, address: str, session: str, take: Take) -> None:
        self._address = address
        self._take = take
        self._lines: dict[str, Line | None] = {}
        self._paused = threading.Event()
        self._callers: list[socket.socket] = []
        self._path = self._path_of(session)
        _remove_dead_sockets()
        self._server = listen_at(self._path)
        threading.Thread(target=self._accept, name="coursekit-direct", daemon=True).start()

    def to(self, sessions: Iterable[str]) -> tuple[Line, ...]:
        """A line to each of these; none when one of them has to be reached by Zenoh."""
        lines = [self._line_to(one) for one in dict.fromkeys(sessions)]
        return tuple(line for line in lines if line is not None) if all(lines) else ()

    def pause(self, paused: bool) -> None:
        """Send nothing while the router is out of reach: who is told that nothing is sent must not see a robot move."""
        (self._paused.set if paused else self._paused.clear)()

    def keep(self, sessions: Collection[str]) -> None:
        """Only these are still there."""
        for gone in [one for one in self._lines if one not in sessions]:
            line = self._lines.pop(gone)
            if line is not None:
                line.close()

    def close(self) -> None:
        """Hang up, and listen no more."""
        self._path.unlink(missing_ok=True)
        for one in (self._server, *self._callers):
            with contextlib.suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)  # who waits for it wakes up
            one.close()
        self.keep(())

    def _path_of(self, session: str) -> Path:
        """Where a session listens that joined at this address: another one may lead over a worse link, on purpose."""
        return folder() / f"net-{hashlib.sha256(f'{self._address} {session}'.encode()).hexdigest()[:16]}"

    def _line_to(self, session: str) -> Line | None:
        if session not in self._lines:
            self._lines[session] = None
            path = self._path_of(session)
            with contextlib.suppress(NobodyListens, OSError):
                if path.exists():
                    self._lines[session] = Line(call(path), self._paused)
        return self._lines[session]

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                peer = accept(self._server, self._path)
                self._callers.append(peer)
                threading.Thread(target=self._hear, args=(peer,), name="coursekit-direct", daemon=True).start()

    def _hear(self, peer: socket.socket) -> None:
        with contextlib.suppress(OSError, ValueError, struct.error), peer, peer.makefile("rb") as stream:
            while head := stream.read(_LENGTHS.size):
                lengths = _LENGTHS.unpack(head)
                body = stream.read(SIZE + sum(lengths))
                self._take(*read_frame(body, lengths))
        self._callers.remove(peer)


def _remove_dead_sockets() -> None:
    """Remove what killed sessions have left; a new socket may belong to a session that is about to listen."""
    for path in folder().glob("net-*"):
        with contextlib.suppress(FileNotFoundError):
            if time.time() - path.stat().st_mtime < NEW_SECONDS:
                continue
            try:
                connect_at(path).close()
            except NobodyListens:
                path.unlink()


def frame(name: str, type_name: str, data: bytes, attachment: bytes) -> bytes:
    """A message as a line carries it."""
    parts = (name.encode(), type_name.encode(), data)
    return b"".join((_LENGTHS.pack(*map(len, parts)), attachment, *parts))


def read_frame(body: bytes, lengths: tuple[int, ...]) -> tuple[str, str, bytes, Attachment]:
    """What `frame` was given, from what follows its first six bytes; ValueError for what is none."""
    attachment = read_attachment(body[:SIZE])
    ends = [SIZE + sum(lengths[:k]) for k in range(4)]
    name, type_name, data = (body[begin:end] for begin, end in itertools.pairwise(ends))
    if len(body) != ends[-1]:
        raise ValueError("half a message")
    return name.decode(), type_name.decode(), data, attachment
