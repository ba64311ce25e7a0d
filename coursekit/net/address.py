"""Network addresses: parsing them, and checking whether a router listens there."""

from __future__ import annotations

import re
import socket
from typing import Any

from .errors import NoNetwork

PORT = 7447
"""The default port of routers, also in rmw_zenoh."""
_SPELLED = re.compile(r"(?:(tcp|tls)/)?(\[[0-9a-fA-F:.%\w]+\]|[\w.-]+)(?::(\d{1,5}))?", re.ASCII)


def read_address(text: str) -> str:
    """Complete an address as typed by the user.

    Raises:
        NoNetwork: for an invalid address.

    >>> read_address("robot"), read_address("tls/10.0.0.2:7000")
    ('tcp/robot:7447', 'tls/10.0.0.2:7000')
    """
    match = _SPELLED.fullmatch(text.strip())
    if match is None or int(match[3] or PORT) > 65535:
        raise NoNetwork(f"'{text}' is no address. Write the robot's name or number, and its port: %network tcp/robot:{PORT}")
    return f"{match[1] or 'tcp'}/{match[2]}:{match[3] or PORT}"


def host_and_port(address: str) -> tuple[str, int]:
    """Split a complete address into host and port.

    >>> host_and_port("tcp/[::1]:7447")
    ('::1', 7447)
    """
    host, _, port = address.partition("/")[2].rpartition(":")
    return host.strip("[]"), int(port)


def find_computer(address: str) -> tuple[int, tuple[Any, ...]]:
    """Return the socket family and socket address of a complete address; NoNetwork when the host is unknown."""
    host, port = host_and_port(address)
    try:
        family, _, _, _, place = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    except socket.gaierror:
        raise _no_computer(host, port) from None
    return family, place


def knock(address: str, seconds: float) -> None:
    """Check that the address accepts connections; NoNetwork gives the reason when it does not."""
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
    """Whether the address refers to this computer only.

    >>> is_loopback("tcp/127.0.0.1:7447"), is_loopback("tcp/0.0.0.0:7447")
    (True, False)
    """
    host = host_and_port(address)[0]
    return host in ("localhost", "::1") or host.startswith("127.")
