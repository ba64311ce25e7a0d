"""An instructor who uses nbgrader: generate, autograde, feedback and export work with the course's notebooks as they are."""

import csv
import json
import os
import shutil
import sys
from pathlib import Path

import pytest

pytest.importorskip("nbgrader", reason="NOT TESTED: the extra `nbgrader` is not installed")

from nbgrader.api import Gradebook
from nbgrader.apps import NbGraderAPI
from nbgrader.plugins import CsvExportPlugin
from traitlets.config import Config

from .kinds import solution_cells

NOTEBOOKS = Path(__file__).resolve().parents[2] / "notebooks"
CHAPTERS = {"00_start_here": (4.0, "ch00-q3", 1.0), "02_topics": (7.0, "ch02-q1", 1.0)}
"""Points, and the cell that ben leaves empty with what that costs."""

pytestmark = [pytest.mark.slow, pytest.mark.timeout(400)]


@pytest.fixture
def course(tmp_path, monkeypatch):
    """An nbgrader course; the kernels of its students run on the virtual clock."""
    for name in ("COURSEKIT_COURSE", "COURSEKIT_WORKSPACE"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("COURSEKIT_TIME", "virtual")
    monkeypatch.setenv("PATH", os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]]))  # alembic's command
    monkeypatch.setenv("PYDEVD_DISABLE_FILE_VALIDATION", "1")
    config = Config()
    config.CourseDirectory.root = str(tmp_path)
    config.CourseDirectory.db_url = f"sqlite:///{tmp_path / 'gradebook.db'}"
    config.ClearSolutions.code_stub = {"python": "# YOUR CODE HERE\nraise NotImplementedError()"}
    config.ExecutePreprocessor.timeout = 120
    return tmp_path, config


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_the_round_trip_gives_the_marks(course, chapter):
    root, config = course
    points, empty, cost = CHAPTERS[chapter]
    (root / "source" / "week").mkdir(parents=True)
    shutil.copy(NOTEBOOKS / f"{chapter}.ipynb", root / "source" / "week")
    api = NbGraderAPI(config=config)
    assert api.generate_assignment("week")["success"]
    released = root / "release" / "week" / f"{chapter}.ipynb"
    assert "BEGIN SOLUTION" not in released.read_text()
    for student, without in (("ann", None), ("ben", empty)):
        _hand_in(root / "submitted" / student / "week" / released.name, released, without)
        done = api.autograde("week", student)
        assert done["success"], done.get("log", done)
        assert api.generate_feedback("week", student)["success"]
        assert (root / "feedback" / student / "week" / f"{chapter}.html").stat().st_size > 10_000
    with Gradebook(config.CourseDirectory.db_url) as gradebook:
        table = CsvExportPlugin(config=config)
        table.to = str(root / "grades.csv")
        table.export(gradebook)
    with open(root / "grades.csv", encoding="utf-8", newline="") as file:
        scores = {row["student_id"]: (float(row["score"]), float(row["max_score"])) for row in csv.DictReader(file)}
    assert scores == {"ann": (points, points), "ben": (points - cost, points)}


def _hand_in(place, released, without):
    """The released notebook with the course's solutions filled in, but for one."""
    notebook = json.loads(released.read_text())
    solved = solution_cells(json.loads((NOTEBOOKS / released.name).read_text()))
    for name, cell in solution_cells(notebook).items():
        if name != without:
            cell["source"] = solved[name]["source"]
    place.parent.mkdir(parents=True)
    place.write_text(json.dumps(notebook))
