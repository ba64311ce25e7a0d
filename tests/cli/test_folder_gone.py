"""A folder that is removed under a session, or under a terminal, ends no command."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from coursekit.processes.session import Session
from coursekit.systems.folder import working_folder
from tests.needs import ON_WINDOWS

pytestmark = pytest.mark.skipif(ON_WINDOWS, reason="Windows keeps a folder that a program is in")
BIN = Path(sys.executable).parent


@pytest.fixture
def gone(tmp_path, monkeypatch):
    """A working folder that is not there any more."""
    folder = tmp_path / "my_package"
    folder.mkdir()
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PWD", str(folder))
    folder.rmdir()
    return folder


def test_its_name_is_kept_under_which_it_may_be_made_again(gone, monkeypatch):
    assert working_folder() == str(gone)
    monkeypatch.setenv("PWD", "nowhere")
    assert working_folder() == "/"


@pytest.mark.parametrize("cwd", [None, "/"])
def test_a_session_starts_programs_all_the_same(gone, cwd):
    with Session(virtual=True).use() as session:
        process = session.start(lambda: print("hello"), name="x", cwd=cwd)
        process.wait()
        assert process.output == "hello\n" and process.exit_code == 0


def test_commands_from_elsewhere_and_from_the_folder_itself_reach_the_session(tmp_path):
    folder, again = tmp_path / "my_package", tmp_path / "made_again"
    folder.mkdir()
    env = {**os.environ, "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}", "COURSEKIT_RUNTIME_DIR": str(tmp_path / "run"),
           "PYTHONUNBUFFERED": "1"}  # fmt: skip
    talker = subprocess.Popen(["ros2", "run", "demo_nodes_py", "talker"], cwd=folder, env=env, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, encoding="utf-8")  # fmt: skip
    try:
        assert "Publishing" in talker.stderr.readline()
        shutil.rmtree(folder)
        ask = {"env": env, "capture_output": True, "encoding": "utf-8"}
        assert subprocess.run(["ros2", "node", "list"], cwd=tmp_path, **ask).stdout == "/talker\n"
        remove = f"mkdir {again} && cd {again} && rmdir {again} && ros2 node list"
        done = subprocess.run(["bash", "-c", remove], **ask)
        assert done.stdout == "/talker\n", done.stderr
    finally:
        talker.send_signal(2)
        talker.communicate(timeout=60)
