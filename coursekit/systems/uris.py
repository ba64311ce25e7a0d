"""Files named by `file://`: on Windows a drive's letter, or a computer, comes before the path."""

from __future__ import annotations

import re
from pathlib import Path

from . import which

_DRIVE = re.compile(r"/?[A-Za-z]:")


def path_of(uri: str) -> Path:
    """The file of a `file://` URI as it is written: `%20` stays what it is, for it may be part of a name.

    Programs write "file://" before a path, and that may begin with a drive's letter: it names no computer.

    >>> path_of("file:///home/vera/map.yaml").as_posix()
    '/home/vera/map.yaml'
    """
    named = uri.removeprefix("file://")
    if which.WINDOWS and _DRIVE.match(named):
        return Path(named.removeprefix("/"))
    return Path("//" + named) if which.WINDOWS and not named.startswith("/") else Path(named)


__all__ = ["path_of"]
