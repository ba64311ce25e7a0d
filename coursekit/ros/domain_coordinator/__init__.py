"""ROS domains for tests that run side by side: each gets one that no other has."""

from __future__ import annotations

import contextlib
import socket
from collections.abc import Iterator

DOMAINS = range(1, 101)
_PORT = 22119
"""A domain is taken by who listens on this port plus its number."""


class CoordinatedDomainID(int):
    """A domain that is one's own for as long as this number is kept."""

    _held: socket.socket

    def __repr__(self) -> str:
        return str(int(self))

    __str__ = __repr__


def get_coordinated_domain_id() -> CoordinatedDomainID:
    """A domain that nobody else on this computer has taken so; keep it while it is used. RuntimeError when all are taken.

    >>> one, other = get_coordinated_domain_id(), get_coordinated_domain_id()
    >>> one != other
    True
    """
    for number in DOMAINS:
        held = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        try:
            held.bind(("127.0.0.1", _PORT + number))
        except OSError:
            held.close()
            continue
        domain = CoordinatedDomainID(number)
        domain._held = held
        return domain
    raise RuntimeError(f"All domains from {DOMAINS[0]} to {DOMAINS[-1]} are taken: end a test that still runs")


@contextlib.contextmanager
def domain_id() -> Iterator[int]:
    """`with domain_id() as number:`, the same for a block (later releases)."""
    domain = get_coordinated_domain_id()
    try:
        yield int(domain)
    finally:
        domain._held.close()
