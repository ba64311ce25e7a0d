"""Files named by `file://`: on Windows the path is preceded by a drive letter or a computer name."""

from __future__ import annotations

import re
from pathlib import Path

from . import operating_system

_DRIVE = re.compile(r"/?[A-Za-z]:")


def path_of(uri: str) -> Path:
    """Return the file of a `file://` URI without decoding it: `%20` is kept, because it may be part of a name.

    Programs put "file://" before a path that may begin with a drive letter, which is not a computer name.

    >>> path_of("file:///home/vera/map.yaml").as_posix()
    '/home/vera/map.yaml'
    """
    named = uri.removeprefix("file://")
    if operating_system.WINDOWS and _DRIVE.match(named):
        return Path(named.removeprefix("/"))
    return Path("//" + named) if operating_system.WINDOWS and not named.startswith("/") else Path(named)


__all__ = ["path_of"]
