"""Exercises without points, those in C++: checked in the notebook, no part of a mark, skipped where nothing compiles."""

import json

import pytest

from coursekit.cpp import toolchain
from coursekit.grade.checking import check, judge, judge_work
from coursekit.grade.exercise import Exercise, all_exercises, exercises_in, find
from coursekit.grade.progress import Progress
from coursekit.grade.verdict import CheckFailed, Verdict, Wrong
from tests.grade.solutions import NOTEBOOKS
from tests.grade.tried import Tried

IN_CPP = [name for name, exercise in all_exercises().items() if not exercise.points]


@pytest.fixture
def no_compiler(monkeypatch):
    def find_none():
        raise toolchain.NoToolchain("none")

    monkeypatch.setattr(toolchain, "find_toolchain", find_none)


@pytest.fixture
def progress(tmp_path, monkeypatch):
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path))
    return lambda: Progress.of_course().chapters()["ch02"]


def test_each_lesson_that_has_both_languages_has_one_in_cpp():
    assert set(IN_CPP) == {f"ch0{number}.q5" for number in range(2, 7)}


def test_no_mark_knows_of_them():
    notebooks = [json.loads(path.read_text(encoding="utf-8")) for path in sorted(NOTEBOOKS.glob("0[2-6]*.ipynb"))]
    assert all(f'check("{name}")' in json.dumps(notebooks).replace("\\", "") for name in IN_CPP)
    assert not set(IN_CPP) & set(exercises_in(*notebooks))


@pytest.mark.parametrize("name", IN_CPP)
def test_without_a_compiler_they_are_skipped_in_plain_words(name, no_compiler, tmp_path):
    said = judge(find(name), {}, tmp_path)
    assert said.passed and said.text().startswith(f"– {name}") and "coursekit cpp" in said.text()
    assert "coursekit cpp" in said.html() and "✔" not in said.html()


def test_a_skipped_one_ends_no_cell_and_is_not_done(no_compiler, progress, capsys):
    check("ch02.q5")
    assert "skipped" in capsys.readouterr().out
    assert progress()[2][-1][2:] == (0.0, 0)


def test_one_that_is_wrong_is_not_passed_although_no_point_is_missing():
    def refuse(work):
        raise Wrong("a relay", "nothing")

    said = judge_work(Exercise("own.q1", "Relay", 0, ("A hint.",), refuse), Tried(), 2)
    assert not said.passed and said.text().startswith("✘ own.q1 Relay: not done (no points)")


def test_what_is_done_is_remembered_and_changes_no_sum(progress):
    points, of, _ = progress()
    Progress.of_course().note(Verdict("ch02.q5", "A relay in C++", 0, 0))
    after = progress()
    assert after[:2] == (points, of) and after[2][-1] == ("ch02.q5", "A relay in C++", 1.0, 0)
    shown = Progress.of_course()._repr_html_()
    assert "A relay in C++: done (no points)" in shown and "An alarm in C++: not done (no points)" in shown


def test_what_was_not_built_is_said(tmp_path, monkeypatch):
    monkeypatch.setattr(toolchain, "find_toolchain", lambda: None)
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path))
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))
    with pytest.raises(CheckFailed):
        check("ch02.q5")
