"""msvcrt for the standard input of a process: programs on Windows, such as teleop nodes, read single keys with it."""

from __future__ import annotations

import weakref
from typing import Any

from coursekit.systems import console

from .process import Process, current_process

try:
    import msvcrt as _msvcrt
except ImportError:  # Linux and macOS: programs read keys with termios there
    _msvcrt = None  # type: ignore[assignment]

CTRL_Z = "\x1a"
"""msvcrt's result at the end of input."""
_NAMES = ("getwch", "getwche", "getch", "getche", "kbhit")
_real: dict[str, Any] = {name: getattr(_msvcrt, name, None) for name in _NAMES}
_left: weakref.WeakKeyDictionary[Process, list[str]] = weakref.WeakKeyDictionary()
"""The second code of a key with two codes."""


def getwch() -> str:
    """Return the next code; wait for a key."""
    process = current_process()
    return _real["getwch"]() if process is None else _next(process)


def getwche() -> str:
    """Like `getwch`, with echo."""
    process = current_process()
    if process is None:
        return str(_real["getwche"]())
    code = _next(process)
    print(code, end="", flush=True)
    return code


def getch() -> bytes:
    """Like `getwch`, as bytes."""
    return _real["getch"]() if current_process() is None else getwch().encode("latin-1", "replace")


def getche() -> bytes:
    """Like `getwche`, as bytes."""
    return _real["getche"]() if current_process() is None else getwche().encode("latin-1", "replace")


def kbhit() -> bool:
    """Return whether a code is available without waiting."""
    process = current_process()
    if process is None:
        return bool(_real["kbhit"]())
    _want(process)
    process.session.clock.poll()  # a polling loop lets time pass
    return bool(_left.get(process)) or process.stdin.has_keys()


def _next(process: Process) -> str:
    codes = _left.setdefault(process, [])
    if not codes:
        _want(process)
        typed = process.stdin.read(1)
        while typed and console.begins_key(typed) and process.stdin.has_keys() and (more := process.stdin.read(1)):
            typed += more
        codes += console.codes_of(typed) or [CTRL_Z]
    return codes.pop(0)


def _want(process: Process) -> None:
    if not process.stdin.by_keys:
        process.stdin.by_keys = True
        process.want_keys()


FUNCTIONS = (getwch, getwche, getch, getche, kbhit)
