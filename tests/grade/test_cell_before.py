"""What a check says of the cells run before it: only what has to do with the exercise, in the student's words."""

from types import SimpleNamespace

import pytest
from IPython.core.error import UsageError

from coursekit.grade.cell_before import explained
from coursekit.grade.checking import judge
from coursekit.grade.exercise import Exercise
from coursekit.grade.verdict import Verdict
from coursekit.grade.work import Work
from coursekit.lab.errors import NotThere

WRONG = Verdict("ch02.q1", "Names", 0, 1, "a name", "another", "the judge's own cause", "a hint")
OTHER = "def shown(x):\n    pass"
FIRST, SECOND = "def full_name(name):\n    return name", "def full_nam(name):\n    return '/' + name"


def shell(cell="", error=None, cells=(), variables=()):
    """A notebook in which this cell ended with this error, and these variables exist."""
    info = SimpleNamespace(raw_cell=cell)
    before = SimpleNamespace(error_before_exec=None, error_in_exec=error, info=info)
    return SimpleNamespace(last_execution_result=before, user_ns={**dict.fromkeys(variables), "In": ["", *cells]})


def cause(asked, **of):
    return explained(WRONG, dict.fromkeys(asked), shell(**{"variables": asked, **of})).cause


@pytest.mark.parametrize(
    ("cell", "asked"),
    [
        ("full_name = 3 / 0", ["full_name"]),
        ("%%writefile -a src/s2_py_pubsub/s2_py_pubsub/py_ear.py\nx", ["s2_py_pubsub", "py_ear"]),
        ("anything", []),
    ],
)
def test_a_failed_cell_about_the_exercise_is_blamed(cell, asked):
    assert "The cell before this check stopped with KeyError: 'x'" in cause(asked, cell=cell, error=KeyError("x"))


@pytest.mark.parametrize("cell", ["%show nowhere.py", "1 / 0", "full_names = 1 / 0"])
def test_another_cell_is_not(cell):
    assert cause(["full_name"], cell=cell, error=KeyError("x")) == WRONG.cause


def test_words_for_students_are_shown_without_the_name_of_a_class():
    said = cause(["robot"], cell="robot = load('vera')", error=NotThere("There is no vera. Is the name right?"))
    assert 'stopped with "There is no vera. Is the name right?".' in said and "NotThere" not in said


def test_other_errors_keep_theirs():
    assert "stopped with UsageError: no" in cause(["robot"], cell="%robot", error=UsageError("no"))


def test_an_older_function_under_the_right_name_is_told():
    said = cause(["full_name"], cells=[FIRST, SECOND])
    assert said.startswith("A newer cell defines `full_nam`. What was judged is `full_name`, which is older.")


@pytest.mark.parametrize(
    "cell", ["Me = 'Vera Course'", "mee = 3", "ME: str = ''", "Me , x = 'Vera', 3", "Me = 3\n%ros2 node list\n"]
)
def test_a_variable_that_was_set_under_another_name_is_told(cell):
    name = cell.split()[0].rstrip(":")
    assert cause(["me"], cell=cell).startswith(f"The cell before this check sets `{name}`, and `me` is judged, which")


@pytest.mark.parametrize("cell", ["x = 3", "me == 3", "    Me = 3", "Me.x = 3", "me = 4\nMe = 3", "check('ch00.q1')", ""])
def test_another_variable_is_not(cell):
    assert cause(["me"], cell=cell) == WRONG.cause


@pytest.mark.parametrize(
    ("asked", "cell"),
    [
        ("full_name", f"{FIRST}\nfull_names = [full_name(name) for name in 'ab']"),
        ("full_name", f"{FIRST}\nfull_names = []"),
        ("commands", "command = 'node list'\ncommands.append(command)"),
        ("commands", "command = 'node list'\ncommands += [command]"),
        ("moves", "move = (1.0, 0.0, 1.0)\nmoves[0] = move"),
        ("moves", "move = (1.0, 0.0, 1.0)\nstart, moves = 0, [move]"),
        ("moves", "move = (1.0, 0.0, 1.0)\nmoves: list[int] = [move]"),
        ("moves", "move = 1\nfor moves in ([move], [move, move]):\n    pass"),
        ("moves", "move = 1\nfrom plans import best as moves"),
        ("moves", "move = 1\ndel moves[0]"),
        ("moves", "%%writefile plan.py\nmove = 1"),
        ("moves", "move += 1"),
        ("moves", "move: int"),
    ],
)
def test_a_cell_that_uses_the_judged_name_or_sets_no_other_has_no_slip(asked, cell):
    assert cause([asked], cell=cell) == WRONG.cause


def test_two_judged_names_that_are_alike_are_no_slips():
    assert cause(["move", "moves"], cell="move = 3") == WRONG.cause


def test_of_a_name_that_does_not_exist_nothing_older_is_told():
    assert cause(["me"], cell="Me = 'Vera Course'", variables=[]) == WRONG.cause


@pytest.mark.parametrize(
    "cells",
    [[FIRST], [SECOND, FIRST], [SECOND, FIRST, SECOND], [FIRST, OTHER], [f"{FIRST}\n{SECOND}"], [SECOND]],
)
def test_a_function_that_is_the_newest_is_judged_without_a_word(cells):
    assert cause(["full_name"], cells=cells) == WRONG.cause


def test_a_solved_exercise_needs_no_explanation():
    solved = Verdict("ch02.q1", "Names", 1, 1)
    assert explained(solved, {"full_name": None}, shell(cells=[FIRST, SECOND])) == solved


@pytest.mark.parametrize("ask", [lambda work: work.function("full_name"), lambda work: work.value("full_name", str)])
def test_a_missing_name_is_looked_for_under_a_similar_one(ask):
    exercise = Exercise("ch99.q1", "Try", 1, (), ask)
    assert judge(exercise, {"full_nam": len, "x": 1}, None).cause == "There is `full_nam`. Is its name a slip?"
    assert "Was the cell above run" in judge(exercise, {"x": 1}, None).cause


def test_work_knows_the_names_that_a_judge_looked_for(tmp_path):
    work = Work({"full_name": len}, tmp_path)
    work.function("full_name")
    work.exists("src/s2_py_pubsub/py_ear.py")
    assert list(work.asked) == ["full_name", "s2_py_pubsub", "py_ear"]
