"""Marking on other computers gives the marks of this one, also when one of them dies in the middle."""

import csv
import json
import os
import signal

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import sandbox, workers
from coursekit.grade.copy import student_notebook
from coursekit.grade.exercise import exercises_in
from coursekit.grade.mark import mark
from coursekit.grade.own_checks import OWN, read_checks
from coursekit.grade.sandbox import Limits
from coursekit.grade.submissions import Submission
from coursekit.grade.template import write_template
from tests.needs import real_windows

from .handed import write
from .kinds import solution_cells

distributed = pytest.importorskip("distributed", reason='NOT TESTED: pip install "coursekit[scheduler]"')

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]
WALLS = pytest.mark.skipif(sandbox.tier() != "bubblewrap", reason="NOT TESTED: bubblewrap does not work here")
STUDENTS = {f"Student {letter}": points for letter, points in zip("ABCDEF", (2, 0, 2, 0, 2, 2), strict=True)}
@pytest.fixture(scope="module")
def cluster():
    """Two workers on loopback, each a process of its own."""
    settings = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None, "host": "127.0.0.1"}
    with distributed.LocalCluster(**settings) as cluster:
        with distributed.Client(cluster) as client:
            client.wait_for_workers(2)
        yield cluster


@pytest.fixture
def course(tmp_path):
    """A chapter of a teacher's own with one exercise, and a class that did it or did not."""
    write_template(tmp_path / "course", "gripper")
    return tmp_path


def notebooks(folder):
    return folder / "course"


def hand_in_all(folder):
    """Half of the class leaves the stub."""
    [source] = notebooks(folder).glob("*.ipynb")
    right = json.loads(source.read_text())
    for name, points in STUDENTS.items():
        nb = student_notebook(right)
        if points:
            for grade_id, cell in solution_cells(nb).items():
                cell["source"] = solution_cells(right)[grade_id]["source"]
        write(folder / "class" / name / source.name, json.dumps(nb))
    return source


def grade(folder, cluster, *words):
    out = folder / "grades.csv"
    command = ["grade", str(folder / "class"), "--notebooks", str(notebooks(folder)), "--out", str(out), "--allow-root"]
    assert main([*command, "--chapters", "gripper", "--scheduler", cluster.scheduler_address, *words]) == 0
    with open(out, encoding="utf-8", newline="") as file:
        return {row["student"]: float(row["total"]) for row in csv.DictReader(file)}


@WALLS
def test_a_class_gets_its_marks_though_a_worker_dies_and_a_second_run_marks_nothing(course, cluster, capsys, monkeypatch):
    hand_in_all(course)
    pids = [worker.process.pid for worker in cluster.workers.values()]
    told = []

    def kill_one(self, *facts):
        told.append(facts)
        if len(told) == 1:
            os.kill(pids[0], signal.SIGKILL)

    monkeypatch.setattr("coursekit.grade.marking_progress.Bar.__call__", kill_one)
    assert grade(course, cluster) == STUDENTS
    assert len(told) == len(STUDENTS)
    assert "run in the sandbox bubblewrap" in capsys.readouterr().out
    told.clear()
    assert grade(course, cluster) == STUDENTS
    assert not told


@WALLS
def test_a_mark_made_from_texts_is_the_mark_made_here(course, tmp_path):
    source = hand_in_all(course)
    read_checks(source.parent / OWN)
    sources = {source.name: json.loads(source.read_text())}
    exercises = exercises_in(*sources.values())
    file = course / "class" / "Student A" / source.name
    submission = Submission("Student A", file.parent, {source.name: file}, [], ["a note"], [])
    facts = (submission, sources, exercises, Limits(), b"dice")
    there = json.loads(workers.mark_packed(json.dumps(workers.packed(*facts))))
    assert there == json.loads(json.dumps(mark(*facts).as_json()))


def other(**facts):
    return {"tcp://127.0.0.1:1": {**workers.facts(), "tier": "bubblewrap", "root": False, **facts}}


@pytest.mark.parametrize(
    ("found", "why"),
    [
        ({}, "has no workers yet. Start some: dask worker tcp://127.0.0.1:8786 --nthreads 1"),
        (other(judges="another"), "has another coursekit"),
        (other(tier="limits", lacks="no bubblewrap. Type: apt"), "has no bubblewrap. Type: apt"),
        (other(root=True), "runs as root: start it as another user"),
    ],
)
def test_workers_that_would_mark_otherwise_are_refused_with_a_cure(found, why):
    with pytest.raises(workers.NoWorkers, match=why):
        workers.expect_alike(found, "tcp://127.0.0.1:8786", allow_root=False, unsafe=False)


def test_their_sandbox_is_the_one_that_the_marks_name():
    assert workers.expect_alike(other(), "", allow_root=False, unsafe=False) == "bubblewrap"
    both = {**other(tier="limits"), "tcp://127.0.0.1:2": other()["tcp://127.0.0.1:1"]}
    with pytest.raises(workers.NoWorkers, match="different sandboxes"):
        workers.expect_alike(both, "", allow_root=False, unsafe=True)


@real_windows("distributed waits for a clock that Wine's never matches")
def test_a_scheduler_that_does_not_answer_is_told(course, monkeypatch):
    monkeypatch.setattr(workers, "CONNECT_S", 0.2)
    hand_in_all(course)
    with pytest.raises(SystemExit, match="No scheduler answers at tcp://127.0.0.1:1"):
        main(["grade", str(course / "class"), "--scheduler", "tcp://127.0.0.1:1", "--out", str(course / "grades.csv")])
