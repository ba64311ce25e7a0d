"""Waits that Ctrl-C ends: on Windows it waits itself until a lock or a socket lets the main thread go on."""

from __future__ import annotations

import select
import socket
import threading
import time
from collections.abc import Iterator
from typing import Any

from . import which

SLICE = 0.1
"""How long the main thread is out of Ctrl-C's reach on Windows [s]."""
_now = time.monotonic  # the real one
_select = select.select
_get_ident = threading.get_ident


def acquire(lock: Any, seconds: float | None = None) -> bool:
    """`lock.acquire` for at most so many seconds, None for as long as it takes.

    >>> acquire(threading.Lock()), acquire(threading.Lock(), 0.0)
    (True, True)
    """
    if not which.WINDOWS or _get_ident() != threading.main_thread().ident:
        return bool(lock.acquire(timeout=-1 if seconds is None else max(0.0, seconds)))
    give_up = None if seconds is None else _now() + seconds
    while True:
        left = SLICE if give_up is None else max(0.0, give_up - _now())
        if lock.acquire(timeout=min(SLICE, left)):
            return True
        if give_up is not None and left <= SLICE:
            return False


def lines(peer: socket.socket) -> Iterator[str]:
    r"""The lines that come through a socket, in UTF-8, without their ends; they end when the other side hangs up.

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
    while which.WINDOWS and not _select([peer], [], [], SLICE)[0]:
        pass  # here a Ctrl-C is seen
    return peer.recv(65536)
