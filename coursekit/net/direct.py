"""Short messages go directly to sessions of the same user on this computer that joined at the same address.

The path of such a socket includes no router and no threads of Zenoh, so it takes half the time. Zenoh still announces
everything. It carries messages that are long, latched or never dropped, and all messages to other computers.
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

from .wire.attachment import SIZE, Attachment, read_attachment
from .zenoh_session import BUSY_SECONDS

LONGEST = 3072
"""Maximum size of a direct message in bytes; Zenoh passes longer ones in shared memory."""
NEW_SECONDS = 60.0
"""Minimum age at which a socket without a listener is removed [s]."""
SETTLE_SECONDS = 1.0
"""Maximum wait for a session to have taken all that was sent to it directly [s]."""
_LENGTHS = struct.Struct("<HHH")
_SETTLE = _LENGTHS.pack(0, 0, 0)
"""Asks the other session to answer with a byte; no message looks like this, as each has a name."""
Take = Callable[[str, str, bytes, Attachment], None]
"""Callback for a message: its topic, the topic's type, its CDR bytes and its attachment."""


class Line:
    """A connection to one other session; messages that do not fit into its buffer are dropped, as in Zenoh."""

    def __init__(self, peer: socket.socket, paused: threading.Event) -> None:
        self._peer = peer
        self._paused = paused
        self._lock = threading.Lock()
        peer.settimeout(BUSY_SECONDS)

    def send(self, frame: bytes) -> bool:
        """Send a message, or drop it; False when the other session has closed."""
        with self._lock:
            try:
                if not self._paused.is_set() and self._peer.send(frame) < len(frame):
                    self.close()  # half a message was sent: the rest of the stream would be unreadable
            except TimeoutError:
                pass
            except OSError:
                return False
        return True

    def settle(self) -> None:
        """Wait until the other session has taken all messages of this line; one that does not answer loses the line."""
        with self._lock, contextlib.suppress(OSError):
            self._peer.settimeout(SETTLE_SECONDS)
            try:
                self._peer.sendall(_SETTLE)
                self._peer.recv(1)
                self._peer.settimeout(BUSY_SECONDS)
            except TimeoutError:
                self.close()

    def close(self) -> None:
        """Close the connection."""
        self._peer.close()


class DirectLines:
    """The direct connections of one session: `take` receives incoming messages, `to` returns the lines to other sessions."""

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
        """Return a line to each of these sessions; none when one of them can only be reached through Zenoh."""
        lines = [self._line_to(session) for session in dict.fromkeys(sessions)]
        return tuple(line for line in lines if line is not None) if all(lines) else ()

    def pause(self, paused: bool) -> None:
        """Pause while the router is unreachable: a user who was told that nothing is sent must not see a robot move."""
        (self._paused.set if paused else self._paused.clear)()

    def keep(self, sessions: Collection[str]) -> None:
        """Close the lines to all other sessions: they are gone."""
        for gone in [session for session in self._lines if session not in sessions]:
            line = self._lines.pop(gone)
            if line is not None:
                line.close()

    def close(self) -> None:
        """Close all connections and stop listening."""
        self._path.unlink(missing_ok=True)
        for caller in (self._server, *self._callers):
            with contextlib.suppress(OSError):
                caller.shutdown(socket.SHUT_RDWR)  # wakes threads that wait on the socket
            caller.close()
        self.keep(())

    def _path_of(self, session: str) -> Path:
        """Return the socket path of a session at this address: another address may use a worse link on purpose."""
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
                if head == _SETTLE:
                    peer.sendall(b"+")
                    continue
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
    """Encode a message for a line: three lengths, the attachment, topic, type and data.

    >>> whole = frame("/chatter", "std_msgs/msg/String", b"data", Attachment(1, 2, bytes(16)).data())
    >>> read_frame(whole[_LENGTHS.size :], _LENGTHS.unpack(whole[: _LENGTHS.size]))[:3]
    ('/chatter', 'std_msgs/msg/String', b'data')
    """
    parts = (name.encode(), type_name.encode(), data)
    return b"".join((_LENGTHS.pack(*map(len, parts)), attachment, *parts))


def read_frame(body: bytes, lengths: tuple[int, ...]) -> tuple[str, str, bytes, Attachment]:
    """Decode a message of `frame` from the part after its first six bytes; ValueError when it is incomplete.

    >>> whole = frame("/chatter", "std_msgs/msg/String", b"data", Attachment(1, 2, bytes(16)).data())
    >>> read_frame(whole[_LENGTHS.size : -1], _LENGTHS.unpack(whole[: _LENGTHS.size]))
    Traceback (most recent call last):
    ValueError: half a message
    """
    attachment = read_attachment(body[:SIZE])
    ends = [SIZE + sum(lengths[:k]) for k in range(4)]
    name, type_name, data = (body[begin:end] for begin, end in itertools.pairwise(ends))
    if len(body) != ends[-1]:
        raise ValueError("half a message")
    return name.decode(), type_name.decode(), data, attachment
