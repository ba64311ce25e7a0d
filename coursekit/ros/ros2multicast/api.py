"""Datagrams to everybody on the network that listens: to see whether it lets them through."""

from __future__ import annotations

import socket
import struct

DEFAULT_GROUP = "225.0.0.1"
DEFAULT_PORT = 49150
_LONGEST = 4096


def send(data: bytes, *, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, ttl: int | None = None) -> None:
    """Send one datagram; `ttl` is how many networks it may cross."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP) as sender:
        if ttl is not None:
            sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, struct.pack("b", ttl))
        sender.sendto(data, (group, port))


def join(receiver: socket.socket, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT) -> bytes:
    """Have a socket receive the group's datagrams; the membership, by which it can leave."""
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    receiver.bind(("", port))
    member = struct.pack("4sl", socket.inet_aton(group), socket.INADDR_ANY)
    receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, member)
    return member


def receive(
    *, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, timeout: float | None = None
) -> tuple[bytes, tuple[str, int]]:
    """Wait for one datagram; it and its sender. TimeoutError after `timeout` seconds."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP) as receiver:
        receiver.settimeout(timeout)
        member = join(receiver, group, port)
        try:
            return receiver.recvfrom(_LONGEST)
        finally:
            receiver.setsockopt(socket.IPPROTO_IP, socket.IP_DROP_MEMBERSHIP, member)
