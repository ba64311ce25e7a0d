"""JupyterLab's terminals on Windows: PowerShell, with what the course's folder is called taken as it is."""

import ast
from pathlib import Path

import pytest

from coursekit.cli import terminal_settings as module
from coursekit.systems import operating_system


@pytest.fixture
def settings(monkeypatch, tmp_path):
    """The command of a terminal and the script that it begins with, for a folder of this name and these programs."""

    def make(name, *programs):
        monkeypatch.setattr(operating_system, "WINDOWS", True)
        monkeypatch.setattr(module.shutil, "which", lambda one: f"C:\\{one}.exe" if one in programs else None)
        folder = tmp_path / name
        folder.mkdir()
        options = module.terminal_settings(folder)
        if not options:
            return None, b""
        words = ast.literal_eval(options[0].partition("=")[2])["shell_command"]
        return words, Path(words[-1]).read_bytes()

    return make


def test_the_newer_powershell_is_taken_where_it_is(settings):
    assert settings("one", "powershell", "pwsh")[0][0] == "C:\\pwsh.exe"
    assert settings("two", "powershell")[0][0] == "C:\\powershell.exe"
    assert settings("three", "bash") == (None, b"")


def test_scripts_may_run_in_it_and_it_stays_open(settings):
    words, _ = settings("course", "powershell")
    assert words[1:-1] == ["-NoLogo", "-NoExit", "-ExecutionPolicy", "Bypass", "-File"]


def test_the_script_is_read_as_utf_8_also_by_the_old_one(settings):
    _, script = settings("José's course", "powershell")
    assert script.startswith(b"\xef\xbb\xbf")
    assert script.decode("utf-8-sig").splitlines()[-1].endswith("José''s course'")


def test_a_name_is_no_program(settings):
    _, script = settings("$(calc)`n\u2019\u201b; calc", "powershell")
    assert "$(calc)`n\u2019\u2019\u201b\u201b; calc'" in script.decode("utf-8-sig")


def test_it_completes_ros2_and_colcon(settings):
    _, script = settings("course", "powershell")
    assert "'ros2', 'colcon'" in script.decode("utf-8-sig") and "--shell powershell" in script.decode("utf-8-sig")
