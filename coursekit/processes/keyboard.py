"""termios, tty, select and fcntl for the standard input of a process, for programs that read single keys."""

from __future__ import annotations

import os
import select
import sys
from collections.abc import Sequence
from typing import Any

from .process import Process, current_process

try:
    import fcntl
    import termios
    import tty
except ImportError:  # Windows: programs read keys with msvcrt there
    fcntl = termios = tty = None  # type: ignore[assignment]

STDIN = 0
"""The file descriptor of standard input."""
_LFLAG = 3
_real_select: Any = select.select
_real_fcntl: Any = getattr(fcntl, "fcntl", None)
_real_tcgetattr: Any = getattr(termios, "tcgetattr", None)
_real_tcsetattr: Any = getattr(termios, "tcsetattr", None)


def _typed_at(file: Any) -> Process | None:
    """Return the process whose standard input `file` is; None for every other file."""
    process = current_process()
    return process if process is not None and (file is sys.stdin or file is process.stdin or file == STDIN) else None


def _settings(process: Process) -> list[Any]:
    """Return the settings of its terminal; initially line mode, with echo and Ctrl-C."""
    cooked = termios.ICANON | termios.ECHO | termios.ISIG | termios.IEXTEN
    first = [termios.ICRNL, termios.OPOST, termios.CS8, cooked, termios.B38400, termios.B38400, [b"\0"] * 32]
    return process.stdin.settings or first


def tcgetattr(fd: Any) -> list[Any]:
    process = _typed_at(fd)
    if process is None:
        return _real_tcgetattr(fd)
    *flags, letters = _settings(process)
    return [*flags, list(letters)]


def tcsetattr(fd: Any, when: int, attributes: list[Any]) -> None:
    process = _typed_at(fd)
    if process is None:
        _real_tcsetattr(fd, when, attributes)
        return
    process.stdin.settings = list(attributes)
    process.stdin.ctrl_c_is_a_key = not attributes[_LFLAG] & termios.ISIG
    if not attributes[_LFLAG] & termios.ICANON and not process.stdin.by_keys:
        process.stdin.by_keys = True
        process.want_keys()


def fcntl_(fd: Any, cmd: int, arg: Any = 0) -> Any:
    process = _typed_at(fd)
    if process is None or cmd not in (fcntl.F_GETFL, fcntl.F_SETFL):
        return _real_fcntl(fd, cmd, arg)
    if cmd == fcntl.F_SETFL:
        process.stdin.blocking = not arg & os.O_NONBLOCK
    return 0 if process.stdin.blocking or cmd == fcntl.F_SETFL else os.O_NONBLOCK


def select_(
    rlist: Sequence[Any], wlist: Sequence[Any], xlist: Sequence[Any], timeout: float | None = None, /
) -> tuple[list[Any], list[Any], list[Any]]:
    process = current_process()
    typed = [file for file in rlist if _typed_at(file)]
    if process is None or (not typed and (rlist or wlist or xlist or timeout is None)):
        return _real_select(rlist, wlist, xlist, timeout)
    if not process.stdin.wait_for_keys(timeout):
        typed = []
    return typed, [], []

