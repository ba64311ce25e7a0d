"""The connection to one thread of a compiled program, and the execution context that represents the thread."""

from __future__ import annotations

import socket
import struct
from typing import TYPE_CHECKING

from coursekit.core.execution_context import CallbackAbandoned
from coursekit.nodes.compiled.frames import FrameError, Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.host import Host

_LIMIT = 1 << 30
"""The maximum size of a frame [bytes]: no message is larger, and a false length must not use all memory."""


class Gone(CallbackAbandoned):
    """The thread, or its whole program, has ended."""


class CallbackFailed(CallbackAbandoned):
    """A callback threw an exception: the program has abandoned the request during which it was called."""


class Channel:
    """While the thread computes, the execution context waits here, so nothing else happens on the virtual clock."""

    def __init__(self, host: Host, connection: socket.socket) -> None:
        self._host = host
        self._connection = connection
        self._buffer = bytearray()
        self.ended = host.clock.new_event()

    def serve(self) -> None:
        """Represent the thread until it ends."""
        host = self._host
        host.of_context[host.session.execution_context()] = self
        try:
            self._send(b"A")  # permits it to start
            self._serve_until_return()
        except Gone:
            pass
        finally:
            host.of_context.pop(host.session.execution_context(), None)
            host.output.drain()  # its last output precedes that of others
            self.close()
            self.ended.set()

    def begin_worker(self) -> None:
        """Start a thread requested by the session: from now on it only waits for calls."""
        self._send(b"A")

    def call(self, handler: int, data: bytes = b"") -> Unpacker:
        """Run a callback in the thread and return its result. Raises CallbackFailed, Gone."""
        self._send(b"C", packed(handler) + data)
        return self._serve_until_return()

    def close(self) -> None:
        """Close the connection, which ends a thread that waits for calls."""
        self._connection.close()

    def _serve_until_return(self) -> Unpacker:
        """Carry out the thread's requests until it reports that a callback has returned."""
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
                continue  # the request was abandoned with an exception
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
    """Return the request's name; Gone for anything else, which a working program never sends."""
    try:
        if kind in (b"Q", b"N"):
            return frame.text()
    except FrameError:
        pass
    raise Gone
