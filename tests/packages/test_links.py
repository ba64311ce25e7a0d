"""`colcon build --symlink-install` where links are refused: what is built is a copy, and that is said."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from coursekit.packages.colcon_links import COPIES
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


def test_it_builds_copies_and_says_in_one_line_when_to_build_again(build):
    said = build("--symlink-install", refuse=True)
    assert said.splitlines().count(COPIES) == 1
    assert "1 package finished" in said
    assert links_under(build.folder / "install") + links_under(build.folder / "build") == []
    assert list((build.folder / "install").rglob(f"site-packages/{build.package}/__init__.py"))


def test_where_links_can_be_made_nothing_is_said(build):
    if not can_link(build.folder):
        pytest.skip("this account may not make links")
    assert COPIES not in build("--symlink-install", refuse=False)
    assert links_under(build.folder / "build")


def test_who_did_not_ask_for_links_is_told_nothing(build):
    assert COPIES not in build(refuse=True)
