"""`hand_in()` and `coursekit verify`: a clean run of the saved notebook, the file to hand in, and its verification."""

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
from pathlib import Path, PurePosixPath
from typing import Any

from coursekit.files import write_whole

from . import events
from .bundle import (
    EVENTS,
    bundle_faults,
    cell_digests,
    digest_of,
    note_copies,
    other_hands,
    other_results,
    pack_bundle,
    read_bundle,
)
from .editions import notebooks_folder
from .exercise import exercises_in
from .identifying import named_in
from .mark import Marked, mark
from .recognising import Recogniser, parse_notebook
from .roster import student_word
from .sandbox import Limits
from .sanitizing import shown
from .submissions import Submission, read_notebook
from .variants import Variants, checks_in

EVIDENCE = re.compile(r"\w+_evidence_s\w+\.(png|pdf)")


def who_and_where() -> dict[str, str]:
    """Return user, host and time, as on evidence."""
    return {"user": getpass.getuser(), "host": platform.node(), "time": time.strftime("%Y-%m-%d %H:%M:%S %z")}


def clean_run(notebook: Path, source: Mapping[str, Any] | None = None) -> Marked:
    """Mark a notebook by running it from top to bottom in a sandbox; `source` is the course's own, if available."""
    submitted = read_notebook(notebook)
    exercises = exercises_in(submitted if source is None else source)
    with tempfile.TemporaryDirectory() as scratch:
        place = Path(scratch) / "me"
        place.mkdir()
        (place / notebook.name).write_bytes(notebook.read_bytes())
        return mark(Submission("me", place), {notebook.name: dict(source or submitted)}, exercises, Limits())


def make_bundle(
    notebook: Path, course: Path, student: str, out: Path, notebooks: Path | None = None
) -> tuple[Path, Marked]:
    """Run the notebook from scratch and write the bundle. Returns its path, and the mark with notes on missing parts.

    Raises:
        ValueError: when nothing in the notebook could be marked.
    """
    known = Recogniser(_chapters(notebooks))
    notes = missing_checks(notebook.name, read_notebook(notebook), known)
    if not checks_in(read_notebook(notebook)):
        names = ", ".join(known.chapters)
        what = "holds no check of the course: nothing in it can be marked"
        raise ValueError(f"{notebook.name} {what}. Hand in one of: {names}")
    marked = clean_run(notebook)
    file = out / f"{student_word(student)}_{notebook.stem}.zip"
    write_whole(file, bundle_of(notebook, course, student, marked))
    if not any(EVIDENCE.fullmatch(path.name) for path in (course / "evidence").glob("*")):
        how = 'evidence("s2_1", graph()), then hand_in() again'
        notes.append(f"There is no evidence in it. If the assignment asks for some: {how}.")
    marked.notes += notes
    return file, marked


def missing_checks(name: str, notebook: Mapping[str, Any], known: Recogniser) -> list[str]:
    """Return notes on the chapter's checks that a notebook lacks."""
    chapter = known.chapters.get(known.recognise(notebook).chapter or known.by_name(name))
    lost = sorted(set(checks_in(chapter.source)) - set(checks_in(notebook))) if chapter else []
    if not lost:
        return []
    return [f"{name}: its checks of {', '.join(lost)} were taken out. They stand in the chapter as it was handed out."]


def _chapters(notebooks: Path | None) -> dict[str, Any]:
    """Return the chapters of the course, by file name."""
    if notebooks is None:
        notebooks = notebooks_folder()
    return {file.name: json.loads(file.read_text(encoding="utf-8")) for file in sorted(notebooks.glob("*.ipynb"))}


def bundle_of(notebook: Path, course: Path, student: str, marked: Marked) -> bytes:
    """Return the bundle of a notebook, the course's pictures and log, and the mark of a clean run."""
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
        "verdicts": [asdict(verdict) for verdict in marked.verdicts],
        "points": marked.total(),
        "of": sum(verdict.of for verdict in marked.verdicts),
        "tier": marked.tier,
    }
    return pack_bundle(files, facts)


def verify(
    file: Path, notebooks: Path | None = None, *, run: bool = True, variants: Variants | None = None
) -> tuple[list[str], Marked | None]:
    """Return the faults of a bundle, and the mark that it really earns (None when it was not run).

    The run uses the course's own notebook with the student's answers; an unknown file name is refused.
    """
    data = file.read_bytes()
    faults = bundle_faults(data)
    try:
        faults += other_hands(data, file.stem)
        manifest, files = read_bundle(data)
        name = PurePosixPath(str(manifest["notebook"])).name
        content = files[name]
        handed_in = parse_notebook(content, name)
    except (ValueError, KeyError) as error:
        return faults or [f"it has no notebook: {shown(str(error))}"], None
    known = Recogniser(_chapters(notebooks))
    if name not in known.chapters:
        faults.append(_no_chapter(name, known.recognise(handed_in).chapter, known))
        return faults, None
    faults += missing_checks(name, handed_in, known)
    if cell_digests(handed_in) != manifest.get("cells"):
        faults.append(f"{name}: its cells are not those of the manifest")
    if not run:
        return faults, None
    own = dict(known.chapters[name].source)
    if variants is not None:
        student = named_in(file.stem, variants.roster) or named_in(str(manifest.get("student")), variants.roster)
        if not student:
            return [*faults, "its name is not in the list: without a name its numbers are not known"], None
        own = variants.copies(student, {name: own})[name]
    with tempfile.TemporaryDirectory() as scratch:
        place = Path(scratch) / name
        place.write_bytes(content)
        marked = clean_run(place, own)
    return faults + other_results(manifest, {verdict.name: verdict.points for verdict in marked.verdicts}), marked


def _no_chapter(name: str, chapter: str, known: Recogniser) -> str:
    like = f" It looks like {chapter}: ask for it under that name." if chapter else ""
    return f"'{shown(name, 60)}' is no chapter of the course.{like} There are: {', '.join(known.chapters)}."


def same_in(bundles: Mapping[str, Path]) -> list[str]:
    """Return the parts shared by several bundles that should be unique to a student."""
    concerns: dict[str, list[str]] = {name: [] for name in bundles}
    note_copies({name: (concerns[name], [file]) for name, file in bundles.items()})
    return [f"{name}: {said}" for name, listed in concerns.items() for said in listed]


def _version() -> str:
    try:
        return version("coursekit")
    except PackageNotFoundError:
        return "unknown"
