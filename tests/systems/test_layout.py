"""What setuptools installs on Windows is found where it is: NAME.exe with NAME-script.py, and Lib/site-packages."""

from pathlib import Path

import pytest

from coursekit.systems import layout, operating_system


@pytest.fixture
def windows(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)


def test_a_name_stands_for_an_exe_on_windows_only(windows, monkeypatch):
    assert [file.name for file in layout.executable_files(Path("lib"), "talker")] == ["talker", "talker.exe"]
    monkeypatch.setattr(operating_system, "WINDOWS", False)
    assert [file.name for file in layout.executable_files(Path("lib"), "talker")] == ["talker"]


def test_an_exe_of_setuptools_is_its_script_and_any_other_is_itself(tmp_path):
    exe, script = tmp_path / "talker.exe", tmp_path / "talker-script.py"
    exe.touch()
    assert layout.python_script(exe) == exe
    script.touch()
    assert layout.python_script(exe) == script
    assert layout.is_executables_part(script)
    assert not layout.is_executables_part(exe)


def test_a_file_that_only_has_such_a_name_is_a_program(tmp_path):
    (tmp_path / "talker-script.py").touch()
    assert not layout.is_executables_part(tmp_path / "talker-script.py")


def test_modules_of_a_prefix_lie_in_lib_site_packages_on_windows(windows):
    assert layout.site_packages(Path("install")) == Path("install/Lib/site-packages")
