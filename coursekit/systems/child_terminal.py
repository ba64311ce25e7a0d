"""A terminal for a child process: it writes as if somebody looked on."""

from __future__ import annotations

import io
from typing import Any, TextIO

try:
    import pty
    import termios
except ImportError:  # no terminals of this kind on Windows
    pty = termios = None  # type: ignore[assignment]


def open_terminal() -> tuple[TextIO, int] | None:
    r"""Return (what reads it, the number of the child's end), None where the system has none. Lines end in \n.

    >>> import os
    >>> reader, number = open_terminal()
    >>> os.isatty(number), os.write(number, b"one\n"), reader.readline()
    (True, 4, 'one\n')
    """
    if pty is None:
        return None
    outer, inner = pty.openpty()
    settings = termios.tcgetattr(inner)
    settings[1] &= ~termios.ONLCR
    termios.tcsetattr(inner, termios.TCSANOW, settings)
    return io.TextIOWrapper(io.BufferedReader(_Reader(outer)), "utf-8", "replace", newline="\n"), inner


class _Reader(io.FileIO):
    """Reads a terminal; Linux reports the closed end of the child as an error, which is no more than the end."""

    def readinto(self, buffer: Any) -> int | None:
        try:
            return super().readinto(buffer)
        except OSError:
            return 0
