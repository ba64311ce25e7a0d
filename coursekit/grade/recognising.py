"""Recognise a notebook's chapter and the student's work in it, by its content, or else by its name."""

from __future__ import annotations

import hashlib
import itertools
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from .copy import GIVEN, facts_of, given_digest, without_solution
from .sanitizing import shown
from .variants import CHECK

LARGEST = 32 << 20
"""The maximum size of a notebook [bytes]."""
_MOST_PARTS = 1_500_000
"""The maximum number of brackets, braces and commas: each may become an object many times its size."""
_CODE = 20_000
"""The maximum length of an answer stored for the student's page [characters]."""


def parse_notebook(data: bytes, name: str) -> dict[str, Any]:
    """Parse a notebook's JSON.

    Raises:
        ValueError: when it is not a notebook, or would take too much memory.
    """
    if len(data) > LARGEST:
        raise ValueError(f"{name} is larger than {LARGEST >> 20} MB")
    if data.count(b"[") + data.count(b"{") + data.count(b",") > _MOST_PARTS:
        raise ValueError(f"{name} has more parts than a notebook has")
    try:
        notebook = json.loads(_decoded(data))
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{name} is no notebook: {_why_none(data, error)}") from None
    if isinstance(notebook, dict) and "doc_id" in notebook:
        raise ValueError(f"{name} is only a link to a file in Google Drive: download that as .ipynb")
    if not isinstance(notebook, dict) or not isinstance(notebook.get("cells"), list):
        raise ValueError(f"{name} is no notebook of format 4: it has no list of cells")
    return notebook


def _decoded(data: bytes) -> str:
    """Decode a notebook: UTF-8, or the encoding given by its first bytes; Windows' Notepad saves UTF-16."""
    kind = json.detect_encoding(data)
    return data.decode("utf-8-sig" if kind.startswith("utf-8") else kind).lstrip("\ufeff")


def _why_none(data: bytes, error: Exception) -> str:
    """Return why bytes are not JSON, in words for a student."""
    begin = data.lstrip()[:40].decode("utf-8", "replace")
    if not data.strip():
        return "the file is empty"
    if isinstance(error, UnicodeError) or not begin.rstrip("\ufffd").replace("\n", " ").isprintable():
        return "it is not text in UTF-8"
    if b"\n<<<<<<< " in data:
        return "it holds both sides of a conflict of git's: choose one, and save it in the lab"
    if data.lstrip()[:1] != b"{":
        return f"it begins with {shown(begin, 30)!r}"
    if isinstance(error, json.JSONDecodeError):
        return f"it breaks off, or is not whole, in line {error.lineno}"
    return "it is nested too deeply" if isinstance(error, RecursionError) else "it cannot be read"


def text_of(cell: Any) -> str:
    r"""Return the source of a cell of any form, with lines ending in `\n`."""
    source = cell.get("source", "") if isinstance(cell, dict) else ""
    text = "".join(str(line) for line in source) if isinstance(source, list) else source
    return text.replace("\r\n", "\n").replace("\r", "\n") if isinstance(text, str) else ""


def grade_id(cell: Any) -> str:
    """Return the name under which a cell is graded, or ''."""
    metadata = cell.get("metadata") if isinstance(cell, dict) else None
    grading = metadata.get("nbgrader") if isinstance(metadata, dict) else None
    name = grading.get("grade_id") if isinstance(grading, dict) else ""
    return name if isinstance(name, str) else ""


@dataclass(frozen=True)
class Known:
    """The facts found in a notebook's content."""

    chapter: str
    """The file name of the corresponding course notebook; '' if the content does not show it."""
    begun: tuple[str, ...] = ()
    """The exercises with changed cells."""
    touched: bool = False
    """Whether anything was changed, for instance by adding a cell."""
    copy: str = ""
    """The secret mark of the original copy."""
    code: dict[str, str] = field(default_factory=dict)
    """The answers, by exercise."""
    work: str = ""
    """A digest of all changes."""
    language: str = ""
    """The code of the release's language; '' if the content does not show it."""

    @property
    def level(self) -> int:
        """2 for work on exercises, 1 for other changes, 0 for an untouched copy."""
        return 2 if self.begun else int(self.touched)


class Chapter:
    """A notebook of the course, for comparison with others."""

    def __init__(self, name: str, source: Mapping[str, Any]) -> None:
        self.name = name
        self.source = source

    @cached_property
    def marks(self) -> frozenset[str]:
        """The names of its graded cells and checks."""
        return frozenset(_marks(self.source))

    @cached_property
    def stubs(self) -> dict[str, set[str]]:
        """The digests of its solution cells as handed out, by name."""
        stubs: dict[str, set[str]] = {}
        for cell in self.source["cells"]:
            if cell.get("metadata", {}).get("nbgrader", {}).get("solution"):
                stubs.setdefault(grade_id(cell), set()).add(given_digest(without_solution(text_of(cell))))
        return stubs

    @cached_property
    def texts(self) -> frozenset[str]:
        """The texts of all its cells as handed out."""
        return frozenset(without_solution(text_of(cell)).strip() for cell in self.source["cells"])

    def known(self, notebook: Mapping[str, Any]) -> Known:
        """Return the work in a notebook of this chapter."""
        facts = facts_of(notebook)
        said = facts.get(GIVEN)
        given: dict[str, Any] = said if isinstance(said, dict) else {}
        code: dict[str, str] = {}
        begun: list[str] = []
        work: list[str] = []
        for cell, name in self._named(notebook["cells"]):
            text = text_of(cell)
            if name in self.stubs:
                exercise = ".".join(name.split("-")[:2])
                code[exercise] = (code.get(exercise, "") + "\n\n" + text)[-_CODE:].strip("\n")
                if not _as_given(text, self.stubs[name], given.get(name)):
                    begun.append(exercise)
                    work.append(f"{name}\0{text.strip()}")
            elif not name and text.strip() and cell.get("cell_type") == "code" and self._is_own(text):
                work.append(text.strip())
        digest = hashlib.sha256("\0".join(work).encode("utf-8", "replace")).hexdigest()
        copy, language = (fact if isinstance(fact, str) else "" for fact in map(facts.get, ("copy", "language")))
        return Known(self.name, tuple(dict.fromkeys(begun)), bool(work), copy, code, digest, language)

    def _named(self, cells: Sequence[Any]) -> Iterator[tuple[Any, str]]:
        """Yield each cell with its name; a solution cell that lost its name is the student's last cell above the check."""
        names = [grade_id(cell) for cell in cells]
        checks = [CHECK.search(text_of(cell)) for cell in cells]
        own = [at for at, cell in enumerate(cells) if checks[at] or (text_of(cell).strip() and self._is_own(text_of(cell)))]
        for at, below in itertools.pairwise(own):
            check = checks[below]
            lost = check["name"].replace(".", "-") if check is not None and checks[at] is None else ""
            if lost in self.stubs and lost not in names and not names[at]:
                names[at] = lost
        return zip(cells, names, strict=True)

    def _is_own(self, text: str) -> bool:
        """Whether an unnamed cell was added by the student."""
        return not CHECK.search(text) and text.strip() not in self.texts


def _as_given(text: str, stubs: set[str], given: Any) -> bool:
    digest = given_digest(text)
    return not text.strip() or digest in stubs or digest == given


def _marks(notebook: Mapping[str, Any]) -> set[str]:
    marks = {grade_id(cell) for cell in notebook["cells"]} - {""}
    for cell in notebook["cells"]:
        if isinstance(cell, dict) and cell.get("cell_type") == "code":
            marks |= {f"check {match['name']}" for match in CHECK.finditer(text_of(cell))}
    return marks


class Recogniser:
    """Knows the course's notebooks."""

    def __init__(self, sources: Mapping[str, Mapping[str, Any]]) -> None:
        self.chapters = {name: Chapter(name, source) for name, source in sources.items()}

    def recognise(self, notebook: Mapping[str, Any]) -> Known:
        """Recognise the chapter of a notebook by its content."""
        marks = _marks(notebook)
        counts = {name: len(marks & chapter.marks) for name, chapter in self.chapters.items()}
        best = max(counts.values(), default=0)
        fitting = [name for name, count in counts.items() if count == best]
        whole = [name for name in fitting if self.chapters[name].marks <= marks]
        fitting = whole if len(whole) == 1 else fitting
        if best and len(fitting) == 1:
            return self.chapters[fitting[0]].known(notebook)
        facts = facts_of(notebook)
        named = facts.get("chapter")
        mark = facts.get("copy")
        if isinstance(named, str) and named in self.chapters:
            return self.chapters[named].known(notebook)
        several = [known for name in fitting if best and (known := self.chapters[name].known(notebook)).begun]
        if several:
            return max(several, key=lambda known: len(known.begun))
        return Known("", touched=True, copy=mark if isinstance(mark, str) else "", work=_digest(notebook))

    def others(self, notebook: Mapping[str, Any], chapter: str) -> tuple[Known, ...]:
        """Recognise the other chapters whose exercises were also done in it."""
        marks = _marks(notebook)
        named = (candidate for name, candidate in self.chapters.items() if name != chapter and marks & candidate.marks)
        return tuple(known for candidate in named if (known := candidate.known(notebook)).begun)

    def by_name(self, file: str) -> str:
        """Return the chapter whose name is part of a file's name: `ann_02_topics (1).ipynb` is `02_topics.ipynb`."""
        plain = re.sub(r"[\W_]+", "_", Path(file).stem.casefold())
        fitting = [name for name in self.chapters if _stands_in(re.sub(r"[\W_]+", "_", Path(name).stem.casefold()), plain)]
        return max(fitting, key=len) if fitting else ""


def _stands_in(word: str, text: str) -> bool:
    return re.search(rf"(?:^|_){re.escape(word)}(?:_|$)", text) is not None


def _digest(notebook: Mapping[str, Any]) -> str:
    texts = "\0".join(text_of(cell) for cell in notebook["cells"])
    return hashlib.sha256(texts.encode("utf-8", "replace")).hexdigest()
