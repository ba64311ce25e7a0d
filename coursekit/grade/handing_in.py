"""`hand_in()` and `coursekit verify`: a clean run of the saved notebook, one file to hand in, and whether it was changed."""

from __future__ import annotations

import getpass
import json
import platform
import re
import tempfile
import time
from collections.abc import Mapping
from dataclasses import asdict
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from . import events
from .exercise import exercises_in
from .mark import Marked, mark
from .parcel import EVENTS, cell_digests, digest_of, other_hands, other_results, pack_parcel, parcel_faults, read_parcel
from .roster import student_word
from .sandbox import Limits
from .submissions import Submission, read_notebook
from .variants import Variants

EVIDENCE = re.compile(r"\w+_evidence_s\w+\.(png|pdf)")


def who_and_where() -> dict[str, str]:
    """User, host and time, as they stand on evidence."""
    return {"user": getpass.getuser(), "host": platform.node(), "time": time.strftime("%Y-%m-%d %H:%M:%S %z")}


def clean_run(notebook: Path, source: Mapping[str, Any] | None = None) -> Marked:
    """The mark of a notebook that is run from top to bottom in a sandbox; `source` is the course's own, if it is at hand."""
    found = read_notebook(notebook)
    exercises = exercises_in(found if source is None else source)
    with tempfile.TemporaryDirectory() as scratch:
        place = Path(scratch) / "me"
        place.mkdir()
        (place / notebook.name).write_bytes(notebook.read_bytes())
        return mark(Submission("me", place), {notebook.name: dict(source or found)}, exercises, Limits())


def make_parcel(notebook: Path, course: Path, student: str, out: Path) -> tuple[Path, Marked]:
    """Run the notebook afresh and write the parcel; where it is, and the mark."""
    marked = clean_run(notebook)
    file = out / f"{student_word(student)}_{notebook.stem}.zip"
    file.write_bytes(parcel_of(notebook, course, student, marked))
    return file, marked


def parcel_of(notebook: Path, course: Path, student: str, marked: Marked) -> bytes:
    """The parcel with a notebook, the course's pictures and log, and the mark of a clean run."""
    files = {notebook.name: notebook.read_bytes()}
    for picture in sorted((course / "evidence").glob("*")):
        if EVIDENCE.fullmatch(picture.name):
            files[f"evidence/{picture.name}"] = picture.read_bytes()
    log = course / ".coursekit" / EVENTS
    events.note(log, "hand_in", notebook=notebook.name, sha256=digest_of(files[notebook.name]))
    files[EVENTS] = log.read_bytes() if log.exists() else b""
    facts = {
        "student": student,
        **who_and_where(),
        "coursekit": _version(),
        "notebook": notebook.name,
        "cells": cell_digests(read_notebook(notebook)),
        "verdicts": [asdict(one) for one in marked.verdicts],
        "points": marked.total(),
        "of": sum(one.of for one in marked.verdicts),
        "tier": marked.tier,
    }
    return pack_parcel(files, facts)


def verify(
    file: Path, notebooks: Path | None = None, *, run: bool = True, variants: Variants | None = None
) -> tuple[list[str], Marked | None]:
    """What is wrong with a parcel, and the mark that it really earns (None when it was not run)."""
    data = file.read_bytes()
    found = parcel_faults(data)
    try:
        found += other_hands(data, file.stem)
        manifest, files = read_parcel(data)
        name = Path(str(manifest["notebook"])).name
        content = files[name]
    except (ValueError, KeyError) as error:
        return found or [f"it has no notebook: {error}"], None
    if not run:
        return found, None
    with tempfile.TemporaryDirectory() as scratch:
        handed_in = Path(scratch) / name
        handed_in.write_bytes(content)
        source = notebooks / name if notebooks is not None else None
        own = json.loads(source.read_text(encoding="utf-8")) if source is not None and source.is_file() else None
        if own is not None and variants is not None:
            student = variants.roster.find(file.stem) or variants.roster.find(str(manifest.get("student")))
            own = variants.copies(student, {name: own})[name] if student else own
        try:
            if cell_digests(read_notebook(handed_in)) != manifest.get("cells"):
                found.append(f"{name}: its cells are not those of the manifest")
            marked = clean_run(handed_in, own)
        except ValueError as error:
            return [*found, str(error)], None
    return found + other_results(manifest, {one.name: one.points for one in marked.verdicts}), marked


def _version() -> str:
    try:
        return version("coursekit")
    except PackageNotFoundError:
        return "unknown"
