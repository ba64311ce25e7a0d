"""The start-up message of a router."""

from __future__ import annotations

import socket


def welcome(addresses: list[str], users: int) -> list[str]:
    """Return the commands that join a router at these addresses, and warnings about its risks.

    >>> welcome(["tcp/127.0.0.1:7447"], 0)
    ['The router listens. Notebooks join it with: %network tcp/127.0.0.1:7447', 'Ctrl-C ends it.']
    """
    from coursekit.net.address import is_loopback

    asks = " --user NAME" if users else ""
    lines = [f"The router listens. Notebooks join it with: %network {_reachable(address)}{asks}" for address in addresses]
    if not users and not all(map(is_loopback, addresses)):
        lines.append("Anybody in the network can join, and drive the robots that do. To ask for a password: --users FILE")
    if users and not all(address.startswith("tls/") or is_loopback(address) for address in addresses):
        lines.append("Passwords and messages can be read on the way. To encrypt them: tls/ADDRESS, --certificate and --key")
    return [*lines, "Ctrl-C ends it."]


def _reachable(address: str) -> str:
    """Return the address for other computers: with this computer's name if it listens on all interfaces."""
    for everywhere in ("/0.0.0.0:", "/[::]:"):
        address = address.replace(everywhere, f"/{socket.gethostname()}:")
    return address


__all__ = ["welcome"]
