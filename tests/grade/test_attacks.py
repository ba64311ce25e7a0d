"""Hostile and broken submissions: each gets the mark it deserves, and none harms the next or the host."""

import json

import pytest

from coursekit.grade import sandbox
from coursekit.grade.exercise import find
from coursekit.grade.mark import mark
from coursekit.grade.sandbox import Limits
from coursekit.grade.submissions import Submission
from tests.needs import ON_WINDOWS, in_wine

from .attacks import DESERVE, ESCAPE, FOLDERS, NAMELESS, NEEDS_BUBBLEWRAP, NOTEBOOKS, ONLY_POSIX, RIGHT


def cells(answer):
    grading = {"grade": False, "solution": True, "locked": False, "grade_id": "ch02-q1", "schema_version": 3, "task": False}
    check = {**grading, "grade": True, "solution": False, "locked": True, "grade_id": "ch02-q1-check", "points": 1}
    return {
        "nbformat": 4,
        "nbformat_minor": 5,
        "metadata": {},
        "cells": [
            {"cell_type": "code", "metadata": {"nbgrader": grading}, "source": answer, "outputs": []},
            {"cell_type": "code", "metadata": {"nbgrader": check}, "source": 'check("ch02.q1")', "outputs": []},
        ],
    }


def grade(folder, answer, **changed):
    folder.mkdir(exist_ok=True)
    (folder / "names.ipynb").write_text(json.dumps({**cells(answer), **changed}))
    exercise = {"ch02.q1": find("ch02.q1")}
    limits = Limits(seconds=60 if in_wine() else 12, memory=1 << 30, processes=60, folder=100 << 20, cell=2.0, call=2.0)
    return mark(Submission(folder.name, folder), {"names.ipynb": cells("")}, exercise, limits)


@pytest.mark.slow
def test_folders_in_folders_end_no_marking(tmp_path):
    """Right as the answer is, the notebook may be ended for them; what comes after is marked either way."""
    marked = grade(tmp_path / "student", FOLDERS)
    assert marked.status == "graded" and marked.verdicts[0].points in (0, 1)
    assert grade(tmp_path / "next", RIGHT).total() == 1


@pytest.mark.slow
@pytest.mark.parametrize("attack", DESERVE)
def test_each_attack_gets_what_it_deserves(tmp_path, attack):
    if attack in NEEDS_BUBBLEWRAP and sandbox.tier() != "bubblewrap":
        pytest.skip(f"NOT TESTED: {attack} needs bubblewrap, which does not work here")
    if ON_WINDOWS and attack in ONLY_POSIX:
        pytest.skip(f"Windows: {ONLY_POSIX[attack]}")
    answer, deserved = DESERVE[attack]
    marked = grade(tmp_path / "student", answer)
    verdict = marked.verdicts[0]
    print(f"{attack}: {verdict.points:g} of {verdict.of:g}; {verdict.got or 'solved'} ({marked.tier})")
    assert marked.status == "graded"
    assert verdict.points == deserved, verdict.text()
    assert verdict.passed or verdict.got or verdict.gave


@pytest.mark.slow
@pytest.mark.skipif(sandbox.tier() != "bubblewrap", reason="NOT TESTED: no bubblewrap: apt-get install bubblewrap")
def test_what_is_written_to_the_host_is_not_there(tmp_path):
    """Below /tmp it lands in a /tmp of the sandbox's own, elsewhere it is refused."""
    marked = grade(tmp_path / "student", ESCAPE)
    assert marked.status == "graded" and marked.verdicts[0].points in (0, 1)
    assert not (NOTEBOOKS.parent / "escaped").exists()


@pytest.mark.slow
@pytest.mark.skipif(sandbox.tier() != "bubblewrap", reason="NOT TESTED: no bubblewrap: apt-get install bubblewrap")
def test_what_cannot_be_told_of_one_answer_leaves_the_others_alone(tmp_path):
    """The words are a student's, not those of our own classes."""
    verdict = grade(tmp_path / "nameless", NAMELESS).verdicts[0]
    assert verdict.got.startswith("RuntimeError: it raised something that cannot be told"), verdict.text()
    verdict = grade(tmp_path / "gone", "import os\ndef full_name(*_): os._exit(0)\n").verdicts[0]
    assert "Gone" not in verdict.text() and "ended while it ran" in verdict.got, verdict.text()
    verdict = grade(tmp_path / "late", "def full_name(*_):\n    while True: pass\n").verdicts[0]
    assert verdict.timed_out and "TimeOver" not in verdict.text() and "loop" in verdict.cause, verdict.text()
    verdict = grade(tmp_path / "awaited", "async " + RIGHT.lstrip()).verdicts[0]
    assert "`async`" in verdict.cause, verdict.text()


def test_broken_notebooks_are_told_and_cost_nobody_else_anything(tmp_path):
    for name, text in {"none.ipynb": "", "list.ipynb": "[]", "deep.ipynb": "[" * 100_000, "binary.ipynb": "\0"}.items():
        folder = tmp_path / name
        folder.mkdir()
        (folder / "names.ipynb").write_text(text)
        marked = mark(Submission(name, folder), {"names.ipynb": cells("")}, {"ch02.q1": find("ch02.q1")}, Limits(seconds=5))
        assert (marked.status, marked.total()) == ("unreadable", 0), name
        assert marked.notes


def test_doubled_retyped_and_nameless_cells_are_mended(tmp_path):
    answer, check = cells(RIGHT)["cells"]
    stub = {**answer, "source": "raise NotImplementedError()"}
    nameless = {**answer, "metadata": {}}
    retyped = {**answer, "cell_type": "markdown"}
    shapes = {"doubled": [answer, stub, check], "nameless": [nameless, check], "retyped": [retyped, check]}
    for name, shape_cells in shapes.items():
        marked = grade(tmp_path / name, "", cells=shape_cells)
        assert marked.total() == 1, (name, marked)
        assert marked.notes, name
    assert grade(tmp_path / "missing", "", cells=[check]).total() == 0


def test_a_missing_colon_is_told_as_one(tmp_path):
    verdict = grade(tmp_path / "student", "def full_name(name, node, namespace)\n    return name").verdicts[0]
    assert (verdict.points, verdict.got) == (0, "there is none") and "SyntaxError" in verdict.cause, verdict.text()


def test_a_cell_with_nothing_but_a_tilde_is_told_as_unfinished(tmp_path):
    verdict = grade(tmp_path / "student", "~").verdicts[0]
    assert (verdict.points, verdict.got) == (0, "there is none"), verdict.text()
    assert "SyntaxError" in verdict.cause and not verdict.fault, verdict.text()


def test_a_tilde_as_the_answer_is_told_as_no_function(tmp_path):
    verdict = grade(tmp_path / "student", 'full_name = "~"').verdicts[0]
    assert (verdict.points, verdict.gave) == (0, "a str: '~'"), verdict.text()
