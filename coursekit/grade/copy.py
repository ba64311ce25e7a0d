"""The student's copy of the course: without solutions, and never overwritten once the student has worked on it."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from coursekit.files import write_whole

from .editions import ENGLISH, IMAGES, chapters, read

STUB = "# YOUR CODE HERE\nraise NotImplementedError()"
HANDED_OUT = "handed_out"
"""The metadata key of a notebook for a release by a teacher."""
GIVEN = "given"
"""The metadata key of a notebook for the digests of its solution cells as handed out."""
FIRST = "00_start_here.ipynb"
"""The chapter with which the course opens."""
DATA_STUB = "# YOUR CODE HERE"
"""The stub for data files with comments like Python's: a raise statement would only break the build."""
MARKUP_STUB = "<!-- YOUR CODE HERE -->"
"""The stub for XML files: URDF, xacro, launch files."""
CPP_STUB = "// YOUR CODE HERE"
"""The stub for C++, which compiles."""
_SOLUTION = re.compile(r"^([ \t]*)(?:// )?### BEGIN SOLUTION.*?### END SOLUTION[ \t]*$", re.S | re.M)
_MARKUP = re.compile(r"%%write [^\n]*\.(urdf|xacro|xml|sdf)\s*\n")
_DATA = re.compile(r"%%write [^\n]*\.(msg|srv|action|ya?ml)\s*\n")
_CPP = re.compile(r"%%write [^\n]*\.(cpp|hpp)\s*\n")
_HIDDEN = re.compile(r"^[ \t]*### BEGIN HIDDEN TESTS.*?### END HIDDEN TESTS[ \t]*\n?", re.S | re.M)


def without_solution(source: str) -> str:
    """Replace the solution in a cell's text by a stub.

    >>> print(without_solution("a = 1\\n### BEGIN SOLUTION\\nb = 2\\n### END SOLUTION"))
    a = 1
    # YOUR CODE HERE
    raise NotImplementedError()
    """
    stubs = ((_MARKUP, MARKUP_STUB), (_DATA, DATA_STUB), (_CPP, CPP_STUB))
    text = next((stub for kind, stub in stubs if kind.match(source)), STUB)

    def stub(match: re.Match[str]) -> str:
        return "\n".join(match[1] + line for line in text.splitlines())

    return _HIDDEN.sub("", _SOLUTION.sub(stub, source))


def student_notebook(notebook: dict[str, Any]) -> dict[str, Any]:
    """Return a notebook for students: stubs for solutions, no outputs, locked check cells."""
    student_copy: dict[str, Any] = json.loads(json.dumps(notebook))
    given = {}
    for cell in student_copy["cells"]:
        text = "".join(cell["source"])
        if cell["cell_type"] == "code":
            cell["outputs"] = []
            cell["execution_count"] = None
        cleared = without_solution(text)
        if cell["cell_type"] == "markdown" and cleared != text:
            cleared = cleared.replace(STUB, "*Your answer here.*")
        cell["source"] = cleared.splitlines(keepends=True)
        grading = cell.get("metadata", {}).get("nbgrader", {})
        if grading.get("locked"):
            cell["metadata"] |= {"editable": False, "deletable": False}
        if grading.get("solution"):
            given[str(grading.get("grade_id"))] = given_digest(cleared)
    student_copy.setdefault("metadata", {}).setdefault("coursekit", {})[GIVEN] = given
    return student_copy


def given_digest(text: str) -> str:
    """Return a short digest that identifies a cell's text.

    >>> given_digest("a = 1\\n") == given_digest("a = 1  ")
    True
    """
    return hashlib.sha256(text.strip().encode("utf-8", "replace")).hexdigest()[:16]


def edition_of(text: str) -> str:
    """Return the digest of a notebook's edition, made of its cells' texts: stored outputs do not change it.

    >>> run, not_run = ('{"cells": [{"source": ["1 + 1"], "outputs": %s}]}' % outputs for outputs in ('["2"]', "[]"))
    >>> edition_of(run) == edition_of(not_run)
    True
    """
    cells = json.loads(text)["cells"]
    return hashlib.sha256(json.dumps(["".join(cell["source"]) for cell in cells]).encode()).hexdigest()


def facts_of(notebook: Mapping[str, Any]) -> dict[str, Any]:
    """Return the course's entries in a notebook's metadata: the release, the copy's owner, the cells as given."""
    metadata = notebook.get("metadata")
    facts = metadata.get("coursekit") if isinstance(metadata, dict) else None
    return facts if isinstance(facts, dict) else {}


def _facts(file: Path) -> dict[str, Any]:
    """Return the course's entries in a file's metadata; empty if it is no notebook."""
    try:
        notebook = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return facts_of(notebook) if isinstance(notebook, dict) else {}


def _handed_out(file: Path) -> bool:
    """Whether a teacher released this copy, perhaps with individual values."""
    return HANDED_OUT in _facts(file)


class Course:
    """A student's course folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._manifest = folder / ".coursekit" / "manifest.json"
        self._language = folder / ".coursekit" / "language"

    def language(self) -> str:
        """Return the language code of this copy; that of a release is in its notebooks."""
        if self._language.is_file():
            return self._language.read_text(encoding="utf-8").strip()
        told = (_facts(self.folder / name).get("language") for name in self._from_elsewhere())
        return next((str(name) for name in told if name), ENGLISH)

    def update(self, notebooks: Path, language: str = "") -> list[str]:
        """Add new and changed chapters, in a language or in that of the copy. Returns a sentence for each action.

        A chapter that the student has changed is kept; its new edition is written beside it as `NAME.new.ipynb`.
        Nothing is added to a folder with notebooks from elsewhere, such as a release or a teacher's own chapters.
        """
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / "ros2_ws" / "src").mkdir(parents=True, exist_ok=True)
        if there := self._from_elsewhere():
            if language:
                write_whole(self._language, language + "\n", parents=True)
            return [f"Here already: {', '.join(there)}. No chapters of the course are added to this folder."]
        given = self._read_manifest()
        language, said = language or self.language(), []
        for source in chapters(notebooks, language):
            text = json.dumps(student_notebook(read(source, language)), indent=1) + "\n"
            sentence = self._bring(source.name, text, given)
            if sentence:
                said.append(sentence)
        if (notebooks / IMAGES).is_dir():
            self._copy_beside(notebooks / IMAGES, again=True)
        self._manifest.parent.mkdir(parents=True, exist_ok=True)
        write_whole(self._manifest, json.dumps(given, indent=1, sort_keys=True))
        write_whole(self._language, language + "\n")
        return said

    def take(self, released: Path) -> list[str]:
        """Copy a teacher's release from a folder; files that a student has changed are never overwritten."""
        given = self._read_manifest()
        said = []
        for source in sorted(released.glob("*.ipynb")):
            sentence = self._bring(source.name, source.read_text(encoding="utf-8"), given, released=True)
            said += [sentence] if sentence else []
        for extra in sorted(path for path in released.iterdir() if path.is_dir()):
            self._copy_beside(extra)
        write_whole(self._manifest, json.dumps(given, indent=1, sort_keys=True), parents=True)
        return said

    def first(self) -> str:
        """Return the first notebook."""
        return next(iter(self._from_elsewhere()), FIRST)

    def _from_elsewhere(self) -> list[str]:
        """Return the notebooks of a folder that was never filled with the course."""
        return [] if self._manifest.exists() else sorted(path.name for path in self.folder.glob("*.ipynb"))

    def _bring(self, name: str, text: str, given: dict[str, str], *, released: bool = False) -> str:
        target = self.folder / name
        edition = edition_of(text)
        if target.exists() and _handed_out(target) and not released:
            return ""
        if not target.exists():
            write_whole(target, text)
            given[name] = edition
            return f"{name}: new"
        same, untouched = given.get(name) == edition, edition_of(target.read_text(encoding="utf-8")) == given.get(name)
        if same and not (released and untouched and not _handed_out(target)):
            return ""
        if untouched:
            write_whole(target, text)
            given[name] = edition
            return f"{name}: updated (you had not changed it)"
        beside = target.with_suffix(".new.ipynb")
        write_whole(beside, text)
        given[name] = edition
        return f"{name}: you have worked on it, so it stays; the new edition is {beside.name}"

    def _copy_beside(self, source: Path, *, again: bool = False) -> None:
        """Copy a folder's files; existing ones only with `again`, and if no student changed them."""
        target = self.folder / source.name
        target.mkdir(exist_ok=True)
        for file in source.iterdir():
            there, data = target / file.name, file.read_bytes()
            if not there.exists() or (again and there.read_bytes() != data):
                write_whole(there, data)

    def _read_manifest(self) -> dict[str, str]:
        try:
            manifest = json.loads(self._manifest.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}
        return manifest if isinstance(manifest, dict) else {}
