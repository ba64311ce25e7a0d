"""A virtual session, and launch tests that are written to files and run as a user runs them."""

from __future__ import annotations

import contextlib
import io
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any
from xml.etree import ElementTree

import pytest
from launch.logging import reset
from launch_testing.launch_test import parse_arguments, run
from launch_testing.loader import LoadTestsFromPythonModule
from launch_testing.test_runner import LaunchTestRunner

from coursekit.processes.session import Session

HEAD = """
import sys, time, unittest
import pytest
import launch_testing, launch_testing.actions, launch_testing.asserts, launch_testing.markers, launch_testing.util
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, TimerAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_testing.actions import ReadyToTest

def talker(**more):
    return Node(package="demo_nodes_py", executable="talker", name="t", **more)
"""


@pytest.fixture(autouse=True)
def session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Session]:
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    with Session(virtual=True).use() as virtual_session:
        reset()
        yield virtual_session


@dataclass
class Outcome:
    """What `launch_test` returned, printed and reported."""

    code: int | None
    text: str
    report: ElementTree.Element | None

    @property
    def cases(self) -> dict[str, list[str]]:
        """Each test and what became of it; an empty list is a success."""
        assert self.report is not None
        return {case.attrib["name"]: [element.tag for element in case] for case in self.report.iter("testcase")}


@pytest.fixture
def launch_test(tmp_path: Path) -> Callable[..., Outcome]:
    """Return a function that writes a launch test and has the command run it, on the virtual clock."""

    def carry_out(text: str, *argv: str) -> Outcome:
        path, xml = tmp_path / "some_launch_test.py", tmp_path / "report.xml"
        path.write_text(HEAD + text)
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            code = run(*parse_arguments([str(path), *argv, "--junit-xml", str(xml)]))
        return Outcome(code, out.getvalue(), ElementTree.parse(xml).getroot() if xml.exists() else None)

    return carry_out


@pytest.fixture
def results() -> Callable[..., dict[str, Any]]:
    """Return a function that runs tests given as a description and classes; the results by the names of the runs."""

    def carry_out(describe: Callable[..., Any], *classes: type, arguments: tuple[str, ...] = ()) -> dict[str, Any]:
        module = ModuleType("module")
        module.generate_test_description = describe  # type: ignore[attr-defined]
        for class_ in classes:
            setattr(module, class_.__name__, class_)
        runner = LaunchTestRunner(LoadTestsFromPythonModule(module), arguments)
        runner.validate()
        with contextlib.redirect_stderr(io.StringIO()), contextlib.redirect_stdout(io.StringIO()):
            return {str(run): result for run, result in runner.run().items()}

    return carry_out


@pytest.fixture
def run_pytest(tmp_path: Path) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Return a function that writes test files and runs pytest on them, in an interpreter with a virtual session."""

    def carry_out(files: dict[str, str], *argv: str, clock: str = "virtual") -> subprocess.CompletedProcess[str]:
        for name, text in files.items():
            (tmp_path / name).write_text(HEAD + text)
        command = [sys.executable, "-m", "pytest", "-v", "-p", "no:cacheprovider", *argv]
        env = {**os.environ, "COURSEKIT_TIME": clock}
        return subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, encoding="utf-8", check=False)

    return carry_out
