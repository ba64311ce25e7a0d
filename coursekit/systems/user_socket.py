"""Sockets that only this user can call: Unix sockets, else a loopback port whose token only this user can read."""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import socket
from pathlib import Path
from typing import Any

from . import rights, which

HAS_UNIX = hasattr(socket, "AF_UNIX") and not which.WINDOWS
CONNECT_SECONDS = 5.0
TOKEN_SECONDS = 2.0
"""How long a caller on a loopback port may take to say its token [s]."""


class NobodyListens(ConnectionError):
    """Nobody listens at the file."""


def listen_at(path: Path) -> socket.socket:
    """Listen at a file, or at a loopback port that it names with a token; only this user can read it."""
    path.unlink(missing_ok=True)
    if HAS_UNIX:
        server = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        with contextlib.suppress(OSError):
            os.fchmod(server.fileno(), 0o600)  # so Linux makes it; elsewhere it is the folder that nobody can enter
        server.bind(str(path))
        path.chmod(0o600)
    else:
        server = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        server.bind(("127.0.0.1", 0))
        rights.write_text(path, json.dumps({"port": server.getsockname()[1], "token": secrets.token_hex(16)}))
    server.listen(16)
    return server


def connect_at(path: Path) -> socket.socket:
    """Connect to who listens at a file. Raises NobodyListens."""
    try:
        if HAS_UNIX:
            client = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            client.connect(str(path))
        else:
            client = socket.create_connection(("127.0.0.1", said_at(path)["port"]), timeout=CONNECT_SECONDS)
    except (OSError, ValueError, KeyError) as error:
        raise NobodyListens(f"no session listens at {path}") from error
    return client


def token_at(path: Path) -> str:
    """The first word to the loopback port that a file names; empty for Unix sockets. Raises NobodyListens."""
    if HAS_UNIX:
        return ""
    try:
        return str(said_at(path)["token"])
    except (OSError, ValueError, KeyError) as error:
        raise NobodyListens(f"nobody listens at {path}") from error


def said_at(path: Path) -> dict[str, Any]:
    """Where there are no Unix sockets: the port and the token that the file holds."""
    return dict(json.loads(path.read_text(encoding="utf-8")))


def call(path: Path) -> socket.socket:
    """Connect to who listens at a file and say the token. Raises NobodyListens."""
    token = token_at(path).encode()
    peer = connect_at(path)
    try:
        peer.sendall(token)
    except OSError as error:
        peer.close()
        raise NobodyListens(f"nobody listens at {path}") from error
    peer.settimeout(None)
    return peer


def accept(server: socket.socket, path: Path) -> socket.socket:
    """The next caller that says the token of the file, where there is one; OSError when the server is closed."""
    token = token_at(path).encode()
    while True:
        peer, _ = server.accept()
        if _says(peer, token):
            peer.settimeout(None)
            return peer
        peer.close()


def _says(peer: socket.socket, token: bytes) -> bool:
    said = b""
    with contextlib.suppress(OSError):
        peer.settimeout(TOKEN_SECONDS)
        while len(said) < len(token) and (part := peer.recv(len(token) - len(said))):
            said += part
    return secrets.compare_digest(said, token)
