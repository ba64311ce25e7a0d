"""At which sockets a program of this computer can be called, as Linux tells."""

import os
from typing import Any

LOOPBACK = "0100007F"
"""127.0.0.1, as the list of sockets writes it."""


def listening(pid: Any = "self") -> set[tuple[str, str, int]]:
    """The kinds, addresses and ports of a program's sockets at which others can call, or send to."""
    links = [f"/proc/{pid}/fd/{fd}" for fd in os.listdir(f"/proc/{pid}/fd")]
    its = {os.readlink(link) for link in links if os.path.islink(link)}
    sockets = set()
    for kind in ("tcp", "tcp6", "udp", "udp6"):
        with open(f"/proc/net/{kind}", encoding="ascii") as table:
            rows = [line.split() for line in list(table)[1:]]
        states = ("0A",) if kind.startswith("tcp") else ("07",)
        for row in rows:
            if row[3] in states and f"socket:[{row[9]}]" in its:
                address, _, port = row[1].rpartition(":")
                sockets.add((kind, address, int(port, 16)))
    return sockets
