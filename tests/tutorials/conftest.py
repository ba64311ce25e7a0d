"""A workspace of packages in the tutorials' shapes, built once, and terminals in which it is sourced."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from coursekit.interfaces import find
from coursekit.packages.overlay import overlay_environment
from coursekit.processes.session import Session
from coursekit.systems.command_lines import split_words

SOURCE = Path(__file__).parents[1] / "fixtures" / "tutorial_ws" / "src"
BIN = Path(sys.executable).parent
Terminal = Callable[..., Any]


def colcon(root: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Run colcon in a folder, in an environment that nobody prepared."""
    env = {key: value for key, value in os.environ.items() if not key.startswith(("AMENT_", "COLCON_", "ROS_DISTRO"))}
    env["PATH"] = f"{BIN}{os.pathsep}{env['PATH']}"
    return subprocess.run([BIN / "colcon", *words], cwd=root, env=env, capture_output=True, encoding="utf-8", timeout=240)


@pytest.fixture(scope="session")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The workspace, built as the pages build theirs."""
    root = tmp_path_factory.mktemp("tutorials") / "ros2_ws"
    shutil.copytree(SOURCE, root / "src")
    built = colcon(root, "build")
    assert built.returncode == 0, built.stdout + built.stderr
    return root


@pytest.fixture
def session(workspace: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Session]:
    """A session on the virtual clock with the workspace sourced, in a folder of its own."""
    for name, value in overlay_environment(workspace / "install", os.environ).items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(find, "_remembered", [])  # a package that is imported has its workspace searched, from then on
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    monkeypatch.setenv("PATH", f"{BIN}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.setenv("PAINTER", "mario")
    monkeypatch.chdir(tmp_path)
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session


@pytest.fixture
def terminal(session: Session) -> Terminal:
    """terminal("ros2 run ...") starts a command as a page prints it, and returns the process."""
    from coursekit.cli.parser import run

    def start(line: str, seconds: float = 0.0) -> Any:
        command, *words = split_words(line)
        assert command == "ros2", line
        process = session.start(lambda: run(words), name="ros2", argv=words)
        session.clock.sleep(seconds)
        return process

    return start


@pytest.fixture
def said(terminal: Terminal) -> Callable[..., str]:
    """said("ros2 node list") is what a command says; Ctrl-C ends it after so many seconds."""

    def carry_out(line: str, seconds: float = 5.0) -> str:
        process = terminal(line)
        if process.wait(seconds) is None:
            process.interrupt()
            process.wait(5.0)
        return str(process.output)

    return carry_out
