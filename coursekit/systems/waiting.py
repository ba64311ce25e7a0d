"""Waits that Ctrl-C can end: on Windows a Ctrl-C is otherwise delayed until the lock or socket releases the main thread."""

from __future__ import annotations

import select
import socket
import threading
import time
from collections.abc import Iterator
from typing import Any

from . import operating_system

SLICE = 0.1
"""Interval in which the main thread on Windows checks for Ctrl-C [s]."""
_now = time.monotonic  # the real one
_select = select.select
_get_ident = threading.get_ident


def acquire(lock: Any, seconds: float | None = None) -> bool:
    """`lock.acquire` for at most so many seconds; None for no limit.

    >>> acquire(threading.Lock()), acquire(threading.Lock(), 0.0)
    (True, True)
    """
    if not operating_system.WINDOWS or _get_ident() != threading.main_thread().ident:
        return bool(lock.acquire(timeout=-1 if seconds is None else max(0.0, seconds)))
    give_up = None if seconds is None else _now() + seconds
    while True:
        left = SLICE if give_up is None else max(0.0, give_up - _now())
        if lock.acquire(timeout=min(SLICE, left)):
            return True
        if give_up is not None and left <= SLICE:
            return False


def lines(peer: socket.socket) -> Iterator[str]:
    r"""Yield the lines received on a socket, in UTF-8, without line ends, until the other side closes it.

    >>> here, there = socket.socketpair()
    >>> here.sendall("ñ\n\ntwo".encode()), here.close()
    (None, None)
    >>> list(lines(there))
    ['ñ', '', 'two']
    """
    rest = b""
    while data := _receive(peer):
        *whole, rest = (rest + data).split(b"\n")
        for line in whole:
            yield line.decode()
    if rest:
        yield rest.decode()


def _receive(peer: socket.socket) -> bytes:
    while operating_system.WINDOWS and not _select([peer], [], [], SLICE)[0]:
        pass  # Ctrl-C is handled here
    return peer.recv(65536)
