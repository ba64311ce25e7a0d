"""What an older run of a cell has left behind is no answer."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from coursekit.grade import answer_age
from coursekit.grade.answer_age import AnswerAge, fault_of
from coursekit.grade.cell_before import explained
from coursekit.grade.verdict import CheckFailed, Verdict

RIGHT = "moves = [(0.0, 0.785, 1.0)]"
PASSED = Verdict("ch01.q2", "Into the corner", 2, 2)


@pytest.fixture
def kernel():
    """Runs cells as a kernel does: `kernel(text, cell="answer")`; `kernel.age` has followed them."""
    variables = {"In": []}
    age = AnswerAge()

    def run(text, cell="answer", within=lambda: None):
        age.begin(cell, variables)
        result = SimpleNamespace(error_before_exec=None, error_in_exec=None)
        try:
            exec(compile(text, "cell", "exec"), {**variables, "within": within}, kept := {})
        except SyntaxError as error:
            result.error_before_exec, kept = error, {}
        except Exception as error:
            result.error_in_exec = error
        variables.update(kept)
        age.end(text, fault_of(result), variables)

    run.age, run.variables = age, variables
    return run


@pytest.mark.parametrize(
    ("newer", "why"),
    [
        ("moves = [(0.0, 0.785, 1.0)", "stopped with SyntaxError: '[' was never closed in its line 1"),
        ("moves = [(0.0, quarter, 1.0)]", "stopped with NameError: name 'quarter' is not defined"),
        ("moves = moves + nothing", "stopped with NameError"),
        ("move = [(0.0, 0.785, 1.0)]", "does not set it any more"),
        ("# moves = []", "does not set it any more"),
        ("pass", "does not set it any more"),
    ],
)
def test_a_run_that_does_not_set_it_leaves_an_older_one(kernel, newer, why):
    kernel(RIGHT)
    kernel(newer)
    kernel("x = 3", cell="another")
    assert why in kernel.age.told("moves") and "`moves`" in kernel.age.told("moves")


@pytest.mark.parametrize(
    "newer",
    [RIGHT, "moves = []", "moves.append(3)", "moves[0] = 1", "plan = 3\nmoves = [plan]", f"{RIGHT}\n1 / 0", "moves = 4"],
)
def test_a_run_that_sets_or_changes_it_does_not(kernel, newer):
    kernel(RIGHT)
    kernel(newer)
    assert kernel.age.told("moves") == ""


def test_a_number_that_is_set_to_the_same_again_is_new(kernel):
    for _ in range(2):
        kernel("count = 3")
        assert kernel.age.told("count") == ""


def test_only_the_cell_that_set_it_last_matters(kernel):
    kernel(RIGHT)
    kernel("moves = [1]", cell="copy")
    kernel("pass")
    assert kernel.age.told("moves") == ""
    kernel("print(moves)", cell="look")
    kernel("pass", cell="copy")
    assert kernel.age.told("moves")
    kernel("moves = [2]", cell="copy")
    assert kernel.age.told("moves") == ""


def test_a_check_within_the_answer_s_cell_sees_what_the_cell_has_set(kernel):
    kernel(RIGHT)
    kernel("moves = ]")
    told = []
    kernel(f"{RIGHT}\nwithin()", within=lambda: told.append(kernel.age.told("moves")))
    assert told == [""]


def test_what_is_unknown_or_gone_is_not_called_older(kernel):
    assert kernel.age.told("moves") == ""
    kernel(RIGHT, cell="")
    assert kernel.age.told("moves") == ""
    kernel(RIGHT)
    del kernel.variables["moves"]
    kernel("pass")
    assert kernel.age.told("moves") == ""


def test_a_check_that_is_not_solved_is_no_fault():
    assert fault_of(SimpleNamespace(error_before_exec=None, error_in_exec=CheckFailed("not yet"))) == ""


@pytest.mark.parametrize("verdict", [PASSED, replace(PASSED, points=0, of=0)], ids=["points", "voluntary"])
def test_an_older_answer_does_not_pass(kernel, monkeypatch, verdict):
    monkeypatch.setitem(answer_age._of_kernel, "age", kernel.age)
    shell = SimpleNamespace(last_execution_result=None, user_ns=kernel.variables)
    kernel(RIGHT)
    assert explained(verdict, {"moves": None}, shell) == verdict
    kernel("moves = [")
    said = explained(verdict, {"moves": None}, shell)
    assert not said.passed and said.points == 0 and "stopped with SyntaxError" in said.cause
    kernel(RIGHT)
    assert explained(verdict, {"moves": None}, shell) == verdict
