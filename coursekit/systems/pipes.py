"""Waiting for what comes through a pipe: `select` knows only sockets on Windows."""

from __future__ import annotations

import ctypes
import select
import time
from collections.abc import Sequence
from typing import Any

from . import which

STEP = 0.005
"""How often a pipe is looked into on Windows [s]."""
_now, _sleep = time.monotonic, time.sleep  # the real ones: in a process those of `time` are the session's
_select = select.select


def readable(pipe: int, seconds: float) -> bool:
    """Whether there is something to read, or the end, within so many real seconds.

    >>> import os
    >>> read, write = os.pipe()
    >>> readable(read, 0.0), os.write(write, b"x"), readable(read, 0.0)
    (False, 1, True)
    """
    if not which.WINDOWS:
        return bool(_select([pipe], [], [], max(0.0, seconds))[0])
    give_up = _now() + seconds
    while not peek(pipe):
        left = give_up - _now()
        if left <= 0:
            return False
        _sleep(min(STEP, left))
    return True


def wait_readable(sources: Sequence[Any], seconds: float | None = None) -> list[Any]:
    """Which pipes and sockets have something to read, or their end; waits for the first, at most so many real seconds.

    Not on Windows, where only sockets can be waited for together.

    >>> import socket
    >>> one, other = socket.socketpair()
    >>> other.send(b"x"), wait_readable([one, other]) == [one]
    (1, True)
    """
    return list(_select(sources, [], [], seconds)[0])


def peek(pipe: int) -> bool:
    """On Windows: whether a read of the pipe returns at once, also with the end."""
    import msvcrt

    there = ctypes.c_ulong()
    handle = ctypes.c_void_p(msvcrt.get_osfhandle(pipe))  # type: ignore[attr-defined]
    found = ctypes.windll.kernel32.PeekNamedPipe(handle, None, 0, None, ctypes.byref(there), None)  # type: ignore[attr-defined]
    return not found or there.value > 0  # it fails where the other end is closed: a read says so
