"""Addresses: how they are typed, and whether somebody listens there."""

from __future__ import annotations

import re
import socket
from typing import Any

from .errors import NoNetwork

PORT = 7447
"""Where routers listen if nothing else is said: rmw_zenoh's as well."""
_SPELLED = re.compile(r"(?:(tcp|tls)/)?(\[[0-9a-fA-F:.%\w]+\]|[\w.-]+)(?::(\d{1,5}))?", re.ASCII)


def read_address(text: str) -> str:
    """The whole address of what was typed.

    Raises:
        NoNetwork: for what is none.

    >>> read_address("robot"), read_address("tls/10.0.0.2:7000")
    ('tcp/robot:7447', 'tls/10.0.0.2:7000')
    """
    found = _SPELLED.fullmatch(text.strip())
    if found is None or int(found[3] or PORT) > 65535:
        raise NoNetwork(f"'{text}' is no address. Write the robot's name or number, and its port: %network tcp/robot:{PORT}")
    return f"{found[1] or 'tcp'}/{found[2]}:{found[3] or PORT}"


def host_and_port(address: str) -> tuple[str, int]:
    """Both of a whole address.

    >>> host_and_port("tcp/[::1]:7447")
    ('::1', 7447)
    """
    host, _, port = address.partition("/")[2].rpartition(":")
    return host.strip("[]"), int(port)


def find_computer(address: str) -> tuple[int, tuple[Any, ...]]:
    """The family and the place, as sockets want them, of the computer in a whole address; NoNetwork when there is none."""
    host, port = host_and_port(address)
    try:
        family, _, _, _, place = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    except socket.gaierror:
        raise _no_computer(host, port) from None
    return family, place


def knock(address: str, seconds: float) -> None:
    """Look whether anybody listens there; NoNetwork says what is wrong."""
    host, port = host_and_port(address)
    try:
        socket.create_connection((host, port), timeout=seconds).close()
    except socket.gaierror:
        raise _no_computer(host, port) from None
    except TimeoutError:
        raise NoNetwork(
            f"{host} does not answer within {seconds:g} s. Is it on, and in the same network as this computer?"
        ) from None
    except OSError as error:
        raise NoNetwork(
            f"Nobody listens at {address} ({error.strerror or error}). Start the router there: coursekit network serve, "
            "the gateway on the robot, or ros2 run rmw_zenoh_cpp rmw_zenohd."
        ) from None


def _no_computer(host: str, port: int) -> NoNetwork:
    return NoNetwork(
        f"There is no computer '{host}' on this network. Its number works, too: %network tcp/192.168.1.20:{port}"
    )


def is_loopback(address: str) -> bool:
    """Whether only this computer is meant.

    >>> is_loopback("tcp/127.0.0.1:7447"), is_loopback("tcp/0.0.0.0:7447")
    (True, False)
    """
    host = host_and_port(address)[0]
    return host in ("localhost", "::1") or host.startswith("127.")
