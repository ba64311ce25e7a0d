"""The picture beside a verdict: shown where somebody looks, of checked values only, and never at the price of a point."""

from dataclasses import asdict, replace

import pytest

from coursekit.grade import checking
from coursekit.grade.checking import judge, judge_work
from coursekit.grade.exercise import Exercise, all_exercises
from coursekit.grade.illustration import LONGEST, Illustration
from coursekit.grade.remote import RemoteWork
from coursekit.grade.verdict import CheckFailed, Wrong
from coursekit.view.figure import Figure, Line, Panel, Words

from .junk import values
from .test_judges_fail_closed import CALLS_A_FUNCTION, JUDGES_A_TRIAL, LEAVES, Fed, message, seen_with

ILLUSTRATED = [name for name in all_exercises() if name.startswith(("ch07", "ch08", "ch09"))]
ILLUSTRATED += ["appb.q4", "ch00.q2", "ch01.q2", "ch01.q4", "ch05.q4", "ch06.q2"]


def line(*points):
    return Figure([Panel([Line(points, "own")])], "a line")


def drawing(make, *facts, wrong=None):
    """An exercise whose judge hands this out, and may find something wrong."""

    def judge_it(work):
        work.illustrate(make, *facts)
        if wrong:
            raise wrong

    return Exercise("ch99.q1", "Draw", 2, (), judge_it)


def seen(exercise):
    """The verdict, and the picture beside it."""
    illustration = Illustration()
    return judge(exercise, {}, None, illustration=illustration), illustration.html()


def test_the_picture_is_below_the_words_with_its_text():
    verdict, picture = seen(drawing(line, (0, 0), (1, 1)))
    assert verdict.passed and 'aria-label="a line"' in picture and verdict.html(picture).endswith(f"{picture}</div>")


def test_words_and_points_are_the_same_with_and_without_a_picture():
    for wrong in (None, Wrong("x", "y", share=0.5, at=[(0, 0)])):
        exercise = drawing(line, (0, 0), (1, 1), wrong=wrong)
        assert asdict(seen(exercise)[0]) == asdict(judge(exercise, {}, None))


def test_the_fault_is_marked_where_the_judge_found_it():
    assert seen(drawing(line, (0, 0), (1, 1), wrong=Wrong("x", at=[(1, 1)])))[1].count('class="ring"') == 1
    assert 'class="ring"' not in seen(drawing(line, (0, 0), (1, 1), wrong=Wrong("x")))[1]


def test_lists_that_grew_while_it_was_judged_are_drawn_as_they_are_at_the_end():
    told = []

    def judge_it(work):
        work.illustrate(lambda words: Figure([Panel([Words(0, 0, "".join(words))])], ""), told)
        told.append("late")

    assert ">late<" in seen(Exercise("ch99.q1", "Draw", 1, (), judge_it))[1]


def broken(*_):
    raise KeyError("no picture")


def interrupted(*_):
    raise KeyboardInterrupt


def endless_recursion(*facts):
    return endless_recursion(*facts)


def huge(*_):
    return Figure([Panel([Words(0, 0, "x" * LONGEST)])], "")


@pytest.mark.parametrize("make", [broken, interrupted, endless_recursion, huge, lambda *_: None, lambda *_: Figure([], "")])
def test_a_picture_that_cannot_be_drawn_costs_nothing(make):
    verdict, picture = seen(drawing(make))
    assert verdict.passed and picture == ""


def test_of_a_stub_nothing_is_drawn():
    def stub(*_):
        raise NotImplementedError

    for name in ("ch08.q1", "ch08.q2", "ch09.q1", "ch09.q2", "ch09.q4"):
        work = Fed(answer=stub)
        work.illustration = Illustration()
        judge_work(all_exercises()[name], work)
        assert work.illustration.html() == ""


def test_where_nobody_looks_nothing_is_drawn():
    def drawn(*_):
        raise AssertionError("drawn in grading")

    assert judge(drawing(drawn), {}, None).passed and RemoteWork.illustrate is Fed.illustrate
    assert Fed().illustration is None


class NothingRuns:
    """A sandbox that is never asked."""


def test_the_grader_s_work_takes_no_pictures(tmp_path):
    assert RemoteWork(NothingRuns(), tmp_path, {}, None).illustration is None


@pytest.fixture
def shown(tmp_path, monkeypatch):
    """shown(exercise) is what `check` displays and raises, in a notebook."""
    displayed = []
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))
    monkeypatch.setattr(checking, "running_shell", lambda: None)
    monkeypatch.setattr(checking, "_show", lambda *given: displayed.append(checking._Shown(*given)))

    def of(exercise):
        monkeypatch.setattr(checking, "find", lambda name: exercise)
        checking.check("ch99.q1")
        return displayed[-1]

    return of


def test_a_check_shows_the_picture_to_those_who_see_and_words_to_all(shown):
    verdict = shown(drawing(line, (0, 0), (1, 1)))
    assert "<figure" in verdict._repr_html_() and repr(verdict) == "✔ ch99.q1 Draw: 2 of 2 points"


def test_a_check_that_fails_shows_it_as_well(shown):
    with pytest.raises(CheckFailed):
        shown(drawing(broken, wrong=Wrong("x")))


@pytest.mark.parametrize("name", [exercise for exercise in ILLUSTRATED if exercise in CALLS_A_FUNCTION])
def test_junk_from_a_function_gets_the_verdict_that_it_gets_without_pictures(name):
    for value in values():
        with_picture, without = Fed(answer=value), Fed(answer=value)
        with_picture.illustration = Illustration()
        verdict = judge_work(all_exercises()[name], with_picture)
        assert replace(verdict, gave="") == replace(judge_work(all_exercises()[name], without), gave="")
        assert isinstance(with_picture.illustration.html(), str)


@pytest.mark.parametrize("name", [exercise for exercise in ILLUSTRATED if exercise in JUDGES_A_TRIAL])
@pytest.mark.parametrize("leaf", LEAVES, ids=range(len(LEAVES)))
def test_junk_from_a_program_gets_the_verdict_that_it_gets_without_pictures(name, leaf):
    with_picture, without = (Fed(seen=seen_with([message(leaf)])) for _ in range(2))
    with_picture.illustration = Illustration()
    assert judge_work(all_exercises()[name], with_picture) == judge_work(all_exercises()[name], without)
    assert isinstance(with_picture.illustration.html(), str)
