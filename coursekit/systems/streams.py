"""The standard streams of a command: UTF-8 on every system, whatever the code page."""

from __future__ import annotations

import errno
import io
import sys

from . import operating_system


def use_utf8() -> None:
    """Make this program's standard streams use UTF-8, instead of the code page on Windows; harmless when repeated.

    A character that a console cannot display must not end a command: it is written as an escape.
    """
    if not operating_system.WINDOWS:
        return
    for stream in (sys.stdin, sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="backslashreplace" if stream is not sys.stdin else "replace")


def reader_has_gone(error: OSError) -> bool:
    """Return whether writing to a pipe failed because its reader has closed it, as `head` does after its lines.

    Windows then reports "Invalid argument".
    """
    nameless_invalid = error.errno == errno.EINVAL and error.filename is None
    return isinstance(error, BrokenPipeError) or (operating_system.WINDOWS and nameless_invalid)
