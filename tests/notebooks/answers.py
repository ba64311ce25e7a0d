"""Other answers than the solution of an exercise, run in its place: wrong ones are refused with help, right ones taken."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Iterator
from pathlib import Path

import nbformat
import pytest
from nbclient.exceptions import CellExecutionError

from . import wrong

Cells = list[nbformat.NotebookNode]
Execute = Callable[[nbformat.NotebookNode, int], object]
MODULES = {
    module.name: importlib.import_module(f"{wrong.__name__}.{module.name}")
    for module in pkgutil.iter_modules(wrong.__path__)
}
"""By the first part of their exercises' names: ch03, appa."""


def answers_of(chapter: Path, kind: str) -> dict[str, list[str]]:
    """The answers of a chapter's exercises, WRONG ones or other RIGHT ones, by the exercise's name."""
    name = f"ch{chapter.stem[:2]}" if chapter.stem[0].isdigit() else f"app{chapter.stem[0].lower()}"
    answers: dict[str, list[str]] = getattr(MODULES.get(name), kind, {})
    return answers


def grade_id(cell: nbformat.NotebookNode) -> str:
    """The name that nbgrader knows a cell by; empty when it knows none."""
    return str(cell.metadata.get("nbgrader", {}).get("grade_id", ""))


def is_graded(cell: nbformat.NotebookNode) -> bool:
    """Whether nbgrader knows a cell: a solution or a check."""
    return bool(cell.metadata.get("nbgrader"))


def is_solution(cell: nbformat.NotebookNode) -> bool:
    """Whether a student writes this cell."""
    return bool(cell.metadata.get("nbgrader", {}).get("solution"))


def is_check(cell: nbformat.NotebookNode) -> bool:
    """Whether this cell checks an answer."""
    return bool(cell.metadata.get("nbgrader", {}).get("grade"))


def verdict_of(cell: nbformat.NotebookNode) -> str:
    """What a check shows, as text."""
    return "\n".join(output.data["text/plain"] for output in cell.outputs if output.output_type == "display_data")


def must_fail(execute: Execute, cells: Cells, index: int, answer: str) -> None:
    """Run a wrong answer in the solution's place, and what follows it up to the check, which must refuse it."""
    for cell, at in _up_to_the_check(cells, index, answer):
        try:
            execute(cell, at)
        except CellExecutionError as error:
            if not is_check(cell):
                continue  # a wrong answer may break cells before the check
            assert error.ename == "CheckFailed", (answer, str(error))
            said = verdict_of(cell)
            assert said.startswith("✘") and "expected:" in said, said
            print(answer[-300:], said, sep="\n")
            return
        assert not is_check(cell), f"a wrong answer to {grade_id(cells[index])} passes: {answer}"


def must_pass(execute: Execute, cells: Cells, index: int, answer: str) -> None:
    """Run another right answer in the solution's place, and what follows it up to the check, which must take it."""
    for cell, at in _up_to_the_check(cells, index, answer):
        execute(cell, at)
        assert not is_check(cell) or verdict_of(cell).startswith("✔"), (answer, verdict_of(cell))


def _up_to_the_check(cells: Cells, index: int, answer: str) -> Iterator[tuple[nbformat.NotebookNode, int]]:
    """Copies of the cells from a solution on, with the answer instead of it, each with its place."""
    check = f"{grade_id(cells[index])}-check"
    for at in range(index, len(cells)):
        cell = nbformat.from_dict(dict(cells[at]))
        if at == index:
            cell.source = answer
        yield cell, at
        if grade_id(cell) == check:
            return
    pytest.fail(f"no check with the grade_id {check} stands below its solution")
