"""Reading and writing files safely: only regular files of limited size are read, and files are written atomically."""

from __future__ import annotations

import contextlib
import errno
import os
import stat
import tempfile
import time
from collections.abc import Iterable
from pathlib import Path, PurePath
from typing import BinaryIO, TypeVar

AnyPath = TypeVar("AnyPath", bound=PurePath)

WINDOWS = os.name == "nt"
"""Tests set it to check Windows' behaviour on Linux."""
PAUSES = (0.01, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8)
"""Pauses between attempts to replace a file on Windows [s]."""
TEXT, DATA = 16 << 20, 256 << 20
"""Maximum size of text files, and of other files, for reading [bytes]."""
_ON_A_ROBOT = "/opt/ros/humble/share/"
_PIECE = 1 << 18
"""Size of the pieces in which files are read [bytes]."""
_OPEN = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)


def in_order(paths: Iterable[AnyPath]) -> list[AnyPath]:
    """Sort paths in the same order on every system: Windows paths by themselves sort without regard to case.

    >>> from pathlib import PureWindowsPath
    >>> names = [PureWindowsPath("ListControllers.srv"), PureWindowsPath("ListControllerTypes.srv")]
    >>> [one.name for one in in_order(names)], [one.name for one in sorted(names)]
    (['ListControllerTypes.srv', 'ListControllers.srv'], ['ListControllers.srv', 'ListControllerTypes.srv'])
    """
    return sorted(paths, key=lambda path: path.as_posix())


def installed(path: str | os.PathLike[str]) -> str:
    """Return where a file or folder is that is named by its place on a robot, /opt/ros/humble/share/PACKAGE/...

    The path is returned as it is if something is there, or if coursekit's packages have nothing of that name.

    >>> Path(installed("/opt/ros/humble/share/turtlesim/package.xml")).parts[-4:]
    ('coursekit', 'share', 'turtlesim', 'package.xml')
    """
    given = os.fspath(path)
    _, mark, inner = given.partition(_ON_A_ROBOT)
    if not mark or not given.startswith(mark) or ".." in PurePath(inner).parts or os.path.exists(given):
        return given
    here = Path(__file__).parent / "share" / inner
    return str(here) if here.exists() else given


def read_bytes(path: str | os.PathLike[str], most: int = DATA) -> bytes:
    """Return the contents of a file; OSError if it is a pipe, a device or too large: none of these is read.

    >>> read_bytes("/dev/zero")
    Traceback (most recent call last):
    OSError: [Errno 22] It is a device or a pipe, not a file: '/dev/zero'
    """
    try:
        descriptor = os.open(installed(path), _OPEN)
    except ValueError as error:  # a name with a null character
        raise OSError(errno.EINVAL, str(error), os.fspath(path)) from None
    with os.fdopen(descriptor, "rb") as file:
        kind = os.fstat(descriptor)
        if stat.S_ISDIR(kind.st_mode):
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), os.fspath(path))
        if not stat.S_ISREG(kind.st_mode):
            raise OSError(errno.EINVAL, "It is a device or a pipe, not a file", os.fspath(path))
        data = _read(file, most + 1) if kind.st_size <= most else b""
    if kind.st_size > most or len(data) > most:
        raise OSError(errno.EFBIG, f"It is larger than {most >> 20} MB", os.fspath(path))
    return data


def _read(file: BinaryIO, most: int) -> bytes:
    """Return at most so many bytes, read in pieces: Python allocates the requested size, whatever is available."""
    pieces = []
    while piece := file.read(min(most, _PIECE)):
        pieces.append(piece)
        most -= len(piece)
    return b"".join(pieces)


def read_text(path: str | os.PathLike[str], *, errors: str = "strict", most: int = TEXT) -> str:
    """Return the text of a UTF-8 file; OSError as in `read_bytes`, UnicodeDecodeError when it is not text."""
    return read_bytes(path, most).decode("utf-8", errors).replace("\r\n", "\n")


def is_file(path: str | os.PathLike[str]) -> bool:
    """Return whether there is such a file, also under its name on a robot; accepts names that no file can have.

    >>> is_file("x" * 5000), is_file("a\\0b")
    (False, False)
    """
    try:
        return stat.S_ISREG(os.stat(installed(path)).st_mode)
    except (OSError, ValueError):
        return False


def is_folder(path: str | os.PathLike[str]) -> bool:
    """Return whether there is such a folder; also accepts names that no folder can have."""
    try:
        return stat.S_ISDIR(os.stat(path).st_mode)
    except (OSError, ValueError):
        return False


def write_whole(path: str | os.PathLike[str], data: bytes | str, mode: int | None = None, *, parents: bool = False) -> None:
    """Write a file atomically: either the old or the new one exists, never a part of it, even when the disk is full.

    `mode` sets its permissions; the default is those of the old file or of any new one. `parents` creates its folder.

    Raises:
        OSError: when it cannot be written; the old file then still exists.
    """
    target = Path(path)
    with contextlib.suppress(OSError):
        target = target.resolve()  # a link stays a link
    if parents:
        target.parent.mkdir(parents=True, exist_ok=True)
    hidden = "~" if WINDOWS else "."  # some Windows disks mark names with a dot as hidden, and that mark stays
    number, fresh = tempfile.mkstemp(dir=target.parent, prefix=f"{hidden}{target.name[:80]}.")
    try:
        with os.fdopen(number, "wb") as file:
            file.write(data.encode() if isinstance(data, str) else data)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(fresh, _rights(target) if mode is None else mode)
        put_in_place(fresh, target)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(fresh)
        raise


def put_in_place(fresh: str | os.PathLike[str], target: str | os.PathLike[str]) -> None:
    """Rename a file, replacing an existing one.

    Windows refuses that while a program has the old file open (a virus scanner, cloud storage, a viewer). Most of them close
    it soon, so the rename is repeated. Raises PermissionError with this reason if all attempts fail.
    """
    for pause in PAUSES if WINDOWS else ():
        try:
            os.replace(fresh, target)
            return
        except PermissionError:
            time.sleep(pause)
    try:
        os.replace(fresh, target)
    except PermissionError as error:
        if WINDOWS:
            error.strerror = "Another program has the file open: close it, and try again"
        raise


def _rights(target: Path) -> int:
    """Return the permissions of the old file, or the default ones."""
    try:
        return stat.S_IMODE(target.stat().st_mode)
    except OSError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask


__all__ = ["DATA", "TEXT", "installed", "is_file", "is_folder", "read_bytes", "read_text", "write_whole"]
