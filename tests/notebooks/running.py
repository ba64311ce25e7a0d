"""Runs chapters, on the virtual clock where they do not ask for the other, each with a course folder of its own."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient

from coursekit.grade.exercise import Exercise, all_exercises

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = ROOT / "notebooks"
ONLY_TO_READ = ("10_a_real_robot", "D_your_own_ubuntu")
"""Without exercises."""


def chapters() -> list[Path]:
    """The chapters, in order."""
    return sorted(NOTEBOOKS.glob("[0-9A-Z]*_*.ipynb"))


def read(path: Path) -> nbformat.NotebookNode:
    """A chapter as it is stored."""
    return nbformat.read(path, as_version=4)


def code_cells(notebook: nbformat.NotebookNode) -> list[nbformat.NotebookNode]:
    """The cells that run."""
    return [cell for cell in notebook.cells if cell.cell_type == "code" and cell.source.strip()]


def exercises_of(chapter: Path) -> dict[str, Exercise]:
    """The exercises of a chapter, by name."""
    name = f"ch{chapter.stem[:2]}" if chapter.stem[0].isdigit() else f"app{chapter.stem[0].lower()}"
    return {
        exercise_name: exercise
        for exercise_name, exercise in all_exercises().items()
        if exercise_name.startswith(f"{name}.")
    }


def name_student(folder: Path, name: str = "Vera Course") -> None:
    """Remember who works in a course folder, as chapter 0 does."""
    file = folder / ".coursekit" / "student.json"
    if name and not file.exists():
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f'"{name}"', encoding="utf-8")


def clock_of(notebook: Mapping[str, Any]) -> str:
    """The clock that a chapter runs on: the virtual one, unless its metadata name the other, as a real network needs."""
    return str(notebook.get("metadata", {}).get("coursekit", {}).get("clock", "virtual"))


@contextlib.contextmanager
def course_environment(folder: Path, clock: str = "virtual", student: str = "Vera Course") -> Iterator[None]:
    """The variables that a kernel of the course sees, with `folder` as the course of this student, nobody's if empty."""
    name_student(folder, student)
    wanted = {
        "COURSEKIT_TIME": clock,
        "COURSEKIT_COURSE": str(folder),
        "COURSEKIT_WORKSPACE": str(folder / "ros2_ws"),
        "PYDEVD_DISABLE_FILE_VALIDATION": "1",
        "COLUMNS": "120",
        "TZ": "UTC",
    }
    before = {name: os.environ.get(name) for name in wanted}
    os.environ.update(wanted)
    try:
        yield
    finally:
        for name, value in before.items():
            os.environ.pop(name, None) if value is None else os.environ.__setitem__(name, value)


def run(
    notebook: nbformat.NotebookNode,
    folder: Path,
    *,
    allow_errors: bool = False,
    timeout: int = 120,
    student: str = "Vera Course",
) -> None:
    """Execute a notebook in place."""
    (folder / "ros2_ws" / "src").mkdir(parents=True, exist_ok=True)
    with course_environment(folder, clock_of(notebook), student):
        client = NotebookClient(
            notebook,
            timeout=timeout,
            kernel_name="python3",
            allow_errors=allow_errors,
            resources={"metadata": {"path": str(folder)}},
        )
        with client.setup_kernel():
            for index, cell in enumerate(notebook.cells):
                client.execute_cell(cell, index)
