"""start.py: the same on every system, and it says what is wrong with a Python before pip does."""

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

from tests.needs import posix

ROOT = Path(__file__).parents[1]


@pytest.fixture
def start(tmp_path, monkeypatch):
    """The module, in a folder of its own, which notes the commands in place of running them."""
    spec = importlib.util.spec_from_file_location("start", ROOT / "start.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.ran = []

    def run(command, **extra):
        module.ran.append((command, extra))
        if command[1:3] == ["-m", "venv"]:
            (Path(command[3]) / "bin").mkdir(parents=True)
            (Path(command[3]) / "bin" / "python").touch()
        return 0

    for name in ("pyproject.toml", "requirements.lock"):
        (tmp_path / name).touch()
    monkeypatch.setattr(module, "run", run)
    monkeypatch.setattr(module, "ROOT", tmp_path)
    monkeypatch.setattr(module, "VENV", tmp_path / ".venv")
    return module


def commands(start):
    return [" ".join(command[1:4]) for command, _ in start.ran]


@posix("there a Python lies in Scripts")
def test_without_a_word_it_sets_up_once_and_opens_the_course(start):
    assert start.main([]) == 0
    setup_commands = [f"-m venv {start.VENV}", "-m pip install", "-m compileall -q"]
    assert commands(start) == [*setup_commands, "-m coursekit.cli.coursekit lab"]
    start.ran.clear()
    assert start.main(["lab", "--no-browser"]) == 0
    underlay_command, opened = (command for command, _ in start.ran)
    assert underlay_command[1:] == ["-m", "coursekit.building.underlay"] and opened[-2:] == ["lab", "--no-browser"]


@posix("there a Python lies in Scripts")
def test_what_the_tests_need_is_enough_for_the_course(start):
    start.main(["setup", "test"])
    assert next(command for command, _ in start.ran if "pip" in command)[-2:] == ["-e", ".[test]"]
    start.ran.clear()
    start.main(["setup"])
    assert commands(start) == ["-m coursekit.building.underlay"]


def test_the_chapters_run_on_the_virtual_clock_after_the_tests(start):
    start.main(["test", "-x"])
    tests, chapters = start.ran[-2:]
    assert tests[0][-1] == "-x" and tests[1] == {}
    assert chapters[0][-1] == "notebooks" and chapters[1] == {"COURSEKIT_TIME": "virtual"}


def test_a_command_that_fails_ends_it_with_its_code(start, monkeypatch):
    monkeypatch.setattr(start, "run", lambda command, **_: 7)
    with pytest.raises(SystemExit) as ended:
        start.main(["setup"])
    assert ended.value.code == 7


def test_an_unknown_word_is_told_with_the_known_ones(start, capsys):
    assert start.main(["tset"]) == 2
    said = capsys.readouterr().err
    assert "There is no 'tset'" in said and "start.py test" in said


@pytest.mark.parametrize(
    ("facts", "said"),
    [
        ({"version_info": (3, 9, 18)}, "3.10 or newer"),
        ({"maxsize": 2**31 - 1}, "64-bit"),
        ({"platform": "win32", "version": "3.12.1 (main) [MSC v.1943 64 bit (ARM64)]"}, "ARM"),
        ({"platform": "darwin", "version_info": (3, 14, 0), "machine": "x86_64"}, "python3.13 start.py"),
    ],
)
def test_a_python_that_cannot_have_the_packages_is_told(start, monkeypatch, capsys, facts, said):
    machine = facts.pop("machine", "ARM64") if (facts := dict(facts)) else "ARM64"
    monkeypatch.setattr(start.platform, "machine", lambda: machine)
    monkeypatch.setattr(start.platform, "python_version", lambda: "3")
    for name, value in facts.items():
        monkeypatch.setattr(sys, name, value)
    code = start.main(["lab"])
    monkeypatch.undo()
    assert code == 1 and said in capsys.readouterr().err and start.ran == []


@posix("its programs of pip are no scripts of a shell")
@pytest.mark.parametrize(("name", "refused"), [('a "b" $(c)', '" and $'), ("`a`", "`"), ("a\\b", "\\"), ("ñ o' %d", "")])
def test_a_folder_whose_name_pip_s_scripts_would_run_is_refused_in_a_sentence(start, monkeypatch, capsys, name, refused):
    monkeypatch.setattr(start, "ROOT", Path("/home/ada", name))
    assert start.main(["lab"]) == bool(refused)
    said = capsys.readouterr().err
    assert (f"take {refused} for commands. Rename the folder" in said) == bool(refused)
    assert bool(start.ran) != bool(refused)


@pytest.mark.parametrize(
    ("folder", "version", "editable"),
    [("C:/course", (3, 11), True), ("C:/José/course", (3, 11), False), ("C:/José/course", (3, 13), True)],
)
def test_in_a_folder_with_an_accent_an_older_python_on_windows_gets_a_copy(start, monkeypatch, folder, version, editable):
    monkeypatch.setattr(start, "ROOT", Path(folder))
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(sys, "version_info", version)
    words = start.what_to_install("test")
    monkeypatch.undo()
    assert words == (["-e", ".[test]"] if editable else [".[test]"])


def test_an_older_python_can_read_it_to_the_end_of_its_refusal():
    """The words of `ast` for Python 3.7, which has no newer syntax."""
    code = f"import ast; ast.parse(open({str(ROOT / 'start.py')!r}, encoding='utf-8').read(), feature_version=(3, 7))"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_the_file_to_double_click_has_the_line_ends_of_windows():
    text = (ROOT / "start.bat").read_bytes()
    assert text.count(b"\r\n") == text.count(b"\n") > 10
    assert b"%~dp0" in text and b"start.py %*" in text
