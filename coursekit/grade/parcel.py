"""The one file that a student hands in: the notebook, pictures, what happened, and a manifest with the mark of a clean run.

It shows changes, it does not prevent them: the mark that counts comes from running the notebook again.
"""

from __future__ import annotations

import hashlib
import io
import json
import zipfile
from collections.abc import Mapping
from pathlib import PurePosixPath
from typing import Any

from . import events
from .roster import plain, student_word

MANIFEST, EVENTS = "manifest.json", "events.jsonl"
LARGEST = 100 << 20
"""Bytes of a parcel."""
_DATE = (1980, 1, 1, 0, 0, 0)


def pack_parcel(files: Mapping[str, bytes], facts: Mapping[str, Any]) -> bytes:
    """A parcel with these files; the same contents give the same bytes."""
    listed = {name: digest_of(data) for name, data in sorted(files.items())}
    manifest: dict[str, Any] = {**facts, "files": listed}
    manifest["seal"] = events.digest(manifest)
    return _zipped({MANIFEST: _text(manifest), **{name: files[name] for name in listed}})


def cell_digests(notebook: Mapping[str, Any]) -> list[str]:
    """A digest of the text of each cell."""
    return [hashlib.sha256("".join(cell.get("source", "")).encode()).hexdigest() for cell in notebook.get("cells", [])]


def read_parcel(data: bytes) -> tuple[dict[str, Any], dict[str, bytes]]:
    """The manifest and the files; ValueError when it is no parcel."""
    if len(data) > LARGEST:
        raise ValueError(f"it is larger than {LARGEST >> 20} MB")
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as opened:
            if sum(one.file_size for one in opened.infolist()) > LARGEST:
                raise ValueError(f"it unpacks to more than {LARGEST >> 20} MB")
            files = {one.filename: opened.read(one) for one in opened.infolist()}
        manifest = json.loads(files.pop(MANIFEST))
    except (zipfile.BadZipFile, KeyError, NotImplementedError, RuntimeError, OSError, EOFError) as error:
        raise ValueError(f"it is no parcel made by hand_in(): {error}") from None
    if not isinstance(manifest, dict) or not isinstance(manifest.get("files"), dict):
        raise ValueError("its manifest is none")
    return manifest, files


def parcel_faults(data: bytes) -> list[str]:
    """Every sign that it was changed after it was made."""
    try:
        manifest, files = read_parcel(data)
    except ValueError as error:
        return [str(error)]
    found = [f"{name}: is missing" for name in manifest["files"] if name not in files]
    for name, content in files.items():
        if name not in manifest["files"]:
            found.append(f"{name}: was put in afterwards")
        elif digest_of(content) != manifest["files"][name]:
            found.append(f"{name}: was changed")
    if events.digest({key: value for key, value in manifest.items() if key != "seal"}) != manifest.get("seal"):
        found.append(f"{MANIFEST}: was changed")
    found += events.faults(_lines(files))
    found += [] if found else _untold(files)
    if not found and _zipped({MANIFEST: _text(manifest), **{name: files[name] for name in manifest["files"]}}) != data:
        found.append("the zip was packed anew")
    return found


def _lines(files: Mapping[str, bytes]) -> list[str]:
    return files.get(EVENTS, b"").decode(errors="replace").splitlines()


def _untold(files: Mapping[str, bytes]) -> list[str]:
    """Pictures and notebooks that are not as the log says they were made."""
    lines = [json.loads(line) for line in _lines(files)]
    made = {str(one.get("picture") or one.get("notebook")): one["sha256"] for one in lines if "sha256" in one}
    found = {name: (digest_of(data), made.get(PurePosixPath(name).name)) for name, data in files.items() if name != EVENTS}
    return [
        f"{name}: it was changed since {EVENTS} tells of it" if told else f"{name}: {EVENTS} does not tell of it"
        for name, (is_now, told) in found.items()
        if told != is_now
    ]


def other_hands(data: bytes, name: str) -> list[str]:
    """Signs that it is somebody else's, when it was handed in as `name`; ValueError when it is no parcel."""
    manifest, files = read_parcel(data)
    student = str(manifest.get("student"))
    found = []
    if not any(plain(word) in plain(name) for word in student.split()):
        found.append(f"it was made by '{student[:60]}' and handed in as '{name}'")
    word = student_word(student)
    strange = [one for one in files if one.startswith("evidence/") and not one.startswith(f"evidence/{word}_")]
    return found + [f"{one}: the name is not that of '{student[:60]}'" for one in strange]


def other_results(manifest: Mapping[str, Any], earned: Mapping[str, float]) -> list[str]:
    """Where the marks that were recorded are not those of another run."""
    said = recorded(manifest)
    found = [
        f"{name}: {said.get(name, 'no')} points are recorded, a clean run earns {points:g}"
        for name, points in earned.items()
        if said.get(name) != points
    ]
    total = round(sum(earned.values()), 2)
    if manifest.get("points") != total:
        found.append(f"{manifest.get('points')} points are recorded in all, a clean run earns {total:g}")
    return found


def recorded(manifest: Mapping[str, Any]) -> dict[str, Any]:
    """The points that a manifest says, by exercise."""
    said = manifest.get("verdicts")
    listed = said if isinstance(said, list) else []
    return {str(one.get("name")): one.get("points") for one in listed if isinstance(one, dict)}


def traces(data: bytes) -> dict[str, str]:
    """What no two students have alike: digests of pictures and of the lines of the log, and what each is called."""
    _, files = read_parcel(data)
    found = {digest_of(content): name for name, content in files.items() if name.startswith("evidence/")}
    for number, line in enumerate(_lines(files), 1):
        found[digest_of(line.encode())] = f"line {number} of {EVENTS}"
    return found


def digest_of(data: bytes) -> str:
    """The digest of a file."""
    return hashlib.sha256(data).hexdigest()


def _text(manifest: Mapping[str, Any]) -> bytes:
    return json.dumps(manifest, indent=1, sort_keys=True).encode()


def _zipped(files: Mapping[str, bytes]) -> bytes:
    """Stored, in this order, without dates: nothing in it depends on the machine."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_STORED) as packed:
        for name, data in files.items():
            packed.writestr(zipfile.ZipInfo(name, _DATE), data)
    return made.getvalue()
