"""What made-up students hand in: notebooks with some exercises done, zips with names and times; and a cheap way to mark."""

from __future__ import annotations

import csv
import io
import json
import os
import time
import zipfile
from pathlib import Path
from unittest import mock

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import sandbox
from coursekit.grade.collector import Collector
from coursekit.grade.copy import student_notebook
from coursekit.grade.exercise import exercises_in
from coursekit.grade.mark import Marked
from coursekit.grade.recognising import Recogniser, parse_notebook
from coursekit.grade.verdict import Verdict

NOTEBOOKS = Path(__file__).resolve().parents[2] / "notebooks"
TOPICS, SERVICES = "02_topics.ipynb", "03_services.ipynb"
SOURCES = {name: json.loads((NOTEBOOKS / name).read_text(encoding="utf-8")) for name in (TOPICS, SERVICES)}
WALLS = pytest.mark.skipif(sandbox.tier() != "bubblewrap", reason="NOT TESTED: no bubblewrap: apt-get install bubblewrap")
"""The mark of a test that needs walls around submissions: without them marking refuses before it looks at anything."""
NOON = time.mktime((2026, 11, 23, 12, 0, 0, 0, 0, -1))


def notebook(*done, chapter=TOPICS, own=""):
    """The student's copy of a chapter with something in the cells of these questions (`"q1"`)."""
    nb = student_notebook(SOURCES[chapter])
    for cell in nb["cells"]:
        name = cell["metadata"].get("nbgrader", {}).get("grade_id", "")
        if name.partition("-")[2] in done:
            cell["source"] = f"# {name} was done{own}\ndone = True\n"
    return nb


def text(*done, **more):
    """The same as it is saved."""
    return json.dumps(notebook(*done, **more), indent=1)


def write(file, content, when=NOON):
    """Write a file of that time."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    os.utime(file, (when, when))
    return file


def zipped(files, when=NOON):
    """A zip of files by name; of (content, time) where a file has a time of its own."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, content in files.items():
            content, at = content if isinstance(content, tuple) else (content, when)
            packed.writestr(zipfile.ZipInfo(name, time.localtime(at)[:6]), content)
    return buffer.getvalue()


def collected(place, scratch, **more):
    """What a collector finds."""
    scratch.mkdir(exist_ok=True)
    return Collector(SOURCES, scratch, **more).collect(place)


def by_name(collection):
    """What each handed in, by name."""
    return {submission.label: submission for submission in collection.handed}


def cheap_mark(submission, sources, exercises, limits, secret=b""):
    """All points for what was begun: stands for the sandbox where a test is not about that."""
    marked = Marked(submission.student, submission.digest(), tier="bubblewrap")
    ((chapter, file),) = submission.chosen.items()
    known = Recogniser(sources).recognise(parse_notebook(file.read_bytes(), chapter))
    for name, exercise in exercises.items():
        right = name in known.begun
        points = exercise.points if right else 0
        expected, got = ("", "") if right else ("more", "the stub")
        marked.verdicts.append(Verdict(name, exercise.title, points, exercise.points, expected, got))
    marked.answers = [code for name, code in known.code.items() if name in known.begun]
    return marked


def grade(folder, *words, out=None):
    """`coursekit grade`; its exit status and the rows of its table by student."""
    table = out or folder.parent / "grades.csv"
    with mock.patch("matplotlib.figure.Figure.savefig"):  # the histogram takes longer than all the rest
        anywhere = ["--allow-root", "--unsafe"]
        status = main(["grade", str(folder), "--jobs", "2", *anywhere, "--out", str(table), *map(str, words)])
    return status, rows(table)


def rows(table):
    """The rows of a table by student."""
    head, *records = lines(table)
    return {row["student"]: row for row in (dict(zip(head, record, strict=True)) for record in records)}


def answer(table, **answers):
    """Answer the questions of a table: what is asked about begins so."""
    head, *records = lines(table)
    asked = [dict(zip(head, record, strict=True)) for record in records]
    for row in asked:
        for begin, said in answers.items():
            if begin in row["about"] or begin in row["question"]:
                row["answer"] = said
    with open(table, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, asked[0].keys())
        writer.writeheader()
        writer.writerows(asked)
    return asked


def points_of(*done, chapter=TOPICS):
    """What these questions are worth."""
    known = exercises_in(SOURCES[chapter])
    return sum(exercise.points for name, exercise in known.items() if name.partition(".")[2] in done)


def lines(file):
    """The rows of a table, headings included, whatever parts its cells."""
    with open(file, newline="", encoding="utf-8-sig") as table:
        head = table.readline()
        table.seek(0)
        return list(csv.reader(table, delimiter=max(",;\t", key=head.count)))


def edited(table, **cells):
    """The table with other texts in a row of one student, saved as a German Excel does."""
    records = lines(table)
    row = next(record for record in records if record[1] == cells["student"])
    for name, said in cells.items():
        if name not in records[0]:
            records = [[*record, name if number == 0 else ""] for number, record in enumerate(records)]
            row = next(record for record in records if record[1] == cells["student"])
        row[records[0].index(name)] = said
    with open(table, "w", newline="", encoding="utf-8-sig") as out:
        csv.writer(out, delimiter=";").writerows(records)
