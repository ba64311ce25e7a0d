"""A small class with many kinds of submissions is graded in one go: every one gets the mark it deserves."""

import csv
import json
import os
import re
from collections import Counter

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import folders, sandbox
from coursekit.grade.sandbox import Limits
from tests.needs import posix

from .class_of_200 import KINDS, make_class
from .hostile_kinds import HOST, HOSTILE

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]
SAMPLE = ("right", "half", "zipped", "renamed", "nothing", "no-notebook", "broken-node", "wrong-kernel", "missing",
          "early-exit", "only-answers", "forged-trial", "patched-trial",
          "bundle", "marks-raised", "borrowed-bundle", "xacro-escape", "forged-values", "link-to-the-host", "deep-folders",
          "bad-name", "long-name", "class", "formula", "no-utf-8")  # fmt: skip
"""Kinds that are quick and that other tests have not; `make class` grades them all, 200 together."""


def test_a_class_gets_the_marks_that_it_deserves(tmp_path, monkeypatch):
    if sandbox.tier() != "bubblewrap":
        pytest.skip("NOT TESTED: hostile submissions need bubblewrap, which does not work here")
    monkeypatch.setattr("coursekit.grade.batch.Limits", lambda: Limits(seconds=60, cell=3.0))
    kind_by_student = make_class(tmp_path / "class", lambda kind: kind.name in SAMPLE)
    out = tmp_path / "grades.csv"
    words = ["--allow-root", str(tmp_path / "class"), "--jobs", "2", "--out", str(out), *only(kind_by_student.values())]
    assert main(["grade", *words]) == 0
    wrong = faults(tmp_path / "grades", out, kind_by_student)
    folders.remove(tmp_path / "class")  # too deep for whoever clears up after the tests
    assert not wrong, "\n".join(wrong)


def only(kinds):
    """The words that have just the chapters of these marked."""
    return "--chapters", *sorted({kind.chapter.partition("_")[0] for kind in kinds})


def faults(kept, table, made):
    """What is wrong with the marks; prints every outcome."""
    messages = []
    with open(table, newline="", encoding="utf-8-sig") as file:
        rows = {row["student"]: row for row in csv.DictReader(file)}
    if set(rows) != set(made):
        messages.append(f"students: {set(rows) ^ set(made)}")
    least, most, statuses = deserved(made)
    total, counted = earned(table)
    if not least <= total <= most or counted != statuses:
        messages.append(f"the class: {total:g} points, {dict(counted)} instead of {least:g} to {most:g}, {dict(statuses)}")
    if HOST.exists():
        messages.append(f"something reached the host: {HOST}")
    for student, kind in made.items():
        row = rows.get(student, {"key": "", "total": "", "status": "is missing", "tier": "", "notes": ""})
        report = kept / f"{row['key']}.results.json"
        tests = json.loads(report.read_text())["tests"] if report.is_file() else []
        said = " ".join([row["notes"], *(test["output"] for test in tests)])
        print(f"{student}: {row['total']} points, {row['status']}, {row['tier']}; {row['notes'][:160]}")
        good = float(row["total"] or -1) in kind.deserves and row["status"] == kind.status
        if not good or not re.search(kind.told, said, re.S):
            messages.append(
                f"{student}: {row['total']} ({row['status']}) instead of {kind.deserves} ({kind.status}): {said}"
            )
    return messages


def deserved(made):
    """The least and the most that a class earns together, and how many of its submissions have each status."""
    bounds = [(min(kind.deserves), max(kind.deserves)) for kind in made.values()]
    least, most = (sum(side) for side in zip(*bounds, strict=True))
    return least, most, Counter(kind.status for kind in made.values())


def earned(table):
    """The points of a whole table together, and how many of its rows have each status."""
    with open(table, newline="", encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file))
    return sum(float(row["total"]) for row in rows if row["total"]), Counter(row["status"] for row in rows)


def test_what_a_class_deserves_together_follows_from_what_each_kind_deserves():
    right, either = (next(kind for kind in KINDS if kind.name == name) for name in ("right", "file-system"))
    late = next(kind for kind in KINDS if kind.status == "timed out")
    assert deserved({"ann": right, "ben": either, "cem": late}) == (
        right.deserves[0] + 6 + min(late.deserves),
        right.deserves[0] + 7 + max(late.deserves),
        {"graded": 2, "timed out": 1},
    )


@posix("folders are not opened there, and what is refused has other names")
def test_the_whole_class_is_written_as_200_submissions_of_every_kind(tmp_path):
    kind_by_student = make_class(tmp_path / "class", lambda kind: kind.number)
    written = os.listdir(os.fsencode(tmp_path / "class"))
    folders.remove(tmp_path / "class")  # too deep for whoever clears up after the tests
    assert len(kind_by_student) == len(written) == 200
    assert set(kind_by_student.values()) == set(KINDS) and set(HOSTILE) <= set(KINDS)
    assert set(SAMPLE) <= {kind.name for kind in KINDS}
    assert len({kind.name for kind in KINDS}) == len(KINDS)
