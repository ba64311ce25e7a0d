"""ROS domains for tests that run in parallel: each test gets a domain of its own."""

from __future__ import annotations

import contextlib
import socket
from collections.abc import Iterator

DOMAINS = range(1, 101)
_PORT = 22119
"""A process takes a domain by binding this port plus the domain's number."""


class CoordinatedDomainID(int):
    """A domain that stays reserved as long as this object exists."""

    _held: socket.socket

    def __repr__(self) -> str:
        return str(int(self))

    __str__ = __repr__


def get_coordinated_domain_id() -> CoordinatedDomainID:
    """Reserve a free domain on this computer; keep the result while you use it. Raises RuntimeError if all are taken.

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
    """Reserve a domain for a block: `with domain_id() as number:` (later releases)."""
    domain = get_coordinated_domain_id()
    try:
        yield int(domain)
    finally:
        domain._held.close()
