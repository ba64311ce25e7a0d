"""What students handed in: one folder, notebook or zip each."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import stat
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

LARGEST = 50 << 20
"""Bytes that a submission may have, unpacked."""


@dataclass(frozen=True)
class Submission:
    """One student's."""

    student: str
    place: Path

    def digest(self) -> str:
        """Changes when anything that was handed in changes."""
        found = hashlib.sha256()
        for file in _files(self.place):
            found.update(str(file.relative_to(self.place.parent)).encode())
            found.update(file.read_bytes())
        return found.hexdigest()

    def newest(self) -> float:
        """When it was last changed, in seconds since 1970."""
        return max((file.stat().st_mtime for file in _files(self.place)), default=0.0)

    def archives(self) -> list[Path]:
        """Its zips."""
        return [file for file in _files(self.place) if file.suffix == ".zip"]

    def parcels(self) -> list[bytes]:
        """The zips that `hand_in()` made, or that say so."""
        found = [file for file in self.archives() if "manifest.json" in _names(file)]
        for file in found:
            if file.stat().st_size > 2 * LARGEST:
                raise ValueError(f"{file.name} is larger than {2 * LARGEST >> 20} MB")
        return [file.read_bytes() for file in found]

    def names(self) -> list[str]:
        """What the files are called, those in a zip too."""
        return [name for file in _files(self.place) for name in (_names(file) if file.suffix == ".zip" else [file.name])]

    def notebooks(self, scratch: Path) -> list[Path]:
        """The notebooks, unpacked into `scratch` where they come in a zip; ValueError for a bad or huge zip."""
        for number, archive in enumerate(self.archives()):
            _unpack(archive, scratch / str(number))
        found = [*_files(self.place), *_files(scratch)]
        return [file for file in found if file.suffix == ".ipynb" and ".ipynb_checkpoints" not in file.parts]


def _names(archive: Path) -> list[str]:
    try:
        with zipfile.ZipFile(archive) as opened:
            return [Path(name).name for name in opened.namelist()]
    except (zipfile.BadZipFile, NotImplementedError, OSError):
        return []


def find_submissions(folder: Path) -> list[Submission]:
    """Every submission in a folder, by student."""
    found = []
    for entry in sorted(folder.iterdir()):
        if entry.name.startswith(".") or entry.is_symlink():
            continue
        if entry.is_dir() or entry.suffix in (".ipynb", ".zip"):
            found.append(Submission(entry.stem if entry.is_file() else entry.name, entry))
    return found


def read_notebook(file: Path) -> dict[str, Any]:
    """A notebook's JSON; ValueError when it is none."""
    if file.stat().st_size > LARGEST:
        raise ValueError(f"{file.name} is larger than {LARGEST >> 20} MB")
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{file.name} is no notebook: {error}") from None
    if not isinstance(found, dict) or not isinstance(found.get("cells"), list):
        raise ValueError(f"{file.name} is no notebook of format 4: it has no list of cells")
    return found


def _files(place: Path) -> Iterator[Path]:
    """Regular files, without following links."""
    if place.is_file() and not place.is_symlink():
        yield place
    elif place.is_dir():
        for entry in sorted(place.iterdir()):
            if not entry.is_symlink() and (entry.is_dir() or stat.S_ISREG(entry.lstat().st_mode)):
                yield from _files(entry)


def _unpack(archive: Path, target: Path) -> None:
    """Unpack notebooks only: no links, no way out of the folder, no bombs."""
    try:
        with zipfile.ZipFile(archive) as opened:
            members = [one for one in opened.infolist() if one.filename.endswith(".ipynb")]
            if sum(one.file_size for one in members) > LARGEST or len(members) > 200:
                raise ValueError(f"{archive.name} unpacks to more than {LARGEST >> 20} MB")
            for number, member in enumerate(members):
                place = target / str(number) / Path(member.filename.replace("\\", "/")).name
                place.parent.mkdir(parents=True, exist_ok=True)
                with opened.open(member) as data, open(place, "wb") as out:
                    shutil.copyfileobj(data, out, 1 << 16)
                os.utime(place, (archive.stat().st_mtime,) * 2)
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError) as error:
        raise ValueError(f"{archive.name} is no zip that can be opened: {error}") from None
