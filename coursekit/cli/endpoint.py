"""The sockets at which sessions accept `ros2` commands of the same user, in a folder that only this user can open.

Each session has its own Unix socket, `session-DOMAIN-PID`; the link `session-DOMAIN` points to the one that owns the
terminals. Without Unix sockets these are files with a loopback port and a token.
"""

from __future__ import annotations

import contextlib
import json
import os
import socket
from pathlib import Path

from coursekit.files import put_in_place
from coursekit.systems import rights, user_socket
from coursekit.systems.runtime_folder import folder
from coursekit.systems.user_socket import NobodyListens as NoSession
from coursekit.systems.user_socket import connect_at, listen_at, token_at


def address(domain_id: int) -> Path:
    """Return the address of the session that owns the domain's terminals."""
    return folder() / f"session-{domain_id}"


def own_address(domain_id: int) -> Path:
    """Return the address of this process."""
    return folder() / f"session-{domain_id}-{os.getpid()}"


def listen(domain_id: int, *, take: bool = False) -> socket.socket:
    """Listen for the domain; OSError when another session owns its terminals, unless `take` takes them over."""
    if not take:
        with contextlib.suppress(NoSession):
            connect(domain_id).close()
            raise OSError(f"another session listens for ROS_DOMAIN_ID={domain_id}")
    server = listen_at(own_address(domain_id))
    claim(domain_id)
    return server


def claim(domain_id: int) -> bool:
    """Take over the domain's terminals. Returns whether that is a change."""
    if has_terminals(domain_id):
        return False
    own = own_address(domain_id)
    os.utime(own)  # if this link is gone, the newest session is asked first
    _lead_to(own, domain_id)
    return True


def has_terminals(domain_id: int) -> bool:
    """Whether new commands of the domain's terminals go to this process."""
    current, own = address(domain_id), own_address(domain_id)
    with contextlib.suppress(OSError):
        if user_socket.HAS_UNIX:
            return os.readlink(current) == own.name
        return user_socket.said_at(current) == user_socket.said_at(own)
    return False


def _lead_to(own: Path, domain_id: int) -> None:
    fresh = own.with_name(f"{own.name}.{os.getpid()}.new")  # terminals and the session itself may do this at once
    fresh.unlink(missing_ok=True)
    if user_socket.HAS_UNIX:
        fresh.symlink_to(own.name)
    else:
        rights.write_text(fresh, json.dumps(user_socket.said_at(own)))
    put_in_place(fresh, address(domain_id))


def token(domain_id: int) -> str:
    """Return the token that a client sends first on a loopback port; empty for Unix sockets. NoSession if it has gone."""
    try:
        return token_at(address(domain_id))
    except NoSession as error:
        raise NoSession(f"no session listens for ROS_DOMAIN_ID={domain_id}") from error


def connect(domain_id: int) -> socket.socket:
    """Connect to the session that owns the domain's terminals, or if it is gone, to another one. Raises NoSession."""
    with contextlib.suppress(NoSession):
        return connect_at(address(domain_id))
    for path in sessions(domain_id):
        with contextlib.suppress(NoSession, OSError):
            client = connect_at(path)
            with contextlib.suppress(OSError):
                _lead_to(path, domain_id)
            return client
    raise NoSession(f"no session listens for ROS_DOMAIN_ID={domain_id}")


def sessions(domain_id: int) -> list[Path]:
    """Return the addresses of the domain's sessions, the newest first; some may be stale."""
    sockets = [socket for socket in folder().glob(f"session-{domain_id}-*") if socket.name.rpartition("-")[2].isdecimal()]
    return sorted(sockets, key=lambda path: path.lstat().st_mtime_ns, reverse=True)


def live_sessions(domain_id: int) -> int:
    """Count the domain's sessions that answer; stale addresses are removed."""
    count = 0
    for path in sessions(domain_id):
        try:
            connect_at(path).close()
            count += 1
        except NoSession:
            path.unlink(missing_ok=True)
    return count


def close(server: socket.socket, domain_id: int) -> None:
    """Stop listening."""
    if has_terminals(domain_id):
        address(domain_id).unlink(missing_ok=True)
    server.close()
    own_address(domain_id).unlink(missing_ok=True)
