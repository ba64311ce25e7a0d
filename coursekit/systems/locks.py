"""Locks between programs, by a file."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator
from pathlib import Path

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl


@contextlib.contextmanager
def alone(path: Path) -> Iterator[None]:
    """Keep other programs that ask for the same file waiting while the block runs.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder, alone(Path(folder, "lock")):
    ...     print("nobody else is here")
    nobody else is here
    """
    with open(path, "w", encoding="utf-8") as file:
        if sys.platform == "win32":
            _lock_byte(file.fileno())
        else:
            fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _lock_byte(file: int) -> None:
    """Windows tries for ten seconds, then says that the file is taken."""
    while True:
        with contextlib.suppress(OSError):
            msvcrt.locking(file, msvcrt.LK_LOCK, 1)  # type: ignore[attr-defined,unused-ignore]
            return
