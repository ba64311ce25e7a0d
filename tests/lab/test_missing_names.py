"""A cell that misses a name says where it comes from: after a restart students go on in the middle of a chapter."""

import json
from types import SimpleNamespace

import pytest

from coursekit.lab import missing_names


@pytest.mark.parametrize(
    "cell",
    [
        "robot = 1",
        "def robot():\n    pass",
        "class robot:\n    pass",
        "for robot in ():\n    pass",
        "here, robot = 1, 2",
        "with open('x') as robot:\n    pass",
        "%cd -q /tmp\nrobot = %sx ls",
        "if (robot := 1):\n    pass",
    ],
)
def test_a_name_that_another_cell_makes_is_told(cell):
    assert "`robot` is made in another cell" in missing_names.advice("robot", ["x = 1", cell])


@pytest.mark.parametrize("cell", ["import robot", "from urdf import robot_of as robot", "import robot.arm"])
def test_a_name_that_another_cell_imports_is_told_as_such(cell):
    assert "`robot` is imported in another cell" in missing_names.advice("robot", ["x = 1", cell])
    assert "`robot` is made in another cell" in missing_names.advice("robot", [cell, "robot = 1"])


def test_the_advice_says_that_an_unsolved_exercise_stops_the_cells_above():
    assert "stops at a check that is not passed yet" in missing_names.advice("robot", ["robot = 1"])


@pytest.mark.parametrize("cell", ["robots = 1", "print(robot)", "robot = (", "%%bash\nrobot=1", "", "robot.arm = 1"])
def test_other_names_are_not(cell):
    assert missing_names.advice("robot", [cell]) == ""


def missed(name):
    """A cell's result, as IPython tells it."""
    return SimpleNamespace(error_in_exec=NameError(f"name '{name}' is not defined", name=name))


def test_the_notebook_s_own_file_is_looked_at(tmp_path, monkeypatch, capsys):
    cells = [{"cell_type": "markdown", "source": ["arm = 1"]}, {"cell_type": "code", "source": ["x = 1\n", "robot = 2"]}]
    file = tmp_path / "a.ipynb"
    file.write_text(json.dumps({"cells": cells}), encoding="utf-8")
    monkeypatch.setenv("JPY_SESSION_NAME", str(file))
    for name in ("robot", "arm", "y"):
        missing_names._look(missed(name))
    assert capsys.readouterr().out.splitlines() == [missing_names.advice("robot", ["robot = 1"])]


@pytest.mark.parametrize("text", ["", "{", "[]", '{"cells": 3}', '{"cells": [{"cell_type": "code"}]}'])
def test_without_a_notebook_nothing_is_said(tmp_path, monkeypatch, capsys, text):
    file = tmp_path / "a.ipynb"
    file.write_text(text, encoding="utf-8")
    for path in (file, tmp_path, tmp_path / "none", ""):
        monkeypatch.setenv("JPY_SESSION_NAME", str(path))
        missing_names._look(missed("robot"))
    missing_names._look(SimpleNamespace(error_in_exec=None))
    missing_names._look(SimpleNamespace(error_in_exec=ValueError("x")))
    assert capsys.readouterr().out == ""
