"""Removes old runtimes from the cache: every update of the course brings a new one, of some 50 MB."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
from pathlib import Path

KEPT = 3
"""So many runtimes stay however old they are: for other checkouts and compilers of the same user."""
A_DAY = 24 * 3600
MAKING = ".making-"
"""The beginning of the names of folders that become runtimes."""
_NAME = re.compile(r"[0-9a-f]{16}")


def mark_used(runtime: Path) -> None:
    """Note that a runtime is in use, as the time of its folder; a shared one that cannot be written stays as it is."""
    with contextlib.suppress(OSError):
        os.utime(runtime)


def remove_unused(runtimes: Path, now: float) -> None:
    """Remove runtimes that were not used for a day, except the last few, and what interrupted programs left.

    `now` is in seconds since 1970. Nobody else may make a runtime in this folder meanwhile.
    """
    for path in runtimes.glob(f"{MAKING}*"):
        shutil.rmtree(path, ignore_errors=True)
    complete = [path for path in runtimes.iterdir() if _NAME.fullmatch(path.name)]
    for path in sorted(complete, key=_last_used, reverse=True)[KEPT:]:
        if now - _last_used(path) > A_DAY:
            _remove(path)


def _last_used(runtime: Path) -> float:
    return runtime.stat().st_mtime


def _remove(runtime: Path) -> None:
    """Remove a folder whole or not at all: Windows keeps one whose libraries a program has loaded."""
    away = runtime.with_name(f"{MAKING}{runtime.name}")
    with contextlib.suppress(OSError):
        runtime.rename(away)
        shutil.rmtree(away, ignore_errors=True)
