"""The address to which a compiled program's threads connect: a Unix socket, or on Windows a loopback port with a token."""

from __future__ import annotations

import contextlib
import hmac
import os
import secrets
import socket
import tempfile

from coursekit.systems import operating_system

_WAITING = 64
_TOKEN_S = 5.0
"""The timeout for a new connection to send the token [s, real time]."""


class UnixListener:
    """A socket in a folder that only this user can enter."""

    def __init__(self) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="coursekit-")
        self.address = os.path.join(self._folder.name, "link")
        self.listening = socket.socket(socket.AF_UNIX)
        self.listening.bind(self.address)
        self.listening.listen(_WAITING)

    def accept(self) -> socket.socket:
        """Return the next connection; OSError when closed."""
        return self.listening.accept()[0]

    def close(self) -> None:
        """Accept no more connections, and end a waiting `accept`."""
        with contextlib.suppress(OSError):
            self.listening.shutdown(socket.SHUT_RDWR)
        self.listening.close()
        self._folder.cleanup()


class LoopbackListener:
    """A port of this computer: a connection must first send the token."""

    def __init__(self) -> None:
        self._token = secrets.token_hex(16).encode()
        self._open = True
        self.listening = socket.create_server(("127.0.0.1", 0), backlog=_WAITING)
        self.address = f"{self.listening.getsockname()[1]}:{self._token.decode()}"

    def accept(self) -> socket.socket:
        """Return the next connection with the token; OSError when closed."""
        while True:
            connection, _ = self.listening.accept()
            if not self._open:
                connection.close()
                raise OSError("the program has ended")
            if self._knows_token(connection):
                connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                return connection
            connection.close()

    def close(self) -> None:
        """Accept no more connections, and end a waiting `accept`."""
        self._open = False
        with contextlib.suppress(OSError), socket.create_connection(self.listening.getsockname(), timeout=_TOKEN_S):
            pass  # on Windows only this ends an `accept` in another thread
        self.listening.close()

    def _knows_token(self, connection: socket.socket) -> bool:
        connection.settimeout(_TOKEN_S)
        said = b""
        with contextlib.suppress(OSError):
            while len(said) < len(self._token) and (part := connection.recv(len(self._token) - len(said))):
                said += part
        connection.settimeout(None)
        return hmac.compare_digest(said, self._token)


def open_listener() -> UnixListener | LoopbackListener:
    """Return the kind of listener that this system and its compiled programs support."""
    return LoopbackListener() if operating_system.WINDOWS else UnixListener()
