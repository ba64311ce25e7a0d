"""A small class with many kinds of submissions is graded in one go: every one gets the mark it deserves."""

import csv
import json
import re

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import sandbox
from coursekit.grade.sandbox import Limits

from .class_of_200 import KINDS, make_class

pytestmark = [pytest.mark.slow, pytest.mark.timeout(400)]
SAMPLE = ("right", "half", "zipped", "renamed", "nothing", "no-notebook", "broken-node", "wrong-kernel", "missing",
          "early-exit", "only-answers", "forged-trial", "patched-trial",
          "parcel", "marks-raised", "borrowed-parcel")  # fmt: skip
"""Kinds that are quick and that test_attacks has not; `make class` grades them all, 200 together."""


def test_a_class_gets_the_marks_that_it_deserves(tmp_path, monkeypatch):
    if sandbox.tier() != "bubblewrap":
        pytest.skip("NOT TESTED: hostile submissions need bubblewrap, which does not work here")
    monkeypatch.setattr("coursekit.grade.batch.Limits", lambda: Limits(seconds=60, cell=3.0))
    made = make_class(tmp_path / "class", lambda kind: kind.name in SAMPLE)
    out = tmp_path / "grades.csv"
    assert main(["grade", "--allow-root", str(tmp_path / "class"), "--jobs", "2", "--out", str(out)]) == 0
    wrong = faults(tmp_path / "grades", out, made)
    assert not wrong, "\n".join(wrong)


def faults(kept, table, made):
    """What is wrong with the marks; prints every outcome."""
    found = []
    with open(table, newline="", encoding="utf-8-sig") as file:
        rows = {row["student"]: row for row in csv.DictReader(file)}
    if set(rows) != set(made):
        found.append(f"students: {set(rows) ^ set(made)}")
    for student, kind in made.items():
        row = rows[student]
        report = json.loads((kept / f"{row['key']}.results.json").read_text())
        said = " ".join([row["notes"], *(one["output"] for one in report["tests"])])
        print(f"{student}: {row['total']} of 7, {row['status']}, {row['tier']}; {row['notes'][:160]}")
        good = float(row["total"] or -1) in kind.deserves and row["status"] == kind.status
        if not good or not re.search(kind.told, said, re.S):
            found.append(f"{student}: {row['total']} ({row['status']}) instead of {kind.deserves} ({kind.status}): {said}")
    return found


def test_the_whole_class_has_200_students():
    assert sum(kind.number for kind in KINDS) == 200
    assert set(SAMPLE) <= {kind.name for kind in KINDS}
