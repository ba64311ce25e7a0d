"""Safe handling of untrusted folders: measured and removed by descriptors, whatever they contain.

Paths are unsuitable: they may exceed the system's maximum length, and a folder may be replaced by a link in between.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import stat
from collections.abc import Iterator
from pathlib import Path

DEEPEST = 100
MOST = 50_000
"""The maximum number of files and folders."""
_FOLDER = os.O_RDONLY | getattr(os, "O_DIRECTORY", 0) | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_CLOEXEC", 0)
BY_DESCRIPTOR = os.open in os.supports_dir_fd and os.scandir in os.supports_fd


class Excess(Exception):
    """A folder exceeds a limit; the message names it."""


def excess(folder: Path, most: int) -> str:
    """Return why a folder exceeds a limit; empty when its files have at most `most` bytes together."""
    total = count = 0
    try:
        for _, status in entries(folder):
            count += 1
            total += status.st_size if stat.S_ISREG(status.st_mode) else 0
            if total > most:
                return f"it wrote more than {most >> 20} MB of files"
            if count > MOST:
                return f"it made more than {MOST} files"
    except Excess as why:
        return str(why)
    return ""


def entries(folder: Path) -> Iterator[tuple[str, os.stat_result]]:
    """Yield (path below `folder`, status) of all entries; links are not followed. Raises Excess when it is too deep."""
    if not BY_DESCRIPTOR:
        for place, folders, files in os.walk(folder):
            for name in (*folders, *files):
                with contextlib.suppress(OSError):
                    path = os.path.join(place, name)
                    yield os.path.relpath(path, folder), os.lstat(path)
        return
    yield from _below(os.open(folder, _FOLDER), "", 0)


def _below(descriptor: int, above: str, depth: int) -> Iterator[tuple[str, os.stat_result]]:
    try:
        if depth > DEEPEST:
            raise Excess(f"it made folders in folders, more than {DEEPEST} deep")
        with os.scandir(descriptor) as listing:
            names = [entry.name for entry in listing]
        for name in names:
            with contextlib.suppress(FileNotFoundError):  # removed in the meantime
                status = os.stat(name, dir_fd=descriptor, follow_symlinks=False)
                yield f"{above}{name}", status
                if stat.S_ISDIR(status.st_mode):
                    yield from _below(os.open(name, _FOLDER, dir_fd=descriptor), f"{above}{name}/", depth + 1)
    finally:
        os.close(descriptor)


def remove_pipes(folder: Path) -> None:
    """Remove entries other than files, folders and links: opening a pipe would block forever.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     os.mkfifo(f"{folder}/pipe")
    ...     remove_pipes(Path(folder))
    ...     os.listdir(folder)
    []
    """
    if not BY_DESCRIPTOR:
        return
    with contextlib.suppress(OSError, Excess):
        for name in [name for name, status in entries(folder) if not _is_plain(status.st_mode)]:
            with contextlib.suppress(OSError):
                os.unlink(folder / name)


def _is_plain(mode: int) -> bool:
    return stat.S_ISREG(mode) or stat.S_ISDIR(mode) or stat.S_ISLNK(mode)


def remove(folder: Path) -> None:
    """Remove a folder and its content, regardless of depth and permissions; undeletable entries remain."""
    if not BY_DESCRIPTOR:
        shutil.rmtree(folder, ignore_errors=True)
        return
    with contextlib.suppress(OSError):
        top = os.open(folder, _FOLDER)
        try:
            _empty(top)
        finally:
            os.close(top)
        os.rmdir(folder)


def _empty(top: int) -> None:
    """Move subfolders to the top before removing them, to keep paths short and few descriptors open."""
    number = 0
    while names := [entry.name for entry in _listed(top)]:
        for name in names:
            if not _is_folder(name, top):
                os.unlink(name, dir_fd=top)
                continue
            os.chmod(name, 0o700, dir_fd=top)
            inner = os.open(name, _FOLDER, dir_fd=top)
            try:
                for entry in _listed(inner):
                    if _is_folder(entry.name, inner):
                        os.chmod(entry.name, 0o700, dir_fd=inner)
                        number += 1
                        os.rename(entry.name, f".gone-{os.getpid()}-{number}", src_dir_fd=inner, dst_dir_fd=top)
                    else:
                        os.unlink(entry.name, dir_fd=inner)
            finally:
                os.close(inner)
            os.rmdir(name, dir_fd=top)


def _listed(descriptor: int) -> list[os.DirEntry[str]]:
    with os.scandir(descriptor) as listing:
        return list(listing)


def _is_folder(name: str, descriptor: int) -> bool:
    return stat.S_ISDIR(os.stat(name, dir_fd=descriptor, follow_symlinks=False).st_mode)
