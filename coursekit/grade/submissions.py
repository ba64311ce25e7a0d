"""The work to mark: plain copies of a person's files that count; or a folder, notebook or zip as it is."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .archives import Archive, BadArchive
from .bundle import LARGEST as LARGEST_BUNDLE
from .bundle import MANIFEST
from .recognising import LARGEST, parse_notebook
from .safe_walk import Walked, open_plain, walk


@dataclass(frozen=True)
class Submission:
    """The submission of one student."""

    student: str
    place: Path
    chosen: dict[str, Path] = field(default_factory=dict)
    """The file that counts, by the chapter's file name: a plain copy of bounded size."""
    bundle_files: list[Path] = field(default_factory=list)
    """Plain copies of the `hand_in()` files that contained them."""
    notes: list[str] = field(default_factory=list)
    concerns: list[str] = field(default_factory=list)

    def as_json(self) -> dict[str, Any]:
        """Return plain values for another process, which `of_json` reads."""
        return {
            "student": self.student,
            "place": str(self.place),
            "chosen": {name: str(file) for name, file in self.chosen.items()},
            "bundle_files": [str(file) for file in self.bundle_files],
            "notes": self.notes,
            "concerns": self.concerns,
        }

    @classmethod
    def of_json(cls, said: dict[str, Any]) -> Submission:
        """Make a submission from the dictionary of `as_json`."""
        chosen = {str(name): Path(file) for name, file in said["chosen"].items()}
        bundles = [Path(file) for file in said["bundle_files"]]
        return cls(said["student"], Path(said["place"]), chosen, bundles, list(said["notes"]), list(said["concerns"]))

    def digest(self) -> str:
        """Return a digest of all submitted files."""
        digest = hashlib.sha256()
        if self.chosen:
            for name, file in sorted(self.chosen.items()):
                digest.update(f"{name}\0".encode() + _bytes(file, LARGEST))
            for file in self.bundle_files:
                digest.update(b"\0bundle\0" + _bytes(file, LARGEST_BUNDLE))
            return digest.hexdigest()
        for path in walk(self.place):
            digest.update("/".join(path.parts).encode("utf-8", "surrogateescape") + b"\0")
            if path.open is not None:
                with path.open() as data:
                    while piece := data.read(1 << 16):
                        digest.update(piece)
        return digest.hexdigest()

    def bundles(self) -> list[bytes]:
        """Return the zips with the manifest of `hand_in()`."""
        if self.chosen or self.bundle_files:
            return [_bytes(file, LARGEST_BUNDLE) for file in self.bundle_files]
        bundles = []
        for path in walk(self.place):
            data = _zip(path)
            if data is not None and _says_bundle(path):
                bundles.append(data)
        return bundles

    def notebooks(self, scratch: Path) -> list[Path]:
        """Return plain copies of the notebooks, including those in a zip; ValueError for an invalid or huge one."""
        if self.chosen:
            counts = enumerate(self.chosen.items())
            return [_copy(_bytes(file, LARGEST), scratch / str(at) / name) for at, (name, file) in counts]
        paths = []
        for number, path in enumerate(walk(self.place)):
            name = path.parts[-1]
            if path.open is None or name.startswith("._") or ".ipynb_checkpoints" in path.parts:
                continue
            if name.endswith(".ipynb"):
                with path.open() as data:
                    paths.append(_copy(_whole(data.read(LARGEST + 1), name), scratch / str(number) / name[:120]))
            elif name.endswith(".zip"):
                paths += _unpacked(path, scratch / str(number))
        return paths


def _bytes(file: Path, most: int) -> bytes:
    with open_plain(file) as data:
        return _whole(data.read(most + 1), file.name, most)


def _whole(data: bytes, name: str, most: int = LARGEST) -> bytes:
    if len(data) > most:
        raise ValueError(f"{name} is larger than {most >> 20} MB")
    return data


def _copy(data: bytes, file: Path) -> Path:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(data)
    return file


def _zip(walked: Walked) -> bytes | None:
    if walked.open is None or not walked.parts[-1].endswith(".zip"):
        return None
    with walked.open() as data:
        return _whole(data.read(LARGEST_BUNDLE + 1), walked.parts[-1], LARGEST_BUNDLE)


def _says_bundle(walked: Walked) -> bool:
    """Whether a zip has a manifest at the place used by `hand_in()`."""
    assert walked.open is not None
    try:
        with Archive(walked.open()) as opened:
            return any(member.parts == (MANIFEST,) for member in opened.members())
    except BadArchive:
        return False


def _unpacked(walked: Walked, scratch: Path) -> list[Path]:
    assert walked.open is not None
    paths = []
    try:
        with Archive(walked.open()) as opened:
            for number, member in enumerate(opened.members()):
                name = member.parts[-1]
                left = name.startswith("._") or ".ipynb_checkpoints" in member.parts
                if name.endswith(".ipynb") and not left:
                    paths.append(_copy(opened.read(member, LARGEST), scratch / str(number) / name[-120:]))
    except BadArchive as error:
        raise ValueError(f"{walked.parts[-1]} is no zip that can be opened: {error}") from None
    return paths


def read_notebook(file: Path) -> dict[str, Any]:
    """Read a notebook's JSON; ValueError when it is not a notebook."""
    with open_plain(file) as data:
        return parse_notebook(data.read(LARGEST + 1), file.name)
