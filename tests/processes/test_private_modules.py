"""Processes that start at the same time do not hide each other's packages."""

import os
import subprocess
import sys

import pytest

from coursekit.processes import private_modules
from coursekit.processes.process import current_process
from coursekit.processes.session import Session


@pytest.fixture
def path(monkeypatch):
    monkeypatch.setattr(sys, "path", ["/old/a", "/old/b", "/old/c"])
    return sys.path


def started_with(*folders):
    """What sys.path is once a process has these folders for itself."""

    def main():
        private_modules.use_private_modules(current_process(), list(folders))

    with Session(virtual=True).use() as session:
        process = session.start(main, name="starts")
        assert process.wait(1.0) == 0, process.output
        return sys.path


def test_a_process_that_looks_for_its_package_misses_none_while_another_starts(path):
    looking = iter(path)
    seen = [next(looking)]
    started_with("/old/b", "/new")
    seen += looking
    assert seen == ["/old/a", "/old/b", "/old/c"]


def test_the_folders_of_the_newest_process_come_first_and_once(path):
    assert started_with("/old/b", "/new") == ["/old/b", "/new", "/old/a", "/old/c"]


def test_after_the_last_session_the_path_is_as_it_was_found():
    """In an interpreter of its own: here a session of another test may still be open, and want its folders."""
    code = (
        "import sys; from tests.processes.test_private_modules import started_with\n"
        "path, before = sys.path, list(sys.path)\n"
        "assert started_with(before[-1], '/new')[:2] == [before[-1], '/new']\n"
        "assert sys.path is path and path == before"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_a_launch_folder_beside_a_package_hides_no_launch(tmp_path):
    for folder in ("launch", "vera", "plain"):
        (tmp_path / folder).mkdir()
    (tmp_path / "vera" / "__init__.py").touch()
    (tmp_path / "launch" / "all.launch.py").touch()
    assert list(private_modules.top_level_names(tmp_path)) == ["plain", "vera"]
    (tmp_path / "launch" / "__init__.py").touch()
    assert list(private_modules.top_level_names(tmp_path)) == ["launch", "plain", "vera"]


def test_folders_that_are_no_packages_hide_nothing_and_coursekit_stays_itself(tmp_path):
    for name in ("numpy", "json", "zipimport", "coursekit", "helpers"):
        (tmp_path / name).mkdir()
    (tmp_path / "coursekit" / "__init__.py").touch()
    assert list(private_modules.top_level_names(tmp_path)) == ["helpers"]


def test_a_program_imports_its_package_while_another_imports_something_else(tmp_path, monkeypatch):
    class Late(str):
        """A module's name; while it is looked at, another thread's import ends."""

        def partition(self, separator):
            sys.modules[f"{self}_as_well"] = sys
            return super().partition(separator)

    (tmp_path / "vera.py").write_text("kind = 'own'\n")
    monkeypatch.setitem(sys.modules, Late("late"), sys)
    monkeypatch.setitem(sys.modules, "late_as_well", sys)
    del sys.modules["late_as_well"]
    private = private_modules.PrivateModules([str(tmp_path)])
    monkeypatch.syspath_prepend(str(tmp_path))
    with private.in_place():
        import vera
    assert vera.kind == "own" and "vera" not in sys.modules


def test_a_module_that_is_changed_twice_within_a_second_is_read_both_times(tmp_path, monkeypatch):
    """Python knows its bytecode by the second in which the source was changed, and by the source's size."""
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    speeds = []

    def main():
        private_modules.use_private_modules(current_process(), [str(tmp_path)])
        from speeds import SPEED

        speeds.append(SPEED)

    with Session(virtual=True).use() as session:
        for speed in (0.5, 0.6):
            module = tmp_path / "speeds.py"
            module.write_text(f"SPEED = {speed}\n")
            os.utime(module, (1_700_000_000, 1_700_000_000))
            process = session.start(main, name="drives")
            assert process.wait(1.0) == 0, process.output
    assert speeds == [0.5, 0.6]
