"""A terminal for a child process, which then writes as to an interactive terminal."""

from __future__ import annotations

import io
from typing import Any, TextIO

try:
    import pty
    import termios
except ImportError:  # no pseudo-terminals on Windows
    pty = termios = None  # type: ignore[assignment]


def open_terminal() -> tuple[TextIO, int] | None:
    r"""Return (reader, file descriptor of the child's end), or None without pseudo-terminals. Lines end in \n.

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
    """Reads a terminal; Linux reports the end of the child as an error, which is treated as the end of the file."""

    def readinto(self, buffer: Any) -> int | None:
        try:
            return super().readinto(buffer)
        except OSError:
            return 0
