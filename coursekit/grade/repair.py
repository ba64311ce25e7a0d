"""Bring a submitted notebook into the course's form: missing, duplicate or retyped cells are repaired, with notes."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Container, Iterable
from dataclasses import dataclass, field
from typing import Any

from .copy import without_solution
from .recognising import text_of
from .sanitizing import shown, unique
from .variants import CHECK

LIVE = "live"
"""The tag of cells that drive or watch running programs; they are not needed for a mark and omitted."""


@dataclass
class Step:
    """One cell to run, and the exercise judged after it."""

    source: str
    exercise: str = ""
    solution: bool = False
    """Whether the student wrote it."""
    given: str = ""
    """The text as handed out."""


@dataclass
class Repaired:
    """The cells to run in the course's order, and notes on the repairs."""

    steps: list[Step] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    begun: dict[str, bool] = field(default_factory=dict)
    """Whether cells of an exercise were changed; unchanged stubs earn nothing."""

    def answers(self) -> list[str]:
        """Return the student's lines in solution cells, without those handed out."""
        return [_own_lines(step.source, step.given) for step in self.steps if step.solution]


def repair(source: dict[str, Any], submitted: dict[str, Any]) -> Repaired:
    """Insert the student's answers and added cells into the course's notebook."""
    repaired = Repaired()
    theirs = [cell for cell in submitted.get("cells", []) if isinstance(cell, dict)]
    by_id = _by_id(theirs, {_id(cell) for cell in source["cells"]}, repaired.notes)
    own = _own_cells(source, theirs)
    known = {"".join(cell["source"]).strip() for cell in source["cells"]}
    unknown = [cell for cell in theirs if CHECK.search(_text(cell)) or _text(cell).strip() not in known]
    for cell in source["cells"]:
        grading = cell.get("metadata", {}).get("nbgrader", {})
        text = "".join(cell["source"])
        name = str(grading.get("grade_id", ""))
        if cell["cell_type"] != "code" or LIVE in cell.get("metadata", {}).get("tags", []):
            continue
        if grading.get("solution"):
            answer = _answer(name, text, by_id, unknown, repaired.notes)
            added = own.pop(name, [])
            repaired.steps += [Step(source, solution=True) for source in added]
            repaired.steps.append(Step(answer, solution=True, given=without_solution(text)))
            exercise = ".".join(name.split("-")[:2])
            as_given = answer.strip() == without_solution(text).strip() and "YOUR CODE HERE" in answer
            written = bool(added or own.get("")) or not as_given
            repaired.begun[exercise] = repaired.begun.get(exercise, False) or written
            continue
        match = CHECK.search(text)
        repaired.steps.append(Step("" if match else text, match["name"] if match else ""))
    repaired.steps = [Step(source, solution=True) for left in own.values() for source in left] + repaired.steps
    repaired.notes = unique(repaired.notes)
    return repaired


def _own_lines(answer: str, given: str) -> str:
    """Return the lines of an answer without those given, removing each as often as it was given.

    >>> _own_lines("import math\\ndef f(x):\\n    return x\\n    return x", "import math\\ndef f(x):\\n    return x")
    '    return x'
    """
    left = Counter(line.strip() for line in given.splitlines())
    kept = []
    for line in answer.splitlines():
        left[line.strip()] -= 1
        if left[line.strip()] < 0:
            kept.append(line)
    return "\n".join(kept)


def _id(cell: dict[str, Any]) -> str:
    grading = cell.get("metadata", {}).get("nbgrader", {})
    return str(grading.get("grade_id", "")) if isinstance(grading, dict) else ""


def _text(cell: dict[str, Any]) -> str:
    return text_of(cell)


def _by_id(cells: Iterable[dict[str, Any]], known: Container[str], notes: list[str]) -> dict[str, str]:
    """Return the text of each cell with a course name; of duplicates the one that was changed, else the later."""
    text_by_id: dict[str, str] = {}
    for cell in cells:
        name, text = _id(cell), _text(cell)
        if not name or name not in known:
            continue
        if cell.get("cell_type") != "code":
            kind = shown(str(cell.get("cell_type")), 30)
            notes.append(f"{name}: the cell had been turned into {kind}; it was read as code")
        if name in text_by_id:
            notes.append(f"{name}: there were two such cells; the one that was worked on counts")
            if "NotImplementedError" in text and "NotImplementedError" not in text_by_id[name]:
                continue
        text_by_id[name] = text
    return text_by_id


def _answer(
    name: str, text: str, by_id: dict[str, str], theirs: list[dict[str, Any]], notes: list[str]
) -> str:
    if name in by_id:
        return by_id[name]
    before = _cell_before_check(name, theirs)
    if before:
        notes.append(f"{name}: the cell had lost its name; the one above its check was taken")
        return before
    notes.append(f"{name}: the cell is missing")
    return without_solution(text)


def _cell_before_check(name: str, theirs: list[dict[str, Any]]) -> str:
    """Return an unnamed cell directly above the check of the same exercise."""
    exercise = name.replace("-", ".")
    for before, cell in itertools.pairwise(theirs):
        match = CHECK.search(_text(cell))
        if match and match["name"] == exercise and not _id(before):
            return _text(before)
    return ""


def _own_cells(source: dict[str, Any], theirs: list[dict[str, Any]]) -> dict[str, list[str]]:
    """Return cells added by the student, by the name of the solution cell below them ('' at the end)."""
    known = {"".join(cell["source"]).strip() for cell in source["cells"]}
    solutions = {_id(cell) for cell in source["cells"] if cell.get("metadata", {}).get("nbgrader", {}).get("solution")}
    cells_by_name: dict[str, list[str]] = {}
    waiting: list[str] = []
    for cell in theirs:
        if _id(cell) in solutions:
            cells_by_name.setdefault(_id(cell), []).extend(waiting)
            waiting = []
        elif cell.get("cell_type") == "code" and not _id(cell) and _text(cell).strip() not in known:
            waiting.append(_text(cell))
    return {name: cells for name, cells in cells_by_name.items() if cells}
