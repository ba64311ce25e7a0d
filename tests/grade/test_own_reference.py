"""The reference for checks of one's own names what there is: no more, no less; its example can be judged."""

import dataclasses
import inspect
import re
from pathlib import Path

import pytest

from coursekit.grade import plain
from coursekit.grade.checking import judge, judge_work
from coursekit.grade.exercise import find
from coursekit.grade.own_checks import read_checks
from coursekit.grade.plan import Plan, Seen
from coursekit.grade.template import write_template
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "own_exercises.md").read_text(encoding="utf-8")


def section(heading):
    """The first column of the table under a heading."""
    (text,) = re.findall(rf"### {re.escape(heading)}\n(.*?)(?=\n##)", PAGE, re.S)
    return " ".join(line.split("|")[1] for line in text.splitlines() if line.startswith("| `"))


def methods(kind):
    return {name for name, member in vars(kind).items() if inspect.isfunction(member) and not name.startswith("_")}


def test_work():
    assert set(re.findall(r"work\.(\w+)\(", section("Work: the function's argument"))) == methods(Work)


def test_the_words_of_try_out():
    named = {
        parameter
        for parameter in inspect.signature(Work.try_out).parameters
        if parameter not in ("self", "commands", "plan")
    }
    fields = {field.name for field in dataclasses.fields(Plan)} - {"run"}
    assert set(re.findall(r"`(\w+)`", section("`try_out`: its arguments"))) == fields | named


def test_seen():
    fields = {field.name for field in dataclasses.fields(Seen)}
    assert set(re.findall(r"seen\.(\w+)", section("Seen: the result of `try_out`"))) == fields | methods(Seen)


def test_wrong():
    words = set(inspect.signature(Wrong).parameters) - {"timed_out"}
    assert set(re.findall(r"`(\w+)`", section("Wrong: what the student sees"))) == words


def test_plain_values():
    there = {
        name for name, member in vars(plain).items() if inspect.isfunction(member) and member.__module__ == plain.__name__
    }
    public = {name for name in there if not name.startswith("_")}
    assert set(re.findall(r"`(\w+)\(", section("Values that cannot be faked"))) == public


def test_what_the_reference_calls_takes_what_it_shows():
    for call in re.findall(r"`((?:work\.)?[a-z_]+\([^`]*\))`", PAGE[PAGE.index("## Reference") :]):
        name, _, inner = call.partition("(")
        kind = vars(Work)[name.removeprefix("work.")] if name.startswith("work.") else getattr(plain, name, None)
        if kind is not None:
            count = len(re.findall(r",(?![^\[(]*[\])])", inner[:-1])) + 1 + name.startswith("work.")
            named = re.findall(r"(\w+)=", inner)
            inspect.signature(kind).bind(*range(count - len(named)), **dict.fromkeys(named, 1))


def test_the_example_is_judged(tmp_path):
    (block,) = re.findall(r"```python\n(@exercise.*?)```", PAGE, re.S)
    write_template(tmp_path, "gripper")
    file = tmp_path / "checks" / "gripper.py"
    file.write_text(file.read_text() + "\n\n" + block)
    read_checks(file.parent)
    seen = {"late": [(2.0, {})], "silent": [], "good": [(1.2, {})]}

    class Tried(Work):
        def built(self, package, *of):
            assert package == "my_gripper"

        def try_out(self, *commands, **plan):
            Plan(run=[], **plan)
            return Seen(messages={"/gripper/closed": seen[self.variables["is"]]}, topics={"/x": []})

    points = {name: judge_work(find("gripper.q2"), Tried({"is": name}, tmp_path)).points for name in seen}
    assert points == {"late": 1.5, "silent": 0.75, "good": 3}


@pytest.mark.parametrize("wrong", [None, float("nan"), "x", [], True])
def test_the_template_s_check_has_words_for_what_is_no_number(tmp_path, wrong):
    write_template(tmp_path, "claw")
    read_checks(tmp_path / "checks")
    verdict = judge(find("claw.q1"), {"stopping_distance": lambda speed, deceleration: wrong}, tmp_path)
    assert not verdict.passed and not verdict.fault and verdict.expected.startswith("a number from stopping_distance(")
