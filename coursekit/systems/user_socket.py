"""Sockets for this user's connections only: Unix sockets, else a loopback port with a token that only this user can read."""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import socket
from pathlib import Path
from typing import Any

from . import operating_system, rights

HAS_UNIX = hasattr(socket, "AF_UNIX") and not operating_system.WINDOWS
CONNECT_SECONDS = 5.0
TOKEN_SECONDS = 2.0
"""Timeout for a caller's token on a loopback port [s]."""


class NobodyListens(ConnectionError):
    """No program listens at the file."""


def listen_at(path: Path) -> socket.socket:
    """Listen at a Unix socket file, or a loopback port with number and token in the file; only this user can read it."""
    path.unlink(missing_ok=True)
    if HAS_UNIX:
        server = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        with contextlib.suppress(OSError):
            os.fchmod(server.fileno(), 0o600)  # Linux creates the file with this mode; elsewhere its folder protects it
        server.bind(str(path))
        path.chmod(0o600)
    else:
        server = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        server.bind(("127.0.0.1", 0))
        rights.write_text(path, json.dumps({"port": server.getsockname()[1], "token": secrets.token_hex(16)}))
    server.listen(16)
    return server


def connect_at(path: Path) -> socket.socket:
    """Connect to the program that listens at a file. Raises NobodyListens."""
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
    """Return the token for the loopback port in a file; empty for Unix sockets. Raises NobodyListens."""
    if HAS_UNIX:
        return ""
    try:
        return str(said_at(path)["token"])
    except (OSError, ValueError, KeyError) as error:
        raise NobodyListens(f"nobody listens at {path}") from error


def said_at(path: Path) -> dict[str, Any]:
    """Return the port and the token in the file, on systems without Unix sockets."""
    return dict(json.loads(path.read_text(encoding="utf-8")))


def call(path: Path) -> socket.socket:
    """Connect to the program that listens at a file, and send the token. Raises NobodyListens."""
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
    """Return the next caller that sends the file's token, if there is one; OSError when the server is closed."""
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
