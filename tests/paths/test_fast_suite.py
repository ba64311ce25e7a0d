"""The fast tests of the rooms that read and write files, with all their files in a folder that is named to do harm."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.needs import posix
from tests.paths.workspace import HOSTILE

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("interfaces", "urdf", "bag", "launch", "lab", "nav")
"""The others have a socket in their folder, whose path has room for 107 bytes, or C++: test_cpp.py."""


@posix("a name cannot hold quotes and backslashes there")
@pytest.mark.slow
@pytest.mark.timeout(900)
def test_tests_pass_in_a_folder_whose_name_holds_quotes_and_commands(tmp_path):
    folder = tmp_path / HOSTILE
    rooms = [f"tests/{room}" for room in ROOMS]
    command = [sys.executable, "-m", "pytest", "-m", "not slow", "-p", "no:cacheprovider", "--basetemp", str(folder), *rooms]
    env = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    done = subprocess.run(command, cwd=ROOT, env=env, capture_output=True, encoding="utf-8", errors="replace", check=False)
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr
    assert not [*tmp_path.rglob("PWNED*"), *ROOT.glob("PWNED*")]
