"""The course's own solutions, handed in and graded in the sandbox, earn every point."""

import json
import shutil
from pathlib import Path

import pytest

from coursekit.grade.exercise import exercises_in
from coursekit.grade.mark import mark
from coursekit.grade.sandbox import Limits
from coursekit.grade.submissions import Submission
from tests.needs import in_wine

NOTEBOOKS = [
    pytest.param(file, id=file.stem)
    for file in sorted((Path(__file__).resolve().parents[2] / "notebooks").glob("*.ipynb"))
    if "check(" in file.read_text(encoding="utf-8")
]

SECONDS, CHAPTER_SECONDS = (2400, 2100) if in_wine() else (180, 600)
"""For cells and checks, and for all of the marking: in Wine Numba compiles for minutes, in each process anew."""

pytestmark = [pytest.mark.slow, pytest.mark.timeout(SECONDS + 60)]


@pytest.mark.parametrize("file", NOTEBOOKS)
def test_a_chapter_s_own_solutions_earn_every_point(file, tmp_path):
    text = file.read_text(encoding="utf-8")
    source = json.loads(text)
    exercises = exercises_in(source)
    folder = tmp_path / "ann"
    folder.mkdir()
    shutil.copy(file, folder)
    limits = Limits(seconds=SECONDS, chapter=CHAPTER_SECONDS)
    marked = mark(Submission("ann", folder), {file.name: source}, exercises, limits)
    assert marked.status == "graded", marked.notes
    assert not [verdict.text() for verdict in marked.verdicts if not verdict.passed]
    assert not marked.notes and {verdict.name for verdict in marked.verdicts} == set(exercises)
