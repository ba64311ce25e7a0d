"""Safe reading of students' zips: nothing too large is read, and members' names are never used as paths."""

from __future__ import annotations

import calendar
import contextlib
import stat
import struct
import time
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from typing import BinaryIO

PIECE = 1 << 16


@dataclass(frozen=True)
class Bounds:
    """The limits of a zip."""

    members: int = 2000
    directory: int = 2 << 20
    """The size of the list of members, which is read as a whole [bytes]."""
    file: int = 64 << 20
    """The size of one member, unpacked [bytes]."""
    total: int = 256 << 20
    """The total size of the data read from the zip [bytes]."""


OF_A_STUDENT = Bounds()
OF_A_CLASS = Bounds(members=50_000, directory=32 << 20, file=128 << 20, total=16 << 30)


class BadArchive(ValueError):
    """A zip, or a member of one, is refused; the message gives the reason."""


@dataclass(frozen=True)
class Member:
    """A file in a zip."""

    parts: tuple[str, ...]
    when: float
    """The time of its last change in seconds since 1970; 0 if the zip has none."""
    size: int
    info: zipfile.ZipInfo


class Archive:
    """An opened zip."""

    def __init__(self, file: BinaryIO, bounds: Bounds = OF_A_STUDENT) -> None:
        self._bounds = bounds
        self._read = 0
        self._file = file
        with _said():
            self._refuse_long(file)
            self._opened = zipfile.ZipFile(file)
        if len(self._opened.infolist()) > bounds.members:
            raise BadArchive(f"it holds more than {bounds.members} files")

    def _refuse_long(self, file: BinaryIO) -> None:
        """Check the size of the list of members before zipfile reads it."""
        end = zipfile._EndRecData(file)  # type: ignore[attr-defined]  # what zipfile itself goes by
        if end is None:
            raise BadArchive("it is no zip, or only a part of one")
        if end[5] > self._bounds.directory or end[4] > self._bounds.members:
            raise BadArchive(f"it holds more than {self._bounds.members} files")

    def members(self) -> Iterator[Member]:
        """Yield the files, in the order of the zip, without folders and links. BadArchive: one has no name."""
        for info in self._opened.infolist():
            if not info.filename:
                raise BadArchive("a file in it has no name: zip it again")
            kind = stat.S_IFMT(info.external_attr >> 16)
            if not info.is_dir() and kind in (0, stat.S_IFREG):
                yield Member(parts_of(_name_of(info)), _when(info), info.file_size, info)

    def read(self, member: Member, most: int = 0) -> bytes:
        """Return the bytes of a file, at most `most`.

        Raises:
            BadArchive: when it is too large, encrypted, compressed by an unknown method, or broken.
        """
        most = min(most or self._bounds.file, self._bounds.file)
        info = member.info
        if info.flag_bits & 1:
            raise BadArchive("it is encrypted: zip it without a password")
        if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise BadArchive("it uses an unusual compression: zip it again")
        if info.file_size > most:
            raise BadArchive(f"it is larger than {most >> 20} MB")
        if self._read + info.file_size > self._bounds.total:
            raise BadArchive(f"the zip unpacks to more than {self._bounds.total >> 20} MB")
        self._read += info.file_size
        content = bytearray()
        with _said(), self._opened.open(info) as data:
            while piece := data.read(PIECE):
                content += piece
                if len(content) > info.file_size:
                    raise BadArchive("a file in it is larger than the zip states")
        if len(content) != info.file_size:
            raise BadArchive("a file in it is smaller than the zip states")
        return bytes(content)

    def close(self) -> None:
        """Close the archive and its file."""
        self._opened.close()
        self._file.close()

    def __enter__(self) -> Archive:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@contextlib.contextmanager
def _said() -> Iterator[None]:
    """Convert all exceptions that a manipulated zip may raise in zipfile to BadArchive."""
    try:
        yield
    except BadArchive:
        raise
    except UnicodeDecodeError:
        raise BadArchive("a file name in it is not UTF-8: zip it again") from None
    except Exception:  # zipfile, zlib and struct raise a dozen types
        raise BadArchive("it is broken, or only a part of a zip: upload it again") from None


def _name_of(info: zipfile.ZipInfo) -> str:
    """Return a member's name. Many programs write UTF-8 without the flag for it: valid UTF-8 is read as such.

    >>> _name_of(zipfile.ZipInfo("Müller".encode().decode("cp437")))
    'Müller'
    """
    if info.flag_bits & 0x800:
        return info.filename
    try:
        return info.filename.encode("cp437").decode("utf-8")
    except UnicodeError:
        return info.filename


def parts_of(name: str) -> tuple[str, ...]:
    r"""Return the parts of a path in a zip, without those that lead out of a folder.

    >>> parts_of("C:\\temp\\..\\a.ipynb"), parts_of("/etc/../x")
    (('temp', 'a.ipynb'), ('etc', 'x'))
    """
    names = name.replace("\\", "/").split("/")
    if len(names[0]) == 2 and names[0][1] == ":":
        names = names[1:]
    return tuple(part for part in names if part not in ("", ".", "..")) or ("nameless",)


def _when(info: zipfile.ZipInfo) -> float:
    """Return the time of a member; local time is assumed unless the zip has it in UTC."""
    extra = info.extra
    while len(extra) >= 4:
        kind, length = struct.unpack("<HH", extra[:4])
        if kind == 0x5455 and length >= 5 and len(extra) >= 9 and extra[4] & 1:
            return float(struct.unpack("<i", extra[5:9])[0])
        extra = extra[4 + length :]
    if info.date_time[:3] <= (1980, 1, 1):
        return 0.0
    try:
        calendar.timegm((*info.date_time, 0, 0, 0))
        return max(0.0, time.mktime((*info.date_time, 0, 0, -1)))
    except (ValueError, OverflowError):
        return 0.0
