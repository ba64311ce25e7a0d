"""The pieces of a submitted folder or zip: each notebook is read once, recognised, and stored as a plain copy."""

from __future__ import annotations

import hashlib
import io
import itertools
import json
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, BinaryIO

from .archives import Archive, Member
from .bundle import LARGEST as LARGEST_BUNDLE
from .bundle import MANIFEST
from .platform_names import platform_name
from .recognising import LARGEST, Known, Recogniser, parse_notebook
from .sanitizing import shown

SEALED, PLATFORM, LISTED, ZIPPED, FILE = (
    "the time that hand_in sealed",
    "the platform's time",
    "the time in the platform's list",
    "the file's time in the zip",
    "the file's time",
)
"""The sources of a time; the first available one counts."""
SYSTEM = ("__MACOSX", ".DS_Store", "Thumbs.db", "desktop.ini", ".coursekit", ".git")
"""Files added by computers, which belong to no notebook."""
WORKSPACE = "ros2_ws"
"""A folder in which only notebooks are considered."""
_MAYBE = (".json", ".txt", ".ipynb~")
"""The variants of a notebook's suffix made by browsers and editors."""


@dataclass(frozen=True)
class Raw:
    """A file as found, or the reason why it cannot be read."""

    parts: tuple[str, ...]
    when: float = 0.0
    when_from: str = FILE
    open: Callable[[], BinaryIO] | None = None
    size: int = 0
    fault: str = ""


@dataclass(frozen=True)
class Piece:
    """A notebook that was handed in."""

    where: str
    """Its location, for display."""
    chapter: str = ""
    known: Known = field(default_factory=lambda: Known(""))
    also: tuple[Known, ...] = ()
    """The other chapters whose exercises were also done in it."""
    file: Path | None = None
    """A plain copy of the notebook."""
    digest: str = ""
    when: float = 0.0
    when_from: str = FILE
    inner: float = 0.0
    """The modification time of the file itself: the order within one hand-in."""
    entry: str = ""
    """The class's folder or file in which it was found."""
    bundle: Path | None = None
    """A plain copy of the `hand_in()` file that contained it, if any."""
    student: str = ""
    """The student named in the file."""
    checkpoint: bool = False
    late_said: bool = False
    """Whether the platform marked it as late."""
    fault: str = ""


@dataclass
class Entry:
    """One folder or file of a class's folder, and its content."""

    name: str
    """Its name there."""
    pieces: list[Piece] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)
    others: list[str] = field(default_factory=list)
    """Files that are not notebooks."""
    students: list[str] = field(default_factory=list)
    """The students named in files made by `hand_in()`."""
    bundles: list[Path] = field(default_factory=list)
    """Plain copies of these files."""
    concerns: list[str] = field(default_factory=list)


class Gatherer:
    """Reads entries, and stores plain copies in its own folder."""

    def __init__(self, recogniser: Recogniser, scratch: Path) -> None:
        self._recogniser = recogniser
        self._scratch = scratch
        self._number = itertools.count()

    def entry(self, name: str, files: Iterable[Raw]) -> Entry:
        """Read all files of an entry; a faulty file is reported and does not stop the others."""
        entry = Entry(name)
        for raw in files:
            if _is_left_out(raw.parts):
                continue
            where = shown("/".join(raw.parts))
            if raw.fault:
                entry.faults.append(f"{where} {raw.fault}")
                continue
            try:
                self._file(entry, raw, where, nested=0)
            except (OSError, ValueError, MemoryError) as error:
                entry.faults.append(f"{where}: {shown(str(error)) or 'cannot be read'}")
        told = platform_name(name)
        if told is not None:
            entry.pieces = [_of_platform(piece, told.when, told.late) for piece in entry.pieces]
        return entry

    def _file(self, entry: Entry, raw: Raw, where: str, nested: int, bundle: _Bundle | None = None) -> None:
        name, begin = raw.parts[-1].casefold(), _beginning(raw)
        packed = begin.startswith(b"PK\x03\x04") if begin[:1] in b"P{" else name.endswith(".zip")
        if packed and name.endswith((".zip", ".ipynb")):
            self._zip(entry, raw, where, nested)
        elif name.endswith((".zip", ".ipynb")) or ".ipynb." in name:
            piece = self._notebook(raw, where, entry.name, bundle)
            if name.endswith((".zip", ".ipynb")) or piece.chapter:
                entry.pieces.append(piece)
        elif bundle is None:
            entry.others.append(where)
            if begin[:1] == b"{" and (name.endswith(_MAYBE) or "." not in name):
                piece = self._notebook(raw, where, entry.name, bundle)
                entry.pieces += [piece] if piece.known.chapter else []

    def _notebook(self, raw: Raw, where: str, entry: str, bundle: _Bundle | None) -> Piece:
        chapter = self._recogniser.by_name(raw.parts[-1])
        kept = Piece(where, chapter, when=raw.when, when_from=raw.when_from, inner=raw.when, entry=entry,
                     checkpoint=".ipynb_checkpoints" in raw.parts)  # fmt: skip
        if bundle is not None:
            kept = replace(kept, bundle=bundle.file, student=bundle.student)
            if bundle.when:
                kept = replace(kept, when=bundle.when, when_from=SEALED)
        try:
            data = _read(raw, LARGEST)
            kept = replace(kept, file=self._keep(data, ".ipynb"), digest=hashlib.sha256(data).hexdigest())
            notebook = parse_notebook(data, "it")
            known = self._recogniser.recognise(notebook)
        except (ValueError, OSError) as error:
            return replace(kept, fault=shown(str(error)))
        also = self._recogniser.others(notebook, known.chapter) if known.chapter else ()
        return replace(kept, chapter=known.chapter or chapter, known=known, also=also)

    def _zip(self, entry: Entry, raw: Raw, where: str, nested: int) -> None:
        if nested > 1:
            entry.faults.append(f"{where}: a zip in a zip in a zip is not opened")
            return
        if raw.size > LARGEST_BUNDLE or raw.open is None:
            entry.faults.append(f"{where} is larger than {LARGEST_BUNDLE >> 20} MB")
            return
        with Archive(raw.open()) as opened:
            members = list(opened.members())
            manifest = next((info for info in members if info.parts == (MANIFEST,)), None)
            bundle = self._bundle(entry, raw, opened.read(manifest, 4 << 20)) if manifest else None
            for member in members:
                inner = _of_member(opened, member, raw)
                if _is_left_out(member.parts):
                    continue
                inside = shown(f"{where}/{'/'.join(member.parts)}", 300)
                try:
                    self._file(entry, inner, inside, nested + 1, bundle)
                except (OSError, ValueError, MemoryError) as error:
                    entry.faults.append(f"{inside}: {shown(str(error)) or 'cannot be read'}")

    def _bundle(self, entry: Entry, raw: Raw, manifest: bytes) -> _Bundle | None:
        """Read a file made by `hand_in()`, with its author and time."""
        try:
            said = json.loads(manifest)
        except (ValueError, RecursionError):
            said = None
        if not isinstance(said, dict) or not {"files", "student"} & set(said):
            return None
        kept = self._keep(_read(raw, LARGEST_BUNDLE), ".zip")
        entry.bundles.append(kept)
        student = shown(said["student"], 80) if isinstance(said.get("student"), str) else ""
        entry.students += [student] if student else []
        return _Bundle(kept, sealed_time(said), student)

    def _keep(self, data: bytes, ending: str) -> Path:
        file = self._scratch / f"{next(self._number)}{ending}"
        file.write_bytes(data)
        return file


@dataclass(frozen=True)
class _Bundle:
    file: Path
    when: float
    student: str


def sealed_time(manifest: dict[str, Any]) -> float:
    """Return when a file was made by `hand_in()`, in seconds since 1970; 0 if it has no time."""
    try:
        from datetime import datetime

        return max(0.0, datetime.strptime(str(manifest.get("time")), "%Y-%m-%d %H:%M:%S %z").timestamp())
    except (ValueError, OverflowError):
        return 0.0


def _is_left_out(parts: tuple[str, ...]) -> bool:
    """Whether a file was certainly not meant as a submission."""
    workspace = WORKSPACE in parts and not parts[-1].casefold().endswith(".ipynb")
    return workspace or parts[-1].startswith("._") or any(part in SYSTEM for part in parts)


def _beginning(raw: Raw) -> bytes:
    """Return the first bytes of a file, which identify its type; empty if it is not considered."""
    if raw.open is None or raw.size > LARGEST:
        return b""
    with raw.open() as data:
        return data.read(64).lstrip(b"\xef\xbb\xbf \t\r\n")


def _of_platform(piece: Piece, when: float, late: bool) -> Piece:
    if when and piece.when_from != SEALED:
        piece = replace(piece, when=when, when_from=PLATFORM)
    return replace(piece, late_said=late)


def _of_member(opened: Archive, member: Member, outer: Raw) -> Raw:
    when = member.when or outer.when
    how = ZIPPED if member.when else outer.when_from
    return Raw(member.parts, when, how, lambda: io.BytesIO(opened.read(member)), member.size)


def _read(raw: Raw, most: int) -> bytes:
    """Read a whole file up to `most` bytes, also if it grows meanwhile."""
    if raw.size > most or raw.open is None:
        raise ValueError(f"it is larger than {most >> 20} MB")
    content = bytearray()
    with raw.open() as data:
        while piece := data.read(1 << 16):
            content += piece
            if len(content) > most:
                raise ValueError(f"it is larger than {most >> 20} MB")
    return bytes(content)


def told_time(when: float) -> str:
    """Format a time for display.

    >>> told_time(0)
    'no time'
    """
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(when)) if when else "no time"
