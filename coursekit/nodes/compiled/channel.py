"""The connection of one thread of a compiled program, and the execution context that stands for that thread."""

from __future__ import annotations

import socket
import struct
from typing import TYPE_CHECKING

from coursekit.nodes.compiled.frames import FrameError, Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.host import Host

_LIMIT = 1 << 30
"""Bytes of the largest frame: no message is larger, and a false length must not take all memory."""


class Gone(Exception):
    """The thread, or its whole program, has ended."""


class CallbackFailed(Exception):
    """A callback threw: the program has left the question during which it was called."""


class Channel:
    """While the thread computes the execution context waits here, so on the virtual clock nothing else happens."""

    def __init__(self, host: Host, connection: socket.socket) -> None:
        self._host = host
        self._connection = connection
        self._buffer = bytearray()
        self.ended = host.clock.new_event()

    def serve(self) -> None:
        """Stand for the thread until it ends."""
        host = self._host
        host.of_context[host.session.execution_context()] = self
        try:
            self._send(b"A")  # it may begin
            self._serve_until_return()
        except Gone:
            pass
        finally:
            host.of_context.pop(host.session.execution_context(), None)
            host.output.drain()  # what it has written last comes before what others write now
            self.close()
            self.ended.set()

    def begin_worker(self) -> None:
        """Let a thread that the session asked for begin: from now on it only waits for calls."""
        self._send(b"A")

    def call(self, handler: int, data: bytes = b"") -> Unpacker:
        """Have the thread run a callback; what it returns. Raises CallbackFailed, Gone."""
        self._send(b"C", packed(handler) + data)
        return self._serve_until_return()

    def close(self) -> None:
        """End the connection, and with it a thread that waits for calls."""
        self._connection.close()

    def _serve_until_return(self) -> Unpacker:
        """Carry out what the thread asks, until it says that a callback has returned."""
        while True:
            kind, frame = self._receive()
            if kind == b"R":
                return frame
            if kind == b"E":
                raise CallbackFailed
            name = _name(kind, frame)
            try:
                answer = self._host.carry_out(self, name, frame)
            except CallbackFailed:
                continue  # the question was left with an exception
            except Gone:
                raise
            except Exception as error:
                if kind == b"Q":
                    self._send(b"X", packed(*self._host.refusal(error)))
                continue
            if kind == b"Q":
                self._send(b"A", answer)

    def _send(self, kind: bytes, body: bytes = b"") -> None:
        clock = self._host.clock
        head = struct.pack("<qqq", clock.now(), clock.steady(), self._host.flags)
        try:
            self._connection.sendall(struct.pack("<I", 25 + len(body)) + kind + head + body)
        except OSError:
            raise Gone from None

    def _receive(self) -> tuple[bytes, Unpacker]:
        size = struct.unpack("<I", self._exactly(4))[0]
        if not 0 < size < _LIMIT:
            raise Gone
        data = self._exactly(size)
        self._host.output.drain()
        return data[:1], Unpacker(data, 1)

    def _exactly(self, size: int) -> bytes:
        buffer = self._buffer
        while len(buffer) < size:
            if self._host.clock.virtual:
                self._host.wait_for(self._connection)
            try:
                part = self._connection.recv(262_144)
            except OSError:
                part = b""
            if not part:
                raise Gone
            buffer += part
        data = bytes(buffer[:size])
        del buffer[:size]
        return data


def _name(kind: bytes, frame: Unpacker) -> str:
    """The question; Gone for anything else: such a program does not know what it says any more."""
    try:
        if kind in (b"Q", b"N"):
            return frame.text()
    except FrameError:
        pass
    raise Gone
