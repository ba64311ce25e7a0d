"""msvcrt for the standard input of a process: programs of Windows read single keys with it, teleop nodes among them."""

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
"""msvcrt's answer where nothing more comes."""
_NAMES = ("getwch", "getwche", "getch", "getche", "kbhit")
_real: dict[str, Any] = {name: getattr(_msvcrt, name, None) for name in _NAMES}
_left: weakref.WeakKeyDictionary[Process, list[str]] = weakref.WeakKeyDictionary()
"""Of a key with two codes, the second."""


def getwch() -> str:
    """The next code; waits for a key."""
    process = current_process()
    return _real["getwch"]() if process is None else _next(process)


def getwche() -> str:
    """Likewise, and it is shown."""
    process = current_process()
    if process is None:
        return str(_real["getwche"]())
    code = _next(process)
    print(code, end="", flush=True)
    return code


def getch() -> bytes:
    """`getwch` as bytes."""
    return _real["getch"]() if current_process() is None else getwch().encode("latin-1", "replace")


def getche() -> bytes:
    """`getwche` as bytes."""
    return _real["getche"]() if current_process() is None else getwche().encode("latin-1", "replace")


def kbhit() -> bool:
    """Whether there is a code to be had without waiting."""
    process = current_process()
    if process is None:
        return bool(_real["kbhit"]())
    _want(process)
    process.session.clock.poll()  # a loop that only asks lets time pass
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
