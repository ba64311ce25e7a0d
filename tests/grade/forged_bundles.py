"""Files made by `hand_in()` that were changed afterwards, each in its own way; and an honest one.

The student of each has solved half of the exercises: `honest("Ann Lee", notebook)` records what a clean run earns.
"""

from __future__ import annotations

import functools
import json
import tempfile
from pathlib import Path
from typing import Any

from coursekit.grade import events
from coursekit.grade.bundle import EVENTS, MANIFEST, _text, _zipped, digest_of, pack_bundle, read_bundle
from coursekit.grade.handing_in import bundle_of, clean_run
from coursekit.grade.mark import Marked
from coursekit.grade.roster import student_word

Parts = tuple[dict[str, Any], dict[str, bytes]]
NAME = "02_topics.ipynb"


@functools.cache
def _run(text: str) -> Marked:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, NAME)
        file.write_text(text, encoding="utf-8")
        return clean_run(file)


def honest(student: str, half: str, _right: str) -> bytes:
    """The bundle of somebody who solved half."""
    with tempfile.TemporaryDirectory() as folder:
        file, log = Path(folder, NAME), Path(folder, ".coursekit", EVENTS)
        file.write_text(half, encoding="utf-8")
        picture = Path(folder, "evidence", f"{student_word(student)}_evidence_s2.png")
        picture.parent.mkdir()
        picture.write_bytes(b"\x89PNG " + student.encode())
        events.note(log, "evidence", picture=picture.name, sha256=digest_of(picture.read_bytes()))
        events.note(log, "check", name="ch02.q3", points=0)
        return bundle_of(file, Path(folder), student, _run(half))


def _parts(student: str, half: str) -> Parts:
    return read_bundle(honest(student, half, ""))


def _packed(manifest: dict[str, Any], files: dict[str, bytes]) -> bytes:
    """Zipped again, the manifest as it is."""
    return _zipped({MANIFEST: _text(manifest), **files})


def _sealed(manifest: dict[str, Any], files: dict[str, bytes]) -> bytes:
    """Zipped again, all digests of the manifest made anew."""
    return pack_bundle(files, {name: value for name, value in manifest.items() if name not in ("files", "seal")})


def _picture(files: dict[str, bytes]) -> str:
    return next(name for name in files if name.startswith("evidence/"))


def notebook_exchanged(student: str, half: str, right: str) -> bytes:
    """A better notebook in the place of the one that was handed in."""
    manifest, files = _parts(student, half)
    return _packed(manifest, {**files, NAME: right.encode()})


def picture_exchanged(student: str, half: str, _right: str) -> bytes:
    """Another picture."""
    manifest, files = _parts(student, half)
    return _packed(manifest, {**files, _picture(files): b"\x89PNG of somebody else"})


def picture_resealed(student: str, half: str, _right: str) -> bytes:
    """Another picture, and the manifest made anew."""
    manifest, files = _parts(student, half)
    return _sealed(manifest, {**files, _picture(files): b"\x89PNG by " + student[::-1].encode()})


def _raised(manifest: dict[str, Any]) -> dict[str, Any]:
    verdicts = [{**verdict, "points": verdict["of"]} for verdict in manifest["verdicts"]]
    return {**manifest, "verdicts": verdicts, "points": manifest["of"]}


def marks_raised(student: str, half: str, _right: str) -> bytes:
    """Full marks in the manifest."""
    manifest, files = _parts(student, half)
    return _packed(_raised(manifest), files)


def all_resealed(student: str, half: str, _right: str) -> bytes:
    """Full marks in the manifest and in the log, and every digest and chain made anew."""
    manifest, files = _parts(student, half)
    lines, before = [], events.BEGINNING
    for text in files[EVENTS].decode().splitlines():
        line = {**json.loads(text), "before": before}
        line.pop("digest")
        line |= {"points": 2} if line["event"] == "check" else {}
        before = events.digest(line)
        lines.append(json.dumps({**line, "digest": before}, sort_keys=True) + "\n")
    return _sealed(_raised(manifest), {**files, EVENTS: "".join(lines).encode()})


@functools.cache
def _of_vera(half: str) -> bytes:
    return honest("Vera Course", half, "")


def borrowed(_student: str, half: str, _right: str) -> bytes:
    """A classmate's, under one's own name."""
    return _of_vera(half)


def resealed(bundle: bytes, student: str) -> bytes:
    """Vera's under another name, everything sealed anew: names, log and manifest."""
    manifest, files = read_bundle(bundle)
    word = "".join(student.split())
    files = {name.replace("VeraCourse", word): data for name, data in files.items()}
    before, lines = events.BEGINNING, []
    for text in files[EVENTS].decode().splitlines():
        line = {**json.loads(text.replace("VeraCourse", word)), "before": before}
        line.pop("digest")
        before = events.digest(line)
        lines.append(json.dumps({**line, "digest": before}, sort_keys=True) + "\n")
    return _sealed({**manifest, "student": student}, {**files, EVENTS: "".join(lines).encode()})


def sealed_as_own(student: str, half: str, _right: str) -> bytes:
    """A classmate's with one's own name in it."""
    return resealed(_of_vera(half), student)
