"""Sessions in which bags are recorded and played."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import rclpy

from coursekit.cli.parser import run
from coursekit.processes.session import Session
from tests.cli.bag.stage import Stage, write


@pytest.fixture
def session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Session]:
    """A session on the virtual clock, in a folder of its own."""
    monkeypatch.chdir(tmp_path)
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session


@pytest.fixture
def ros2(session: Session) -> Callable[[str], Any]:
    """ros2("bag record -a") starts a command."""
    return lambda line: session.start(lambda: run(shlex.split(line)), name="ros2")


@pytest.fixture
def node(session: Session) -> Iterator[Any]:
    """A node that publishes what a test wants."""
    context = rclpy.context.Context()
    rclpy.init(context=context)
    speaker = rclpy.create_node("speaker", context=context)
    yield speaker
    speaker.destroy_node()
    rclpy.try_shutdown(context=context)


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Stage]:
    """A folder with the bag `talk`: Hello 0 ... Hello 5, one a second."""
    monkeypatch.chdir(tmp_path)
    write("talk", 6)
    with Session(virtual=True).use() as session:
        yield Stage(session)
