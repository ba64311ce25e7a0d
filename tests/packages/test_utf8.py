"""colcon writes UTF-8, whatever the code page: on Windows it begins again in Python's UTF-8 mode, once."""

import asyncio
import sys
from types import SimpleNamespace

import pytest
from colcon_core import shell

from coursekit.packages import colcon_utf8
from coursekit.packages.windows_quotes import word_for_cmd
from coursekit.systems import operating_system


@pytest.fixture
def begun(monkeypatch):
    """The commands that are begun, which end with 3."""
    commands = []

    def call(command, env):
        commands.append((command, env["PYTHONUTF8"]))
        return 3

    monkeypatch.setattr(colcon_utf8.subprocess, "call", call)
    code_page = SimpleNamespace(utf8_mode=0)
    words = ["colcon", "build", "--packages-select", "x"]
    monkeypatch.setattr(colcon_utf8, "sys", SimpleNamespace(flags=code_page, executable=sys.executable, argv=words))
    return commands


def test_elsewhere_it_goes_on_as_it_is(begun, monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", False)
    assert colcon_utf8.InUtf8().decorate_argument_parser(parser="parser") == "parser"
    assert begun == []


def test_on_windows_it_begins_again_and_ends_with_that_ones_exit_code(begun, monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    with pytest.raises(SystemExit) as ended:
        colcon_utf8.InUtf8().decorate_argument_parser(parser="parser")
    assert ended.value.code == 3
    words = [sys.executable, "-X", "utf8", "-m", "colcon", "build", "--packages-select", "x"]
    assert begun == [(words, "1")]


def test_on_windows_the_shells_variables_are_read_whatever_the_code_page(monkeypatch):
    asked = []

    async def answer(args, **options):
        asked.append((args, options))
        said = "a hook says día\r\n".encode("cp850") + args[-7].encode() + b" \r\n"
        return said + "COURSE=C:\\Users\\día\r\nOTHER=1\r\n".encode("utf-16-le")

    monkeypatch.setattr(operating_system, "WINDOWS", True)
    monkeypatch.setattr(colcon_utf8, "sys", SimpleNamespace(flags=SimpleNamespace(utf8_mode=1)))
    monkeypatch.setattr(colcon_utf8, "check_output", answer)
    monkeypatch.setattr(shell, "check_output", shell.check_output)
    monkeypatch.setattr(shell.locale, "getpreferredencoding", lambda: "utf-8")
    colcon_utf8.InUtf8().decorate_argument_parser(parser="parser")
    variables = asyncio.run(shell.get_environment_variables([r"C:\Users\día\set.bat", "&&", "set"], cwd="C:/"))
    assert variables == {"COURSE": r"C:\Users\día", "OTHER": "1"}
    [(words, options)] = asked
    assert words[:3] == [r"C:\Users\día\set.bat", "&&", "echo"] and words[4:] == ["&&", "cmd", "/d", "/u", "/c", "set"]
    assert options == {"cwd": "C:/", "shell": True}


@pytest.mark.skipif(not operating_system.WINDOWS, reason="cmd is Windows'")
def test_cmd_itself_answers_in_every_alphabet(monkeypatch):
    monkeypatch.setattr("colcon_core.subprocess.escape_shell_argument", word_for_cmd)
    monkeypatch.setenv("CK_FOLDER", "día, 日")
    lines = asyncio.run(colcon_utf8.output_in_utf8(["setlocal", "&&", "set"], shell=True)).decode().splitlines()
    assert "CK_FOLDER=día, 日" in lines
