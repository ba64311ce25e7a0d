"""Where a session listens for `ros2` commands of the same user: a Unix socket in a folder only they can open.

Where there are no Unix sockets, a loopback port whose number and token stand in such a folder.
"""

from __future__ import annotations

import json
import os
import secrets
import socket
import stat
import tempfile
from pathlib import Path

HAS_UNIX = hasattr(socket, "AF_UNIX")


class NoSession(ConnectionError):
    """Nobody listens."""


def folder() -> Path:
    """The user's own folder for sockets; made on first use, refused if somebody else could open it."""
    base = os.environ.get("COURSEKIT_RUNTIME_DIR") or os.environ.get("XDG_RUNTIME_DIR")
    user = str(os.getuid()) if hasattr(os, "getuid") else os.environ.get("USERNAME", "user")
    path = Path(base) / "coursekit" if base else Path(tempfile.gettempdir()) / f"coursekit-{user}"
    path.mkdir(mode=0o700, parents=True, exist_ok=True)
    if hasattr(os, "getuid"):
        status = path.lstat()
        if status.st_uid != os.getuid() or stat.S_IMODE(status.st_mode) & 0o077 or path.is_symlink():
            raise PermissionError(
                f"'{path}' can be opened by others, so it is not safe for a session to listen there. "
                f"Remove it, or run: chmod 700 '{path}'"
            )
    return path


def address(domain_id: int) -> Path:
    """The file at which the session of a domain is found."""
    return folder() / f"session-{domain_id}"


def listen(domain_id: int) -> socket.socket:
    """Listen for the domain; raises OSError when another session does."""
    path = address(domain_id)
    if path.exists():
        try:
            connect(domain_id).close()
        except NoSession:
            path.unlink(missing_ok=True)
        else:
            raise OSError(f"another session listens for ROS_DOMAIN_ID={domain_id}")
    if HAS_UNIX:
        server = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        server.bind(str(path))
        path.chmod(0o600)
    else:
        server = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        server.bind(("127.0.0.1", 0))
        path.write_text(json.dumps({"port": server.getsockname()[1], "token": secrets.token_hex(16)}))
    server.listen(16)
    return server


def token(domain_id: int) -> str:
    """What a client on a loopback port has to say first; empty for Unix sockets."""
    return "" if HAS_UNIX else str(json.loads(address(domain_id).read_text())["token"])


def connect(domain_id: int) -> socket.socket:
    """Connect to the session of a domain; raises NoSession."""
    path = address(domain_id)
    try:
        if HAS_UNIX:
            client = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            client.connect(str(path))
        else:
            client = socket.create_connection(("127.0.0.1", json.loads(path.read_text())["port"]), timeout=5)
    except (OSError, ValueError, KeyError) as error:
        raise NoSession(f"no session listens for ROS_DOMAIN_ID={domain_id}") from error
    return client


def close(server: socket.socket, domain_id: int) -> None:
    """Stop listening."""
    server.close()
    address(domain_id).unlink(missing_ok=True)
