"""Values in the lines of magics: a path is part of one word, other values are as many as they hold."""

from pathlib import Path

import pytest
from IPython.core.interactiveshell import InteractiveShell

from coursekit.lab import magics
from tests.paths.workspace import HOSTILE

HOME = str(Path("/home") / HOSTILE)


@pytest.fixture
def words(monkeypatch):
    """words("line") gives what `%ros2 line` is divided into, in a cell that knows some names."""
    shell, titles = InteractiveShell(), []
    shell.register_magics(magics.CourseMagics(shell))
    monkeypatch.setattr(magics, "_attend", lambda begin, title, options, background: titles.append(title))
    monkeypatch.setattr(magics, "_title", lambda argv: argv)
    here = str(Path(__file__).parent)
    shell.user_ns |= {"place": Path("/home") / HOSTILE, "more": "-r a:=b", "real": here, "pair": ["x y"]}

    def run(line):
        shell.run_cell(line).raise_error()
        return titles.pop()

    run.shell = shell
    return run


def test_a_path_is_one_word_with_what_stands_beside_it(words):
    assert words("%ros2 run p e {place}/map -p f:={place} {real}/x") == [
        "run", "p", "e", f"{HOME}/map", "-p", f"f:={HOME}", f"{Path(__file__).parent}/x"
    ]  # fmt: skip
    assert words("%ros2 service call /s t \"{{filename: {place}/graph}}\"")[-1] == f"{{filename: {HOME}/graph}}"
    assert words("%ros2 run p e $place {place}")[2:] == ["e", HOME, HOME]


def test_an_apostrophe_of_a_path_is_doubled_within_quotes_of_yaml(words):
    doubled = HOME.replace("'", "''")
    assert words("%ros2 service call /s t \"{{filename: '{place}/graph'}}\"")[-1] == f"{{filename: '{doubled}/graph'}}"


def test_cd_goes_into_a_folder_whatever_its_name_and_back(words, tmp_path, monkeypatch, capsys):
    course = tmp_path / HOSTILE
    course.mkdir()
    monkeypatch.chdir(tmp_path)
    shell = words.shell
    shell.user_ns["course"] = course
    shell.run_cell("%cd -q {course}").raise_error()
    assert Path.cwd() == course and not capsys.readouterr().out
    shell.run_cell("%cd -q ..").raise_error()
    assert Path.cwd() == tmp_path
    shell.run_cell("%cd -").raise_error()
    assert Path.cwd() == course and str(course) in capsys.readouterr().out


def test_other_values_are_as_many_words_as_they_hold(words):
    assert words("%ros2 run p e --ros-args {more} $more {pair[0]}")[4:] == ["-r", "a:=b", "-r", "a:=b", "x", "y"]


def test_braces_of_yaml_stay_as_they_are(words):
    assert words("%ros2 topic pub /t T \"{linear: {x: 1.0}}\"")[-1] == "{linear: {x: 1.0}}"


def test_names_of_a_loop_and_of_a_function_are_known(words):
    program = "def f(inner):\n    get_ipython().run_line_magic('ros2', 'run {inner}')\nf('talk')"
    assert words(program) == ["run", "talk"]


def test_a_name_without_a_value_is_told(words, capsys):
    assert words("%ros2 launch p f model:={robots}/a.urdf")[-1] == "model:={robots}/a.urdf"
    told = "`robots` has no value yet, and stays as it was typed: run the cell that makes it."
    assert told in capsys.readouterr().out
    words("%ros2 topic pub /t T \"{{data: {more}}}\"")
    assert not capsys.readouterr().out
