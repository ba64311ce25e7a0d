"""The streams of a command: UTF-8 on every system, whatever the code page."""

from __future__ import annotations

import errno
import io
import sys

from . import which


def use_utf8() -> None:
    """Have this program's standard streams read and write UTF-8, where Windows would have its code page; harmless twice.

    A character that a console cannot show is no reason to end a command: it is written as an escape.
    """
    if not which.WINDOWS:
        return
    for stream in (sys.stdin, sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="backslashreplace" if stream is not sys.stdin else "replace")


def reader_has_gone(error: OSError) -> bool:
    """Whether writing to a pipe failed because nobody reads it any more, as `head` does when it has its lines.

    Windows says "Invalid argument" then.
    """
    nameless_invalid = error.errno == errno.EINVAL and error.filename is None
    return isinstance(error, BrokenPipeError) or (which.WINDOWS and nameless_invalid)
