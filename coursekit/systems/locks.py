"""Locks between programs, by a file."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

from . import which


@contextlib.contextmanager
def alone(path: Path) -> Iterator[None]:
    """Keep other programs that ask for the same file waiting while the block runs.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder, alone(Path(folder, "lock")):
    ...     print("nobody else is here")
    nobody else is here
    """
    with open(path, "w", encoding="utf-8") as file:
        if which.WINDOWS:
            _lock_byte(file.fileno())
        else:
            _lock_file(file.fileno())
        yield


def _lock_file(file: int) -> None:
    import fcntl

    fcntl.flock(file, fcntl.LOCK_EX)


def _lock_byte(file: int) -> None:
    """Windows tries for ten seconds, then says that the file is taken."""
    import msvcrt

    while True:
        with contextlib.suppress(OSError):
            msvcrt.locking(file, msvcrt.LK_LOCK, 1)  # type: ignore[attr-defined]
            return
