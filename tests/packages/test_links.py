"""`colcon build --symlink-install` where links are refused: no build is needed after a change, as with links."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from coursekit.packages.build_state import build_fault
from coursekit.packages.overlay import overlay_environment
from coursekit.systems.links import can_link

SOURCES = Path(__file__).parent.parent / "fixtures" / "ros2_ws" / "src"
COLCON = [sys.executable, "-m", "colcon", "--log-base", "log", "build", "--executor", "sequential"]
REFUSE = """
import os

def _refuse(*_, **__):
    raise OSError(1314, "A required privilege is not held by the client")

os.symlink = _refuse
"""


@pytest.fixture
def build(tmp_path):
    """Build a package of the fixture workspace; with `refuse` no program may make links."""
    package = next(path.parent for path in sorted(SOURCES.glob("*/setup.py")))
    shutil.copytree(package, tmp_path / "src" / package.name)
    (tmp_path / "refusing").mkdir()
    (tmp_path / "refusing" / "usercustomize.py").write_text(REFUSE)

    def run(*words, refuse):
        env = {name: value for name, value in os.environ.items() if name not in ("AMENT_PREFIX_PATH", "PYTHONPATH")}
        command = list(COLCON)
        if refuse:
            env["PYTHONPATH"] = str(tmp_path / "refusing")
            command[1:3] = ["-c", "import sys, usercustomize; from colcon_core.command import main; sys.exit(main())"]
        done = subprocess.run([*command, *words], cwd=tmp_path, env=env, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    run.package = package.name
    run.folder = tmp_path
    return run


def links_under(folder):
    return [path for path in folder.rglob("*") if path.is_symlink()]


def sourced(build):
    """The environment after `source install/setup.bash`."""
    return overlay_environment(build.folder / "install", {**os.environ, "PYTHONPATH": ""})


def printed(build, program):
    """What a program of its own interpreter prints there."""
    command = [sys.executable, "-c", program]
    return subprocess.run(command, env=sourced(build), capture_output=True, text=True, check=True).stdout.strip()


def shared(build):
    """The text of a data file, as its package's folder is looked up."""
    return printed(
        build,
        "from ament_index_python import get_package_share_path as share; "
        f"print((share('{build.package}') / 'words.txt').read_text())",
    )


def change(file, text):
    """Write so that the file is newer than all others."""
    file.write_text(text)
    later = file.stat().st_mtime_ns + 10**9
    os.utime(file, ns=(later, later))


@pytest.fixture
def source(build):
    """The package's folder in src/, with a file that is installed."""
    folder = build.folder / "src" / build.package
    (folder / "words.txt").write_text("first")
    text = (folder / "setup.py").read_text()
    assert "['package.xml']" in text
    (folder / "setup.py").write_text(text.replace("['package.xml']", "['package.xml', 'words.txt']"))
    return folder


def test_without_links_a_changed_and_a_new_module_need_no_build(build, source):
    said = build("--symlink-install", refuse=True)
    assert "1 package finished" in said and "copie" not in said
    assert links_under(build.folder / "install") + links_under(build.folder / "build") == []
    change(source / build.package / "later.py", "from . import WORD")
    change(source / build.package / "__init__.py", "WORD = 'changed'")
    assert printed(build, f"from {build.package}.later import WORD; print(WORD)") == "changed"
    assert build_fault(build.folder, build.package) == ""


def test_without_links_a_changed_data_file_needs_no_build(build, source):
    build("--symlink-install", refuse=True)
    assert shared(build) == "first"
    change(source / "words.txt", "second")
    assert build_fault(build.folder, build.package) == ""
    assert shared(build) == "second"


def test_rules_of_the_build_and_files_that_it_does_not_know_yet_need_a_build(build, source):
    build("--symlink-install", refuse=True)
    change(source / "launch_me.py", "")
    assert "launch_me.py" in build_fault(build.folder, build.package)


@pytest.mark.parametrize("words", [(), ("--symlink-install",)])
def test_a_build_that_copies_or_links_forgets_what_stood_for_links(build, source, words):
    if words and not can_link(build.folder):
        pytest.skip("this account may not make links")
    build("--symlink-install", refuse=True)
    build(*words, refuse=False)
    change(source / "words.txt", "second")
    change(source / build.package / "__init__.py", "WORD = 'changed'")
    assert shared(build) == ("second" if words else "first")
    assert printed(build, f"import {build.package} as one; print(hasattr(one, 'WORD'))") == str(bool(words))


def test_where_links_can_be_made_there_are_links(build):
    if not can_link(build.folder):
        pytest.skip("this account may not make links")
    build("--symlink-install", refuse=False)
    assert links_under(build.folder / "build")


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("cmake") is None, reason="NOT TESTED: no CMake here")
def test_a_package_that_was_compiled_says_that_its_files_are_copies(build):
    shutil.copytree(SOURCES / "s2_cpp_pubsub", build.folder / "src" / "s2_cpp_pubsub")
    said = build("--symlink-install", "--packages-select", "s2_cpp_pubsub", refuse=True)
    assert "s2_cpp_pubsub is copied: build it again after every change of a file" in said.splitlines()
