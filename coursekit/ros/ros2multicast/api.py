"""Multicast datagrams, to test whether the network lets them through."""

from __future__ import annotations

import socket
import struct

DEFAULT_GROUP = "225.0.0.1"
DEFAULT_PORT = 49150
_LONGEST = 4096


def send(data: bytes, *, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, ttl: int | None = None) -> None:
    """Send one datagram; `ttl` is the number of networks that it may cross."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP) as sender:
        if ttl is not None:
            sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, struct.pack("b", ttl))
        sender.sendto(data, (group, port))


def join(receiver: socket.socket, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT) -> bytes:
    """Subscribe a socket to the group's datagrams. Return the membership, with which it can leave the group."""
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    receiver.bind(("", port))
    member = struct.pack("4sl", socket.inet_aton(group), socket.INADDR_ANY)
    receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, member)
    return member


def receive(
    *, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, timeout: float | None = None
) -> tuple[bytes, tuple[str, int]]:
    """Wait for one datagram. Return it and its sender. Raises TimeoutError after `timeout` seconds."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP) as receiver:
        receiver.settimeout(timeout)
        member = join(receiver, group, port)
        try:
            return receiver.recvfrom(_LONGEST)
        finally:
            receiver.setsockopt(socket.IPPROTO_IP, socket.IP_DROP_MEMBERSHIP, member)
