"""What a verdict says beside what a program died of."""

from types import SimpleNamespace

import pytest

from coursekit.grade import checking
from coursekit.grade.checking import judge_work
from coursekit.grade.exercise import Exercise
from coursekit.grade.outputs import DIED
from coursekit.grade.verdict import CheckFailed, Wrong

TRACE = 'Traceback (most recent call last):\n  File "/ws/my_node.py", line 9, in main\n    spin()\nNameError: no spin\n'


def close(work):
    """A check that guesses why nothing came."""
    work.try_out("run a a_exe")
    raise Wrong("an answer", "none", "Is the topic's name right?", hint=0)


def verdict(output):
    """The verdict on a program that said this, at the third try."""
    work = SimpleNamespace(try_out=lambda *commands: SimpleNamespace(outputs=[output]))
    return judge_work(Exercise("own.q1", "Close it", 2, ("Which topic?",), close), work, 3)


def test_where_the_program_died_the_check_does_not_guess():
    said = verdict(TRACE)
    assert "NameError: no spin" in said.got and (said.cause, said.hint) == (DIED, "")


def test_where_it_lived_the_guess_and_the_hint_are_given():
    said = verdict("nothing\n")
    assert (said.got, said.cause, said.hint) == ("none", "Is the topic's name right?", "Which topic?")


def test_a_check_that_is_stopped_says_so_in_one_line(tmp_path, monkeypatch):
    def endless(*_):
        raise KeyboardInterrupt

    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))
    monkeypatch.setattr(checking, "judge", endless)
    with pytest.raises(CheckFailed) as caught:
        checking.check("ch08.q3")
    assert caught.value._render_traceback_() == [
        "ch08.q3 was stopped, so it is not judged. Is there a loop that never ends?"
    ]
