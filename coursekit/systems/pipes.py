"""Waiting for pipes: on Windows `select` supports only sockets."""

from __future__ import annotations

import ctypes
import os
import select
import time
from collections.abc import Sequence
from typing import Any

from . import operating_system

STEP = 0.005
"""Polling interval of a pipe on Windows [s]."""
_now, _sleep = time.monotonic, time.sleep  # the real ones: in a process `time` is replaced by the session
_select = select.select


def readable(pipe: int, seconds: float) -> bool:
    """Return whether there is data, or the end of the file, within so many real seconds.

    >>> import os
    >>> read, write = os.pipe()
    >>> readable(read, 0.0), os.write(write, b"x"), readable(read, 0.0)
    (False, 1, True)
    """
    if not operating_system.WINDOWS:
        return bool(_select([pipe], [], [], max(0.0, seconds))[0])
    give_up = _now() + seconds
    while not peek(pipe):
        left = give_up - _now()
        if left <= 0:
            return False
        _sleep(min(STEP, left))
    return True


def wait_readable(sources: Sequence[Any], seconds: float | None = None) -> list[Any]:
    """Return the pipes (file descriptors) and sockets with data or at their end; wait at most so many real seconds.

    >>> import socket
    >>> one, other = socket.socketpair()
    >>> other.send(b"x"), wait_readable([one, other]) == [one]
    (1, True)
    """
    if not operating_system.WINDOWS:
        return list(_select(sources, [], [], seconds)[0])
    pipes = [source for source in sources if isinstance(source, int)]
    sockets = [source for source in sources if not isinstance(source, int)]
    give_up = None if seconds is None else _now() + seconds
    while True:
        left = None if give_up is None else max(0.0, give_up - _now())
        ready = [pipe for pipe in pipes if peek(pipe)]
        ready += _ready_sockets(sockets, 0.0 if ready else _step(left, bool(pipes)))
        if ready or left == 0.0:
            return ready


def _step(left: float | None, has_pipes: bool) -> float | None:
    """Return the timeout for waiting for sockets alone."""
    if not has_pipes:
        return left
    return STEP if left is None else min(STEP, left)


def _ready_sockets(sockets: list[Any], seconds: float | None) -> list[Any]:
    """Return the ready sockets: Windows cannot wait for an empty list."""
    if sockets:
        return list(_select(sockets, [], [], seconds)[0])
    _sleep(seconds or 0.0)
    return []


def never_wait(pipe: int) -> None:
    """Make `read_now` non-blocking for the pipe."""
    if not operating_system.WINDOWS:
        os.set_blocking(pipe, False)


def read_now(pipe: int, size: int) -> bytes:
    """Return at most so many bytes, empty at the end; BlockingIOError when there is no data yet."""
    if operating_system.WINDOWS and not peek(pipe):
        raise BlockingIOError
    return os.read(pipe, size)


def wait_for_end(pipe: int) -> None:
    """Return when all writers of the pipe have closed it; data received until then is discarded.

    On Windows no read blocks meanwhile: it would block everyone who inspects this pipe, as Fortran's library does when it is
    loaded.
    """
    while wait_readable([pipe]) and os.read(pipe, 4096):
        pass


def peek(pipe: int) -> bool:
    """On Windows, return whether a read of the pipe returns at once, with data or at the end."""
    import msvcrt

    there = ctypes.c_ulong()
    handle = ctypes.c_void_p(msvcrt.get_osfhandle(pipe))  # type: ignore[attr-defined]
    succeeded = ctypes.windll.kernel32.PeekNamedPipe(handle, None, 0, None, ctypes.byref(there), None)  # type: ignore[attr-defined]
    return not succeeded or there.value > 0  # it fails if the other end is closed: a read reports that
