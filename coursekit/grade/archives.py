"""Zips that students made, opened with care: nothing is read that is too large, nothing is written by its own name."""

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
    """Bytes of its list of members, which is read as a whole."""
    file: int = 64 << 20
    """Bytes of one member, unpacked."""
    total: int = 256 << 20
    """Bytes of all that is read of it."""


OF_A_STUDENT = Bounds()
OF_A_CLASS = Bounds(members=50_000, directory=32 << 20, file=128 << 20, total=16 << 30)


class BadArchive(ValueError):
    """A zip, or a member of one, that is not opened; says why."""


@dataclass(frozen=True)
class Member:
    """A file in a zip."""

    parts: tuple[str, ...]
    when: float
    """When it was last changed, in seconds since 1970; 0 if the zip does not say."""
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
        """Before zipfile reads all of the list of members."""
        end = zipfile._EndRecData(file)  # type: ignore[attr-defined]  # what zipfile itself goes by
        if end is None:
            raise BadArchive("it is no zip, or only a part of one")
        if end[5] > self._bounds.directory or end[4] > self._bounds.members:
            raise BadArchive(f"it holds more than {self._bounds.members} files")

    def members(self) -> Iterator[Member]:
        """Its files, in the order of the zip; folders and links are left out. BadArchive: one has no name."""
        for info in self._opened.infolist():
            if not info.filename:
                raise BadArchive("a file in it has no name: zip it again")
            kind = stat.S_IFMT(info.external_attr >> 16)
            if not info.is_dir() and kind in (0, stat.S_IFREG):
                yield Member(parts_of(_name_of(info)), _when(info), info.file_size, info)

    def read(self, member: Member, most: int = 0) -> bytes:
        """The bytes of a file, at most `most`.

        Raises:
            BadArchive: when it is too large, encrypted, of another kind of compression, or broken.
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
        made = bytearray()
        with _said(), self._opened.open(info) as data:
            while piece := data.read(PIECE):
                made += piece
                if len(made) > info.file_size:
                    raise BadArchive("a file in it is larger than the zip states")
        if len(made) != info.file_size:
            raise BadArchive("a file in it is smaller than the zip states")
        return bytes(made)

    def close(self) -> None:
        """Close it, and the file that it is."""
        self._opened.close()
        self._file.close()

    def __enter__(self) -> Archive:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@contextlib.contextmanager
def _said() -> Iterator[None]:
    """Whatever a made-up zip makes zipfile raise is told as one thing."""
    try:
        yield
    except BadArchive:
        raise
    except UnicodeDecodeError:
        raise BadArchive("a file name in it is not UTF-8: zip it again") from None
    except Exception:  # zipfile, zlib and struct have a dozen kinds
        raise BadArchive("it is broken, or only a part of a zip: upload it again") from None


def _name_of(info: zipfile.ZipInfo) -> str:
    """A member's name. Programs that write UTF-8 without saying so are many: what is UTF-8 is read as that.

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
    r"""The names of a path in a zip, without what leads out of a folder.

    >>> parts_of("C:\\temp\\..\\a.ipynb"), parts_of("/etc/../x")
    (('temp', 'a.ipynb'), ('etc', 'x'))
    """
    names = name.replace("\\", "/").split("/")
    if len(names[0]) == 2 and names[0][1] == ":":
        names = names[1:]
    return tuple(one for one in names if one not in ("", ".", "..")) or ("nameless",)


def _when(info: zipfile.ZipInfo) -> float:
    """The zip's own time, in UTC where it says that, too; else as of a clock in this time zone."""
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
