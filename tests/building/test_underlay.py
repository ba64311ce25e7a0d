"""Files of the underlay that are made: what is installed is what the definitions and the table of executables say."""

import importlib
import os
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from coursekit.building.executables import EXECUTABLES
from coursekit.building.underlay import files, write
from coursekit.interfaces.find import UNDERLAY
from tests.needs import posix

FILES = files()
ROOT = Path(__file__).parents[2]


def test_what_is_installed_is_what_is_made():
    """When this fails: python3 start.py setup"""
    different = [name for name, text in FILES.items() if (UNDERLAY / name).read_text(encoding="utf-8") != text]
    assert different == []


def test_stubs_are_in_the_same_order_on_every_system():
    stub = FILES["ros/controller_manager_msgs/srv/__init__.pyi"]
    assert stub.index("class ListControllerTypes_Request") < stub.index("class ListControllers_Request"), "with their case"


@pytest.mark.parametrize("name", [name for name in FILES if name.startswith("ros/")])
def test_modules_and_stubs_are_python(name):
    compile(FILES[name], name, "exec")


@pytest.mark.parametrize(("package", "programs"), EXECUTABLES.items())
def test_every_executable_s_function_is_there(package, programs):
    for place in programs.values():
        module, _, function = place.partition(":")
        assert callable(getattr(importlib.import_module(module), function)), place


def test_it_is_written_whole_and_only_where_it_differs(tmp_path):
    paths = write(tmp_path)
    talker = tmp_path / "lib" / "demo_nodes_py" / "talker"
    assert talker in paths and len(paths) == len(FILES)
    assert os.name == "nt" or stat.S_IMODE(talker.stat().st_mode) == 0o755
    talker.write_text("changed", encoding="utf-8")
    before = (tmp_path / "ros" / "std_msgs" / "msg" / "__init__.pyi").stat().st_mtime_ns
    write(tmp_path)
    assert talker.read_text(encoding="utf-8") == FILES["lib/demo_nodes_py/talker"]
    assert (tmp_path / "ros" / "std_msgs" / "msg" / "__init__.pyi").stat().st_mtime_ns == before


@posix("a file says there by its ending what runs it")
def test_a_program_is_started_by_its_path_too(monkeypatch):
    """As `subprocess.run([get_package_prefix(...) + "/lib/...", ...])` in launch files, and scripts in bash, start it."""
    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=os.pathsep)
    program = UNDERLAY / "lib" / "tf2_ros" / "tf2_echo"
    done = subprocess.run([program], capture_output=True, text=True)
    assert "Usage: tf2_echo" in done.stdout + done.stderr


@pytest.mark.skipif(shutil.which("git") is None or not (ROOT / ".git").exists(), reason="asks git about its own checkout")
def test_what_is_ignored_is_made_and_what_is_kept_is_not_ignored():
    """A file that git keeps but ignores would be missing in wheels."""
    assert git("ls-files", "--cached", "--ignored", "--exclude-standard", "coursekit") == []
    kept = set(git("ls-files", "coursekit"))
    assert [name for name in FILES if f"coursekit/{name}" in kept] == []


def git(*words):
    done = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, encoding="utf-8", check=True)
    return done.stdout.splitlines()
