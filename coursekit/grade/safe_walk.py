"""Walk through students' folders safely: by descriptors, without following links, with limited depth and length.

A name is opened in the folder from which it was read: a link that replaces it in between is not followed.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

DEEPEST = 24
"""The maximum nesting of folders."""
MOST = 5000
"""The maximum number of files and folders of one submission."""
_BY_DESCRIPTOR = os.open in os.supports_dir_fd and os.scandir in os.supports_fd
_FLAGS = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)
_FLAGS |= getattr(os, "O_BINARY", 0)
_FOLDER = getattr(os, "O_DIRECTORY", 0)


@dataclass(frozen=True)
class Walked:
    """A regular file, or the fault of an entry that cannot be read."""

    parts: tuple[str, ...]
    """The path's names, from the top down."""
    when: float = 0.0
    """The modification time in seconds since 1970."""
    size: int = 0
    open: Callable[[], BinaryIO] | None = None
    """Opens the file; only valid until the next one is requested."""
    fault: str = ""


class NotPlain(OSError):
    """It is not, or no longer, a regular file."""


def open_plain(place: Path | str, folder: int | None = None) -> BinaryIO:
    """Open a regular file, never a link, pipe or device; it cannot block.

    Raises:
        OSError: when it is not a regular file.
    """
    descriptor = os.open(place, _FLAGS, dir_fd=folder)
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise NotPlain(f"'{place!s}' is no plain file")
        return os.fdopen(descriptor, "rb")
    except BaseException:
        os.close(descriptor)
        raise


def walk(place: Path) -> Iterator[Walked]:
    """Yield every regular file in a folder (or the file itself), sorted by name."""
    try:
        kind = os.lstat(place).st_mode
        if stat.S_ISREG(kind):
            known = os.lstat(place)
            yield Walked((place.name,), known.st_mtime, known.st_size, lambda: open_plain(place))
        elif stat.S_ISDIR(kind):
            yield from _through(place)
        else:
            yield Walked((place.name,), fault="is a link or a device, not a file")
    except OSError as error:
        yield Walked((place.name,), fault=f"cannot be read: {error.strerror}")


@dataclass
class _Level:
    parts: tuple[str, ...]
    place: Path
    number: int | None
    """The descriptor, if folders can be opened by descriptors."""
    names: list[str]


def _through(place: Path) -> Iterator[Walked]:
    levels = [_entered(place, (), None)]
    seen = 0
    try:
        while levels:
            level = levels[-1]
            if not level.names:
                _left(levels.pop())
                continue
            name = level.names.pop()
            seen += 1
            if seen > MOST:
                yield Walked(level.parts or (place.name,), fault=f"holds more than {MOST} files")
                return
            entry = _looked_at(level, name)
            if isinstance(entry, Walked):
                yield entry
            elif entry and len(levels) >= DEEPEST:
                yield Walked((*level.parts, name), fault=f"lies deeper than {DEEPEST} folders")
            elif entry:
                try:
                    levels.append(_entered(level.place / name, (*level.parts, name), level.number))
                except OSError as error:  # gone, replaced by a link, or another user's
                    yield Walked((*level.parts, name), fault=f"cannot be read: {error.strerror}")
    finally:
        for level in levels:
            _left(level)


def _looked_at(level: _Level, name: str) -> Walked | bool:
    """Return a file, or whether the entry is a folder."""
    parts = (*level.parts, name)
    try:
        inside = level.place / name if level.number is None else name
        known = os.stat(inside, dir_fd=level.number, follow_symlinks=False)
    except OSError as error:
        return Walked(parts, fault=f"cannot be read: {error.strerror}")
    if stat.S_ISREG(known.st_mode):
        return Walked(parts, known.st_mtime, known.st_size, lambda: open_plain(inside, level.number))
    if stat.S_ISDIR(known.st_mode):
        return True
    return Walked(parts, fault="is a link or a device, not a file")


def _entered(place: Path, parts: tuple[str, ...], above: int | None) -> _Level:
    if not _BY_DESCRIPTOR:
        with os.scandir(place) as entries:
            return _Level(parts, place, None, _names(entries))
    number = os.open(place if above is None else place.name, _FLAGS | _FOLDER, dir_fd=above)
    try:
        with os.scandir(number) as entries:
            return _Level(parts, place, number, _names(entries))
    except BaseException:
        os.close(number)
        raise


def _names(entries: Iterator[os.DirEntry[str]]) -> list[str]:
    """Return the names in reverse order, at most one more than the limit."""
    names = []
    for entry in entries:
        names.append(entry.name)
        if len(names) > MOST:
            break
    return sorted(names, reverse=True)


def _left(level: _Level) -> None:
    if level.number is not None:
        os.close(level.number)
