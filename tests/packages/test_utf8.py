"""colcon writes UTF-8, whatever the code page: on Windows it begins again in Python's UTF-8 mode, once."""

import sys
from types import SimpleNamespace

import pytest

from coursekit.packages import colcon_utf8
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
