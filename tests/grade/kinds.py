"""What a made-up class is composed of: kinds of submissions, and ways to fill in a chapter's cells."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from coursekit.grade.copy import student_notebook

NOTEBOOKS = Path(__file__).resolve().parents[2] / "notebooks"
TOPICS, ROBOTS, SLAM, CAPSTONE = (
    "02_topics.ipynb", "06_urdf_and_robot_states.ipynb", "08_maps_and_slam.ipynb", "09_capstone.ipynb"
)  # fmt: skip
Notebook = dict[str, Any]


@dataclass(frozen=True)
class Placed:
    """A submission that is not a file: `write(folder)` makes what lies in the student's folder."""

    write: Callable[[Path], None]


@dataclass(frozen=True)
class Packed:
    """A submission that is a zip: `make(student)` gives its bytes."""

    make: Callable[[str], bytes]


@dataclass(frozen=True)
class Kind:
    """One kind of submission: how many of 200, the points it deserves (any of several), and what it is made of."""

    name: str
    number: int
    deserves: tuple[float, ...]
    make: Callable[[Notebook], Notebook | dict[str, Notebook] | str | Placed | Packed | None]
    """From the right notebook: a notebook, several by name, text, a folder or a zip."""
    status: str = "graded"
    told: str = ""
    """Words that the notes or verdicts have."""
    chapter: str = TOPICS
    walled: bool = False
    """Whether it would harm this computer where nothing keeps it in."""
    called: str = ""
    """What the student is called, where that is the attack."""

    def right(self) -> Notebook:
        """The chapter with its solutions."""
        return dict(json.loads((NOTEBOOKS / self.chapter).read_text(encoding="utf-8")))


def solution_cells(notebook: Notebook) -> dict[str, Notebook]:
    """The cells that students fill in, by name."""
    grading = ((cell, cell["metadata"].get("nbgrader", {})) for cell in notebook["cells"])
    return {metadata["grade_id"]: cell for cell, metadata in grading if metadata.get("solution")}


def question(notebook: Notebook, name: str) -> Notebook:
    """The cell of a question (`q1`)."""
    return next(cell for grade_id, cell in solution_cells(notebook).items() if grade_id.endswith(f"-{name}"))


def answers(**texts: str) -> Callable[[Notebook], Notebook]:
    """The right notebook with other texts in some cells (`q1="..."`)."""

    def make(notebook: Notebook) -> Notebook:
        for name, text in texts.items():
            cell = question(notebook, name)
            cell["source"] = text.replace("{right}", "".join(cell["source"]))
        return notebook

    return make


def stubs(*names: str) -> Callable[[Notebook], Notebook]:
    """The right notebook with stubs in some cells."""

    def make(notebook: Notebook) -> Notebook:
        empty = student_notebook(notebook)
        for name in names:
            question(notebook, name)["source"] = question(empty, name)["source"]
        return notebook

    return make
