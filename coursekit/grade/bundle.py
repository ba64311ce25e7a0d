"""The submission bundle, one file: the notebook, pictures, the log, and a manifest with the mark of a clean run.

The seal proves that the bundle is as the student's `hand_in()` wrote it, unless someone made the seal again. It does
not prove who that was, or when (the clock is the student's): everything needed for a seal is on the student's
computer. So the mark that counts comes from running the notebook again, and the bundles of a class are compared: a
log or a picture handed in by two people is reported, regardless of its seal.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path, PurePosixPath
from typing import Any

from . import events
from .archives import Archive, Bounds
from .recognising import text_of
from .roster import plain, student_word
from .sanitizing import shown

MANIFEST, EVENTS = "manifest.json", "events.jsonl"
LARGEST = 100 << 20
"""The maximum size of a bundle [bytes]."""
_MOST_PARTS = 600_000
_DATE = (1980, 1, 1, 0, 0, 0)


def pack_bundle(files: Mapping[str, bytes], facts: Mapping[str, Any]) -> bytes:
    """Make a bundle of these files; the same contents give the same bytes.

    >>> manifest, files = read_bundle(pack_bundle({"02_topics.ipynb": b"{}"}, {"student": "Ada"}))
    >>> manifest["student"], files
    ('Ada', {'02_topics.ipynb': b'{}'})
    """
    listed = {name: digest_of(data) for name, data in sorted(files.items())}
    manifest: dict[str, Any] = {**facts, "files": listed}
    manifest["seal"] = events.digest(manifest)
    return _zipped({MANIFEST: _text(manifest), **{name: files[name] for name in listed}})


def cell_digests(notebook: Mapping[str, Any]) -> list[str]:
    r"""Return a digest of the text of each cell.

    >>> one, other = cell_digests({"cells": [{"source": ["a = 1\n"]}, {"source": "a = 1\n"}]})
    >>> one == other
    True
    """
    return [hashlib.sha256(text_of(cell).encode("utf-8", "replace")).hexdigest() for cell in notebook.get("cells", [])]


def read_bundle(data: bytes) -> tuple[dict[str, Any], dict[str, bytes]]:
    """Return the manifest and the files; ValueError when the data is not a bundle."""
    if len(data) > LARGEST:
        raise ValueError(f"it is larger than {LARGEST >> 20} MB")
    try:
        with Archive(io.BytesIO(data), Bounds(file=LARGEST, total=LARGEST)) as opened:
            files = {member.info.filename: opened.read(member) for member in opened.members()}
        for name, most in ((MANIFEST, 4 << 20), (EVENTS, 16 << 20)):
            _expect_plain(name, files.get(name, b""), most)
        manifest = json.loads(files.pop(MANIFEST))
    except (KeyError, ValueError, RecursionError) as error:
        raise ValueError(f"it is not a submission bundle made by hand_in(): {shown(str(error))}") from None
    if not isinstance(manifest, dict) or not isinstance(manifest.get("files"), dict):
        raise ValueError("its manifest is not an object with a list of files")
    return manifest, files


def _expect_plain(name: str, text: bytes, most: int) -> None:
    """Before JSON is parsed, check its length and its number of elements, each of which costs memory."""
    if len(text) > most or sum(text.count(mark) for mark in (b"[", b"{", b",")) > _MOST_PARTS:
        raise ValueError(f"{name} is longer than hand_in() makes it")


def bundle_faults(data: bytes) -> list[str]:
    """Return all signs that a bundle was changed after it was made."""
    try:
        return [shown(fault) for fault in _faults(data)]
    except ValueError as error:
        return [str(error)]
    except (TypeError, LookupError, AttributeError, RecursionError):
        return ["its manifest or its log is not as hand_in() writes them"]


def _faults(data: bytes) -> list[str]:
    manifest, files = read_bundle(data)
    faults = [f"{name}: is missing" for name in manifest["files"] if name not in files]
    for name, content in files.items():
        if name not in manifest["files"]:
            faults.append(f"{name}: was put in afterwards")
        elif digest_of(content) != manifest["files"][name]:
            faults.append(f"{name}: was changed")
    if events.digest({key: value for key, value in manifest.items() if key != "seal"}) != manifest.get("seal"):
        faults.append(f"{MANIFEST}: was changed")
    faults += events.faults(_lines(files))
    faults += [] if faults else _untold(files)
    if not faults and _zipped({MANIFEST: _text(manifest), **{name: files[name] for name in manifest["files"]}}) != data:
        faults.append("the zip was packed again")
    return faults


def _lines(files: Mapping[str, bytes]) -> list[str]:
    return files.get(EVENTS, b"").decode(errors="replace").splitlines()


def _untold(files: Mapping[str, bytes]) -> list[str]:
    """Return the pictures and notebooks that differ from their entries in the log."""
    lines = [json.loads(line) for line in _lines(files)]
    digest_by_name = {
        str(entry.get("picture") or entry.get("notebook")): entry["sha256"] for entry in lines if "sha256" in entry
    }
    pairs = {
        name: (digest_of(data), digest_by_name.get(PurePosixPath(name).name))
        for name, data in files.items()
        if name != EVENTS
    }
    return [
        f"{name}: it was changed after its entry in {EVENTS}" if told else f"{name}: {EVENTS} does not tell of it"
        for name, (is_now, told) in pairs.items()
        if told != is_now
    ]


def other_hands(data: bytes, name: str) -> list[str]:
    """Return signs that a bundle handed in as `name` belongs to another student; ValueError when it is not a bundle."""
    manifest, files = read_bundle(data)
    student = str(manifest.get("student"))
    signs = []
    if not any(plain(word) in plain(name) for word in student.split()):
        signs.append(f"it was made by '{student[:60]}' and handed in as '{name}'")
    word = student_word(student)
    strange = [file for file in files if file.startswith("evidence/") and not file.startswith(f"evidence/{word}_")]
    return signs + [f"{name}: the name is not that of '{student[:60]}'" for name in strange]


def other_results(manifest: Mapping[str, Any], earned: Mapping[str, float]) -> list[str]:
    """Return the differences between the recorded points and those of another run.

    >>> other_results({"verdicts": [{"name": "relay", "points": 2.0}], "points": 2.0}, {"relay": 1.0})
    ['relay: 2 points are recorded, a clean run earns 1', '2 points are recorded in all, a clean run earns 1']
    """
    said = recorded(manifest)
    differences = [
        f"{name}: {_points(said.get(name))} points are recorded, a clean run earns {points:g}"
        for name, points in earned.items()
        if said.get(name) != points
    ]
    total = round(sum(earned.values()), 2)
    if manifest.get("points") != total:
        differences.append(f"{_points(manifest.get('points'))} points are recorded in all, a clean run earns {total:g}")
    return differences


def _points(said: Any) -> str:
    """Format the points of a manifest; 'no' where there are none."""
    return f"{said:g}" if isinstance(said, (int, float)) and abs(said) < 1e6 else shown(str(said), 20) if said else "no"


def recorded(manifest: Mapping[str, Any]) -> dict[str, Any]:
    """Return the points in a manifest, by exercise.

    >>> recorded({"verdicts": [{"name": "relay", "points": 1.5}]})
    {'relay': 1.5}
    """
    said = manifest.get("verdicts")
    listed = said if isinstance(said, list) else []
    return {str(verdict.get("name")): verdict.get("points") for verdict in listed if isinstance(verdict, dict)}


def traces(data: bytes) -> dict[str, str]:
    """Return the parts unique to a student: digests of pictures and log lines, with their names."""
    _, files = read_bundle(data)
    traces = {digest_of(content): name for name, content in files.items() if name.startswith("evidence/")}
    for number, line in enumerate(_lines(files), 1):
        traces[digest_of(_happened(line))] = f"line {number} of {EVENTS}"
    return traces


def _happened(line: str) -> bytes:
    """Return the content of a log line without its place in the chain, which is easily made again."""
    try:
        facts = json.loads(line)
        return json.dumps({k: v for k, v in facts.items() if k not in ("before", "digest")}, sort_keys=True).encode()
    except (ValueError, AttributeError, RecursionError):
        return line.encode()


def note_copies(owners: Mapping[str, tuple[list[str], Sequence[Path]]]) -> None:
    """Add to each person's concerns who else handed in the same pictures or log, regardless of the seals."""
    traces_by_owner: dict[str, dict[str, str]] = {}
    for who, (_, files) in owners.items():
        for file in files:
            with contextlib.suppress(ValueError, OSError):
                traces_by_owner.setdefault(who, {}).update(traces(file.read_bytes()))
    shared: dict[str, list[str]] = {}
    for who, traced in traces_by_owner.items():
        for digest in traced:
            shared.setdefault(digest, []).append(who)
    for who, traced in traces_by_owner.items():
        others: dict[str, list[str]] = {}
        for digest, what in traced.items():
            for other in shared[digest]:
                if other != who:
                    others.setdefault(other, []).append(what)
        owners[who][0].extend(f"the same as in {other}'s: {', '.join(what[:3])}" for other, what in others.items())


def digest_of(data: bytes) -> str:
    """Return the digest of a file."""
    return hashlib.sha256(data).hexdigest()


def _text(manifest: Mapping[str, Any]) -> bytes:
    return json.dumps(manifest, indent=1, sort_keys=True).encode()


def _zipped(files: Mapping[str, bytes]) -> bytes:
    """Return an uncompressed zip in this order, without dates: it does not depend on the machine."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_STORED) as packed:
        for name, data in files.items():
            packed.writestr(zipfile.ZipInfo(name, _DATE), data)
    return buffer.getvalue()
