"""A judge that changes things, and a student's function that changes things, see each other through the sandbox's wall."""

import sys

import pytest

from coursekit.grade import sandbox
from coursekit.grade.mark import _environment
from coursekit.grade.remote import Line, RemoteWork
from coursekit.grade.verdict import Wrong

CELL = """
state = {"holding": False, "odd": object()}
box = [1]
def shared(words):
    words.append("seen")
    box.append(state["holding"])
    state["holding"] = not state["holding"]
    return words
def filled(message):
    message.data = "filled"
"""


@pytest.fixture
def work(tmp_path):
    workspace = tmp_path / "course" / "ros2_ws"
    (workspace / "src").mkdir(parents=True)
    env, limits = _environment(workspace), sandbox.Limits(seconds=30)
    running = sandbox.start([sys.executable, "-m", "coursekit.grade.inside"], workspace.parent, env, limits)
    yield RemoteWork(Line(running, limits), workspace, env, limits)
    running.end()


def test_changes_of_arguments_and_variables_cross_in_both_directions(work):
    from std_msgs.msg import String

    assert work.run(CELL, 10) == ""
    state, box, words = work.value("state", dict), work.value("box", list), ["mine"]
    for holding in (True, False):
        state["holding"] = holding
        assert work.function("shared")(words) is words
        assert state["holding"] is not holding
    assert words == ["mine", "seen", "seen"] and box == [1, True, False]
    message = String(data="empty")
    work.function("filled")(message)
    assert message.data == "filled"


def test_an_exercise_judged_later_sees_the_variables_of_its_own_check(work):
    work.run("answer = 1\ndef f(): return 1", 10)
    work.judge_from_here("one")
    work.run("answer = 2\ndef f(): return 2", 10)
    work.judge_from_here("two")
    work.complete = True
    assert (work.value("answer", int), work.function("f")()) == (2, 2)
    work.judge_from_here("one")
    assert (work.value("answer", int), work.function("f")()) == (1, 1)
    with pytest.raises(Wrong, match="a variable named `nothing`"):
        work.value("nothing", int)


def test_waiting_for_what_never_comes_costs_no_real_time(work):
    never = "from coursekit.core.session import current\ncurrent().clock.new_event().wait()"
    assert "waited for" in work.run(never, 25)
    assert "waited for" in work.run("import time\nwhile True: time.sleep(1.0)", 25)
    assert work.run("after = 1", 10) == "" and work.value("after", int) == 1
