"""What a check says: the fault in the student's own words and lines, the hint that fits, and nothing that confuses."""

import ast
import math
import os
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path

import pytest

from coursekit.grade import chapters
from coursekit.grade.checking import check, judge, judge_work
from coursekit.grade.exception_advice import DIED as OTHERWISE
from coursekit.grade.exercise import Exercise, UnknownExercise, find
from coursekit.grade.outputs import exception_in
from coursekit.grade.plain import called, number
from coursekit.grade.plan import Seen
from coursekit.grade.verdict import Verdict, Wrong
from coursekit.grade.work import Work

HINTS = ("first", "second", "third")
DIED = """[INFO] [1.0] [n]: hello
Traceback (most recent call last):
  File "/ws/install/p/lib/p/p_exe", line 33, in <module>
    sys.exit(load_entry_point('p', 'console_scripts', 'p_exe')())
  File "/ws/install/p/lib/python3.10/site-packages/s2_py_pubsub/node.py", line 12, in __init__
    self.create_timer(1.0, self.speek)
AttributeError: 'PyPublisher' object has no attribute 'speek'
"""
ENDED = DIED.replace("AttributeError: 'PyPublisher' object has no attribute 'speek'", "KeyboardInterrupt")


def exercise(judge):
    return Exercise("ch99.q1", "Try", 1, HINTS, judge)


def raises(*args, **kwargs):
    def judge(work):
        raise Wrong(*args, **kwargs)

    return exercise(judge)


class Tried(Work):
    """Work whose programs said this."""

    def __init__(self, *outputs):
        super().__init__({}, None)
        self._outputs = list(outputs)

    def try_out(self, *commands, **plan):
        return Seen(outputs=self._outputs, exit_codes=[1] * len(self._outputs))


def test_expected_given_and_seen_are_three_things():
    text = Verdict("ch99.q1", "Try", 0, 1, "x", got="y", gave="z").text()
    assert text.splitlines() == ["✘ ch99.q1 Try: 0 of 1 point", "  expected: x", "  you gave: z", "  seen: y"]
    assert asdict(judge_work(raises("x", gave="7"), None))["gave"] == "7"


@pytest.mark.parametrize(("of", "said"), [(1, "1 of 1 point"), (2, "2 of 2 points"), (0.5, "0.5 of 0.5 points")])
def test_one_point_is_one_point(of, said):
    verdict = Verdict("a", "b", of, of)
    assert verdict.text().endswith(f": {said}") and verdict.html().endswith(f"{said.partition(' ')[2]}</div>")


@pytest.mark.parametrize(("tries", "hint"), [(1, ""), (2, "third"), (5, "third")])
def test_the_hint_follows_the_fault_where_the_judge_can_tell(tries, hint):
    assert judge_work(raises("x", hint=2), None, tries).hint == hint


@pytest.mark.parametrize(("tries", "hint"), [(1, ""), (2, "first"), (3, "second"), (9, "third")])
def test_else_each_try_gives_the_next_one(tries, hint):
    assert judge_work(raises("x"), None, tries).hint == hint


def test_a_program_s_own_exception_comes_before_what_is_missing():
    def judge(work):
        work.try_out("run s2_py_pubsub publisher_exe")
        raise Wrong("a node", "nodes: none")

    verdict = judge_work(exercise(judge), Tried("", DIED))
    line = "line 12 of node.py: self.create_timer(1.0, self.speek)"
    told = f"AttributeError: 'PyPublisher' object has no attribute 'speek' ({line})"
    assert verdict.got == f"your program raised {told}; nodes: none"


@pytest.mark.parametrize("output", ["", "hello\n", ENDED, DIED.split("  File")[0]])
def test_ctrl_c_and_quiet_ends_are_no_deaths(output):
    assert exception_in(output) == ""


def test_an_exception_in_a_launched_program_is_told_too():
    lines = "".join(f"[p_exe-1] {line}\n" for line in DIED.splitlines())
    assert exception_in(lines).startswith("AttributeError: 'PyPublisher'")


@pytest.mark.parametrize(
    ("kind", "value", "cause"),
    [(list, (1, 2), "square brackets"), (str, 3, "quotes"), (int, "2", "without quotes"), (list, None, "returns nothing")],
)
def test_a_value_of_another_type_is_told_how_to_be_written(kind, value, cause):
    assert cause in judge_work(exercise(lambda work: work.value("x", kind)), Work({"x": value}, None)).cause


@pytest.mark.parametrize(("kind", "value"), [(int, "hello"), (float, "nan"), (int, ""), (float, "1.5 m")])
def test_a_text_that_is_no_number_is_not_told_to_lose_its_quotes(kind, value):
    assert judge_work(exercise(lambda work: work.value("x", kind)), Work({"x": value}, None)).cause == ""


def test_a_module_that_is_not_imported_is_told_how_to_import():
    with pytest.raises(Wrong) as caught:
        called(lambda: math_.pi, told="f()")  # noqa: F821
    assert "After a restart" in caught.value.cause
    with pytest.raises(Wrong) as caught:
        called(lambda: random.random(), told="f()")  # noqa: F821
    assert "`import random`" in caught.value.cause


def test_a_stub_stays_a_stub():
    def stub():
        raise NotImplementedError

    assert judge_work(exercise(lambda work: called(stub, told="f()")), None).got == "the stub is still there"


@pytest.mark.parametrize(("value", "cause"), [(None, "return"), (math.nan, "divided"), ("7", "")])
def test_what_is_no_number_is_told_with_its_likely_cause(value, cause):
    with pytest.raises(Wrong) as caught:
        number(value, "a number")
    assert cause in caught.value.cause and caught.value.gave == repr(value)


def test_a_build_that_is_older_than_its_source_is_refused_with_what_to_type(tmp_path, monkeypatch):
    marker = tmp_path / "install" / "p" / "share" / "ament_index" / "resource_index" / "packages" / "p"
    marker.parent.mkdir(parents=True)
    marker.touch()
    work_of = exercise(lambda work: work.built("p"))
    assert judge(work_of, {}, tmp_path).passed
    told = "setup.py of p was changed after the last build"
    monkeypatch.setattr("coursekit.packages.build_state.build_fault", lambda folder, package, of: told)
    verdict = judge(work_of, {}, tmp_path)
    assert (verdict.points, verdict.got, verdict.cause) == (0, told, "Run: %colcon build --packages-select p")


@pytest.mark.parametrize("name", ["ch02.q9", "ch02.q", "q1", "", "ch2.q1"])
def test_an_unknown_name_gets_a_short_answer_without_a_traceback(name):
    with pytest.raises(UnknownExercise) as caught:
        check(name)
    shown = caught.value._render_traceback_()
    assert len(shown) == 1 and shown[0].startswith(f"There is no exercise '{name}'.") and "q1" in shown[0]


def test_the_names_of_the_chapter_are_listed():
    with pytest.raises(UnknownExercise, match=r"There are: ch02.q1, ch02.q2, ch02.q3, ch02.q4, ch02.q5\.$"):
        find("ch02.q9")


RULES = """def full_name(name, node, namespace):
    inside = namespace.rstrip("/")
    if name.startswith("/"):
        return name
    if name.startswith("~/"):
        return f"{inside}/{node}{name[1:]}"
    LONE
    return f"{inside}/{name}"
"""


def named(lone):
    """The verdict on an answer to ch02.q1 that does this with a `~` alone."""
    scope = {}
    exec(compile(RULES.replace("LONE", lone), "<cell>", "exec"), scope)
    return judge(find("ch02.q1"), scope, None, tries=2)


@pytest.mark.parametrize("lone", ["pass", 'if name == "~":\n        return f"{inside}/{node}/"'])
def test_a_lone_tilde_is_told_as_the_only_case_that_is_missing(lone):
    """`~` alone is the node itself; who has all the other rows right hears of this row, and keeps half."""
    verdict = named(lone)
    assert verdict.points == 0.5 and verdict.expected.startswith("full_name('~', "), verdict.text()
    assert "`~` alone" in verdict.cause and verdict.hint == find("ch02.q1").hints[0]


def test_a_lone_tilde_that_is_the_node_earns_all():
    assert named('if name == "~":\n        return f"{inside}/{node}"').passed


def test_what_else_is_wrong_comes_before_the_lone_tilde():
    verdict = named("return name")
    assert verdict.points == 0 and "~" not in verdict.expected, verdict.text()


@pytest.mark.parametrize(
    ("name", "variable", "answer"),
    [
        ("ch00.q2", "presses", [("forward", 1.0)]),
        ("ch00.q2", "presses", [("up", "1.0")]),
        ("ch01.q1", "rosout_publishers", "2"),
        ("ch01.q2", "moves", [(1, 2)]),
        ("ch01.q4", "dance", [1, 2]),
        ("ch01.q4", "dance", [(1.0, 2.0, 90.0)]),
    ],
)
def test_an_answer_of_the_wrong_form_gets_no_hint_about_something_else(name, variable, answer):
    others = {"presses": [], "rosout_publishers": 2, "rosout_type": "a/msg/B", "moves": [], "dance": []}
    said = judge_work(find(name), Work(others | {variable: answer}, None), 4)
    assert said.expected and said.gave
    assert said.hint == ""


def test_of_many_times_those_are_shown_that_are_wrong():
    said = judge_work(find("ch01.q4"), Work({"dance": [(at, 2, 1) for at in range(23)]}, None))
    assert (said.expected, said.gave) == ("times from 0 to 20 seconds", "[21.0, 22.0]")


def test_every_fault_of_the_chapters_names_its_hint_or_its_likely_cause():
    """A hint that comes with the number of tries is about something else as often as not."""
    silent = []
    for file in sorted(Path(chapters.__path__[0]).rglob("*.py")):
        for call in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "Wrong":
                named = {keyword.arg for keyword in call.keywords}
                silent += [f"{file.name}:{call.lineno}"] if not named & {"hint", "cause"} and len(call.args) < 3 else []
    assert silent == []


@pytest.mark.parametrize("tries", [2, 5])
def test_a_likely_cause_stands_alone_where_no_hint_is_named(tries):
    said = judge_work(raises("x", "y", "Which topic?"), None, tries)
    assert (said.cause, said.hint) == ("Which topic?", "")


def run_by_an_executor(callback):
    """What a program says whose executor calls this callback with one value."""
    return f"""Traceback (most recent call last):
  File "/ws/install/p/lib/python3.10/site-packages/s2_py_pubsub/ear.py", line 21, in main
    rclpy.spin(node)
TypeError: {callback}() takes 1 positional argument but 2 were given
"""


def test_a_callback_without_self_is_told_by_its_name_not_by_the_line_of_spin():
    def judge(work):
        work.try_out("run s2_py_pubsub ear_exe")
        raise Wrong("a line in the log", "none")

    assert "`def heard(self, msg):`" in judge_work(exercise(judge), Tried(run_by_an_executor("Ear.heard"))).cause
    assert judge_work(exercise(judge), Tried(run_by_an_executor("heard"))).cause == OTHERWISE


CELLS = """
import sys
from IPython.core.interactiveshell import InteractiveShell
shell = InteractiveShell.instance()
for cell in ("me = 'Vera'\\nfrom coursekit.grade.checking import check", *sys.argv[1:], "check('ch00.q1')"):
    shell.run_cell(cell)
"""


def checked_after(folder, *cells):
    own = {"COURSEKIT_WORKSPACE": str(folder / "ros2_ws"), "IPYTHONDIR": str(folder), "PYTHONUTF8": "1"}
    done = [sys.executable, "-c", CELLS, *cells]
    return subprocess.run(done, cwd=folder, env=os.environ | own, capture_output=True, encoding="utf-8", check=True).stdout


@pytest.mark.parametrize(
    ("cell", "told"),
    [
        ("me = 'Vera Course", "SyntaxError"),
        ("me = Vera + 'Course'", "NameError: name 'Vera' is not defined"),
        ("raise NotImplementedError()", "NotImplementedError. What was judged is older"),
    ],
)
def test_an_answer_that_is_older_than_a_failed_cell_is_told_as_such(tmp_path, cell, told):
    said = checked_after(tmp_path, cell)
    assert f"The cell before this check stopped with {told}" in said and "you gave: 'Vera'" in said


def test_a_check_that_failed_before_is_no_failed_cell(tmp_path):
    assert "The cell before" not in checked_after(tmp_path, "check('ch00.q1')")
