"""TCP ports of this computer."""

from __future__ import annotations

import socket


def free_port() -> int:
    """Return a loopback port that is currently unused.

    >>> 0 < free_port() < 65536
    True
    """
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
    return port


__all__ = ["free_port"]
