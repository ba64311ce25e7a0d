"""A judge that changes things, and a student's function that changes things, see each other through the sandbox's wall."""

import sys

import pytest

from coursekit.grade import sandbox
from coursekit.grade.checking import judge_work
from coursekit.grade.examiner import _built_or_late, environment
from coursekit.grade.exercise import Exercise
from coursekit.grade.interruptions import Gone, NeedsWorkspace
from coursekit.grade.plain import called
from coursekit.grade.remote import RemoteWork
from coursekit.grade.sandbox import Limits
from coursekit.grade.verdict import Wrong
from tests.needs import posix

from .handed import WALLS

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
    env, limits = environment(workspace), sandbox.Limits(seconds=30)
    running = sandbox.start([sys.executable, "-m", "coursekit.grade.sandbox_program"], workspace.parent, env, limits)
    remote_work = RemoteWork(running, workspace, env, limits)
    remote_work.judge_from_here("any")
    yield remote_work
    remote_work.end()


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
    for exercise, answer in (("one", 1), ("two", 2)):
        work.run(f"answer = {answer}", 10)
        work.judge_from_here(exercise)
        with pytest.raises(NeedsWorkspace):
            assert work.value("answer", int) == answer
            work.text("src/any")
    work.finish(10)
    for exercise, answer in (("one", 1), ("two", 2)):
        work.judge_from_here(exercise)
        assert work.value("answer", int) == answer
    with pytest.raises(Gone):
        work.value("nothing", int)


def test_files_are_read_by_a_process_that_cannot_write_them(work):
    work.run("open('ros2_ws/src/notes.txt', 'w').write('mine')", 10)
    work.finish(10)
    assert work.text("src/notes.txt") == "mine" and work.exists("src") and not work.exists("install")
    with pytest.raises(Wrong, match=r"the file src/note\.txt") as wrong:
        work.text("src/note.txt")
    assert "notes.txt" in wrong.value.cause
    with pytest.raises(Wrong, match="built"):
        work.built("nothing")


HOSTILE = """
import os, pathlib
src = pathlib.Path("ros2_ws/src")
os.mkfifo(src / "pipe")
os.symlink("/dev/zero", src / "zero")
os.symlink("/etc/passwd", src / "host")
(src / "huge").write_bytes(b"x" * 2_000_000)
os.truncate(src / "huge", 60_000_000)
"""


@posix("there are no pipes in folders, nor devices")
@WALLS
def test_pipes_devices_links_and_huge_files_are_told_at_once(work):
    assert work.run(HOSTILE, 10) == ""
    work.finish(10)
    for name in ("pipe", "zero", "host", "huge"):
        with pytest.raises(Wrong):
            work.text(f"src/{name}")


@WALLS
def test_a_workspace_that_became_a_link_shows_nothing_of_the_host(work, tmp_path):
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere" / "secret.txt").write_text("of the host")
    target = str(tmp_path / "elsewhere")
    work.run(f"import os, shutil\nshutil.rmtree('ros2_ws')\nos.symlink({target!r}, 'ros2_ws')", 10)
    work.finish(10)
    assert not work.exists("secret.txt")


XACRO = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="evil">
<xacro:property name="x" value="${(lambda f=().__class__.__base__.__subclasses__(): [c for c in f
 if c.__name__ == 'catch_warnings'][0]()._module.__builtins__['open']('/proc/self/environ').read())()}"/>
<link name="base"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
</robot>"""
TOWER = XACRO.replace(XACRO[XACRO.index("${") : XACRO.index('"/>')], "${9**9**9}")


@pytest.mark.parametrize("text", [XACRO, TOWER], ids=["escape", "tower of powers"])
def test_a_xacro_that_computes_does_so_where_it_harms_nobody(work, text, monkeypatch):
    monkeypatch.setattr("coursekit.grade.remote.READ_SECONDS", 3.0)
    work.run(f"open('ros2_ws/src/robot.urdf.xacro', 'w').write({text!r})", 10)
    work.finish(10)
    try:
        assert set(work.robot("src/robot.urdf.xacro").links) == {"base"}
    except Wrong as wrong:
        assert "host" not in wrong.got
    assert not work.exists("nothing")  # another reader answers


def test_waiting_for_what_never_comes_costs_no_real_time(work):
    never = "from coursekit.processes.session import current\ncurrent().clock.new_event().wait()"
    assert "waited for" in work.run(never, 25)
    assert "waited for" in work.run("import time\nwhile True: time.sleep(1.0)", 25)
    assert work.run("after = 1", 10) == "" and work.value("after", int) == 1


STUBBORN = """
import signal
for alarm in (signal.SIGALRM, signal.SIGPROF):
    signal.signal(alarm, signal.SIG_IGN)
while True: pass
"""
# A loop that catches all would not do: an alarm that falls between two tries ends it.


def exercise(judge):
    return Exercise("ch99.q1", "Try", 1, (), judge)


def test_a_call_that_never_ends_is_a_fact_of_the_verdict(work, monkeypatch):
    monkeypatch.setattr(work, "_limits", Limits(call=0.3))
    work.run("def f():\n    while True: pass\ndef g():\n    raise ValueError('it took longer than 20 s')", 10)
    for name, over in (("f", True), ("g", False)):
        for ask in (lambda function: function(), lambda function: called(function, told="x")):
            verdict = judge_work(exercise(lambda work, name=name, ask=ask: ask(work.function(name))), work)
            assert (verdict.passed, verdict.timed_out, verdict.fault) == (False, over, "")


def test_a_cell_that_never_ends_is_told_as_such(work):
    work.run("while True: pass", 0.3)
    assert work.cell_timed_out
    work.run("raise KeyboardInterrupt('the cell took too long')", 10)
    assert not work.cell_timed_out


def test_a_sandbox_that_does_not_answer_is_gone_because_of_time(work):
    with pytest.raises(Gone) as gone:
        work._line.ask({"ask": "run", "source": STUBBORN, "seconds": 0.1}, 0.5)
    assert gone.value.timed_out


def test_what_a_student_s_function_raises_in_the_sandbox_is_no_fault_of_the_check(work):
    work.run("def f(a):\n    return a + 'x'", 10)
    verdict = judge_work(exercise(lambda work: work.function("f")(1)), work)
    assert verdict.got.startswith("TypeError: unsupported operand") and not verdict.fault


DEEP = """import json
def f():
    return json.loads("x")
"""


def test_the_line_that_is_told_is_the_student_s_own_not_a_library_s(work):
    work.run(DEEP, 10)
    verdict = judge_work(exercise(lambda work: work.function("f")()), work)
    assert verdict.got.startswith("JSONDecodeError: Expecting value") and '(line 3: return json.loads("x"))' in verdict.got
    assert "(line 355" not in verdict.got


PACKAGE = """
from pathlib import Path
from coursekit.lab import workspace
%cd -q {workspace()}
folder = Path("src/slow")
folder.mkdir(parents=True)
(folder / "package.xml").write_text('''<package format="3">
<name>slow</name><version>0.0.0</version><description>d</description>
<maintainer email="a@example.com">a</maintainer><license>x</license>
<export><build_type>ament_python</build_type></export></package>''')
(folder / "setup.py").write_text("while True: pass")
%colcon build --packages-select slow
"""


def test_a_build_that_is_not_done_in_time_is_no_zero_that_looks_earned(work):
    assert work.run(PACKAGE, 20) == ""
    work.finish(1.0)
    assert work.build_timed_out
    verdict = judge_work(exercise(lambda work: work.built("slow")), work)
    late = _built_or_late(verdict, work)
    assert (late.passed, late.timed_out) == (False, True) and "mark this student again" in late.cause
    assert _built_or_late(judge_work(exercise(lambda work: None), work), work).timed_out is False
