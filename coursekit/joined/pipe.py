"""The frames between two interpreters: a JSON header and the CDR bytes of messages, over two file descriptors
or a socket.

Nothing is unpickled, and every size is checked before its data is read: the other side may be hostile.
"""

from __future__ import annotations

import json
import os
import socket
import struct
import time
from typing import Any

from coursekit.systems.pipes import readable, wait_readable

_LENGTHS = struct.Struct("<II")
HEADER, BODY = 16 << 20, 256 << 20
"""Maximum size of header and body [bytes]."""
LATE = "it did not answer in time"
"""The reason in Broken when the other side does not yield."""
_now = time.monotonic  # the real one: in a process, time.monotonic() is the session's
_dumps, _loads = json.dumps, json.loads  # saved before any program can replace them


class Broken(Exception):
    """The other side ended, did not answer in time, or sent malformed data."""


class Pipe:
    """One end of the connection.

    >>> there, back = os.pipe(), os.pipe()
    >>> ours, theirs = Pipe(back[0], there[1]), Pipe(there[0], back[1])
    >>> ours.send({"now": 5}, b"cdr"); theirs.receive()
    ({'now': 5}, b'cdr')
    """

    def __init__(self, read: int, write: int) -> None:
        self._read = read
        self._write = write

    def send(self, header: dict[str, Any], body: bytes = b"") -> None:
        """Send one frame; Broken when the other side is gone."""
        text = _dumps(header, separators=(",", ":")).encode()
        data = memoryview(_LENGTHS.pack(len(text), len(body)) + text + body)
        try:
            while data:
                data = data[self._put(data[: 1 << 20]) :]
        except OSError:
            raise Broken("it ended") from None

    def receive(self, seconds: float | None = None) -> tuple[dict[str, Any], bytes]:
        """Return the next frame; Broken when there is none within so many real seconds, or it is malformed."""
        give_up = None if seconds is None else _now() + seconds
        header, body = _LENGTHS.unpack(self._exactly(_LENGTHS.size, give_up))
        if header > HEADER or body > BODY:
            raise Broken("it sent more than it may")
        try:
            fields = _loads(self._exactly(header, give_up))
        except (ValueError, RecursionError):
            raise Broken("it sent something malformed") from None
        if not isinstance(fields, dict):
            raise Broken("it sent something malformed")
        return fields, self._exactly(body, give_up)

    def _exactly(self, size: int, give_up: float | None) -> bytes:
        parts = bytearray()
        while len(parts) < size:
            if give_up is not None and not self._comes(give_up - _now()):
                raise Broken(LATE)
            part = self._take(min(1 << 20, size - len(parts)))
            if not part:
                raise Broken("it ended")
            parts += part
        return bytes(parts)

    def _put(self, data: memoryview) -> int:
        return os.write(self._write, data)

    def _take(self, size: int) -> bytes:
        return os.read(self._read, size)

    def _comes(self, seconds: float) -> bool:
        return readable(self._read, seconds)


class SocketPipe(Pipe):
    """One end of a socket, which is not a file descriptor on Windows."""

    def __init__(self, peer: socket.socket) -> None:
        self._peer = peer

    def _put(self, data: memoryview) -> int:
        return self._peer.send(data)

    def _take(self, size: int) -> bytes:
        return self._peer.recv(size)

    def _comes(self, seconds: float) -> bool:
        return bool(wait_readable([self._peer], max(0.0, seconds)))
