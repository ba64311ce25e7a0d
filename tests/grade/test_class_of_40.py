"""A class of 40 with mixed ways of handing in gets the marks that it deserves, and the same when it is marked again."""

import random
from dataclasses import replace
from pathlib import Path

import pytest

from coursekit.grade import batch, sandbox
from coursekit.grade.mark import mark
from tests.needs import posix

from .class_of_40 import PEOPLE, make_class
from .handed import cheap_mark, grade

SOLVED = ("Cem O'Neill", "Gil van den Berg")
"""Who handed in the course's own solutions: these can be marked in the sandbox, too; the others' marks are cheap."""


@pytest.fixture
def group(tmp_path, monkeypatch):
    """The folder, the words of the command, what each deserves."""
    monkeypatch.setattr(batch, "mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    (tmp_path / "class").mkdir()
    deserved = make_class(tmp_path / "class", tmp_path / "roster.csv")
    return tmp_path / "class", ("--roster", tmp_path / "roster.csv"), deserved


def marks(found):
    return {name: float(row["total"]) if row["total"] else None for name, row in found.items()}


def test_everybody_gets_what_they_deserve_twice(group, capsys):
    folder, words, deserved = group
    status, first = grade(folder, *words)
    assert status == 1 and len(first) == len(PEOPLE) == 40
    assert marks(first) == deserved
    assert {row["status"] for row in first.values()} == {"graded", "unreadable", "question", "nothing handed in"}
    assert "no notebook was handed in" not in "".join(row["notes"] for row in first.values())
    said = capsys.readouterr().out
    assert "40 students: 30 graded, 2 unreadable, 4 without anything handed in, 4 with an open question; on average" in said
    assert "4 questions are open: fill in" in said
    assert grade(folder, *words, "--again")[1] == first
    assert grade(folder, *words)[1] == first


def test_the_order_in_which_the_disk_tells_its_files_changes_nothing(group, monkeypatch):
    folder, words, deserved = group
    usual = Path.iterdir

    def shuffled(self):
        paths = list(usual(self))
        random.Random(7).shuffle(paths)
        return iter(paths)

    monkeypatch.setattr(Path, "iterdir", shuffled)
    assert marks(grade(folder, *words)[1]) == deserved


@posix("its marks come from a container")
@pytest.mark.slow
@pytest.mark.timeout(300)
def test_marks_of_the_sandbox_are_the_same_twice(tmp_path, group, monkeypatch):
    folder, words, deserved = group
    monkeypatch.undo()
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    real = []

    def some(submission, *more):
        if submission.student not in (*SOLVED, "the reference solution"):
            return replace(cheap_mark(submission, *more), tier=sandbox.tier())
        real.append(submission.student)
        return mark(submission, *more)

    monkeypatch.setattr(batch, "mark", some)
    first = grade(folder, *words)[1]
    assert marks(first) == deserved
    assert grade(folder, *words, "--again", *SOLVED)[1] == first
    assert sorted(real) == sorted(["the reference solution", *SOLVED, *SOLVED])
