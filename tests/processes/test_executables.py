"""Executables of packages: found by name, run with fresh modules."""

import os
import sys

import pytest

from coursekit.processes.child import ChildProcess
from coursekit.processes.executables import ExecutableNotFound, PackageNotFound, executables_of, find, is_python, packages
from coursekit.processes.session import Session
from coursekit.systems import operating_system
from tests.needs import posix


@pytest.fixture
def prefix(tmp_path, monkeypatch):
    """An install folder with one package and a way to add programs to it."""
    (tmp_path / "share/ament_index/resource_index/packages").mkdir(parents=True)
    (tmp_path / "share/ament_index/resource_index/packages/mine").touch()
    (tmp_path / "lib/mine").mkdir(parents=True)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))

    def add(name, text, package="mine"):
        path = tmp_path / "lib" / package / name
        path.write_text(text)
        path.chmod(0o755)
        return path

    return add


def test_packages_of_the_prefix_and_the_underlay_are_known(prefix):
    assert {"mine", "demo_nodes_py", "std_msgs"} <= set(packages())


def test_unknown_names_are_refused_with_the_known_ones(prefix):
    prefix("talker", "#!/usr/bin/env python3\n")
    with pytest.raises(PackageNotFound, match="Package 'min' not found; did you mean mine"):
        find("min", "talker")
    with pytest.raises(ExecutableNotFound, match="No executable 'talk' in package 'mine'. It has: talker"):
        find("mine", "talk")


@posix("every file may be run")
def test_files_that_may_not_be_run_are_no_executables(prefix):
    prefix("run_me", "#!/usr/bin/env python3\n")
    prefix("data", "text").chmod(0o644)
    assert [path.name for path in executables_of("mine")] == ["run_me"]


@posix("every file may be run")
def test_a_file_that_may_not_be_run_is_told_with_what_makes_it_an_executable(prefix):
    prefix("drive.py", "#!/usr/bin/env python3\n").chmod(0o644)
    with pytest.raises(ExecutableNotFound, match=r"'drive.py' may not be run: `chmod \+x` its source, or install\(PROGRAMS"):
        find("mine", "drive.py")


@pytest.mark.parametrize("folder", ["bin", "Scripts"])
def test_a_program_of_a_package_without_setup_cfg_is_told_where_it_went(prefix, tmp_path, folder):
    (tmp_path / folder).mkdir()
    (tmp_path / folder / "drive").touch()
    with pytest.raises(ExecutableNotFound, match=r"installed into bin: setup.cfg needs .* install_scripts=\$base/lib/mine"):
        find("mine", "drive")


def test_a_python_program_runs_inside_with_its_own_main_module(prefix, session):
    prefix("prog", "#!/usr/bin/env python3\nimport sys\nif __name__ == '__main__':\n    print(sys.argv[1:], __file__)\n")
    process = session.start_executable(find("mine", "prog"), ["--x"])
    assert process.wait(10) == 0
    assert process.output == f"['--x'] {find('mine', 'prog')}\n"


def test_two_runs_share_no_globals_and_an_edited_module_is_read_anew(prefix, session, tmp_path, monkeypatch):
    site = tmp_path / "site"
    (site / "counting").mkdir(parents=True)
    (site / "counting" / "__init__.py").write_text("count = 0\n")
    monkeypatch.setenv("PYTHONPATH", str(site))
    path = prefix("count", "#!/usr/bin/env python3\nimport counting\ncounting.count += 1\nprint(counting.count)\n")

    def run():
        process = session.start_executable(path)
        process.wait(10)
        return process.output

    assert [run(), run()] == ["1\n", "1\n"]
    (site / "counting" / "__init__.py").write_text("count = 41\nedited = True\n")
    assert run() == "42\n"
    assert "counting" not in sys.modules


def test_a_missing_file_is_said_to_be_missing(session, tmp_path):
    with pytest.raises(FileNotFoundError, match="Was its package built"):
        session.start_executable(tmp_path / "nothing")


def test_the_working_folder_of_a_program_is_its_own(prefix, tmp_path):
    if sys.platform != "linux":
        pytest.skip("threads share their folder on this system")
    before = os.getcwd()
    path = prefix("where", "#!/usr/bin/env python3\nimport os\nprint(os.getcwd())\n")
    with Session().use() as session:
        process = session.start_executable(path, cwd=tmp_path)
        process.wait(10)
    assert process.output == f"{tmp_path}\n" and os.getcwd() == before


def test_a_package_without_executables_says_what_makes_one():
    text = str(ExecutableNotFound("cpp_talker", "talker", []))
    assert "console_scripts" in text and "install(TARGETS" in text


@pytest.fixture
def as_on_windows(prefix, monkeypatch):
    """A package as setuptools installs it there: NAME.exe, a program for Windows, starts NAME-script.py beside it."""
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    text = "#!C:\\venv\\python.exe\nimport sys, beside\nprint(beside.NAME, sys.argv[1:])\n"
    prefix("talker-script.py", text)
    prefix("talker.exe", "MZ: no program for Linux")
    return prefix


def test_an_exe_of_setuptools_runs_inside_by_its_script(as_on_windows, session, tmp_path):
    """Not as a child of the system: it would be in no graph, and not on the virtual clock."""
    (tmp_path / "Lib" / "site-packages").mkdir(parents=True)
    (tmp_path / "Lib" / "site-packages" / "beside.py").write_text("NAME = 'mine'\n")
    process = session.start_executable(find("mine", "talker"), ["--x"])
    assert process.wait(10) == 0, process.output
    assert process.output == "mine ['--x']\n"
    assert not isinstance(process, ChildProcess)


def test_a_script_is_no_second_executable_and_an_exe_goes_by_both_of_its_names(as_on_windows):
    assert [path.name for path in executables_of("mine")] == ["talker.exe"]
    assert find("mine", "talker") == find("mine", "talker.exe")


def test_an_exe_without_a_script_is_a_program_of_the_system(as_on_windows):
    assert not is_python(as_on_windows("native.exe", "MZ"))
    assert is_python(find("mine", "talker"))
