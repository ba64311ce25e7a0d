"""Locks between programs, based on a file."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

from . import operating_system


@contextlib.contextmanager
def alone(path: Path) -> Iterator[None]:
    """Make other programs with the same lock file wait while the block runs.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder, alone(Path(folder, "lock")):
    ...     print("nobody else is here")
    nobody else is here
    """
    with open(path, "w", encoding="utf-8") as file:
        if operating_system.WINDOWS:
            _lock_byte(file.fileno())
        else:
            _lock_file(file.fileno())
        yield


def _lock_file(file: int) -> None:
    import fcntl

    fcntl.flock(file, fcntl.LOCK_EX)


def _lock_byte(file: int) -> None:
    """Lock a byte: Windows tries for ten seconds, then reports that the file is locked."""
    import msvcrt

    while True:
        with contextlib.suppress(OSError):
            msvcrt.locking(file, msvcrt.LK_LOCK, 1)  # type: ignore[attr-defined]
            return
