"""Tests with the mark `launch`: functions, generators and coroutines, beside a launch and after it."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

HEAD = """
import asyncio, time
import pytest, launch_pytest
from launch import LaunchDescription
from launch.actions import ExecuteProcess, OpaqueFunction, TimerAction
from launch_pytest.actions import ReadyToTest
from launch_pytest.tools import process
from launch_ros.actions import Node

@pytest.fixture
def talker():
    return Node(package="demo_nodes_py", executable="talker", cached_output=True)

@launch_pytest.fixture
def launched(talker):
    return LaunchDescription([talker, ReadyToTest()])
"""


@pytest.fixture
def run(tmp_path: Path) -> Callable[..., str]:
    """Return a function that runs pytest on a file, in an interpreter with a virtual session; what it prints."""

    def carry_out(text: str, *argv: str, clock: str = "virtual") -> str:
        (tmp_path / "test_it.py").write_text(HEAD + text)
        command = [sys.executable, "-m", "pytest", "-v", "-p", "no:cacheprovider", *argv]
        env = {**os.environ, "COURSEKIT_TIME": clock, "ROS_LOG_DIR": str(tmp_path / "log")}
        return subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, encoding="utf-8", check=False).stdout

    return carry_out


def outcomes(text: str) -> dict[str, str]:
    """Each test and what became of it."""
    return dict(re.findall(r"^test_it\.py::(\S+) (PASSED|FAILED|SKIPPED|ERROR)", text, re.MULTILINE))


def test_each_kind_of_test_runs_beside_a_launch_and_after_it(run) -> None:
    text = run("""
hello = lambda text: "Hello World: 1" in text

@pytest.mark.launch(fixture=launched)
def test_function(talker, launch_context):
    assert process.wait_for_stderr_sync(launch_context, talker, hello, timeout=5)

@pytest.mark.launch(fixture=launched)
async def test_coroutine(talker, launch_context):
    assert await process.wait_for_stderr(launch_context, talker, hello, timeout=5)

@pytest.mark.launch(fixture=launched)
def test_generator(talker, launch_context):
    assert talker.return_code is None
    time.sleep(1.5)
    yield
    assert talker.return_code == 0 and "World: 0" in talker.get_stderr()

@pytest.mark.launch(fixture=launched)
async def test_async_generator(talker, launch_context, event_loop):
    assert asyncio.get_running_loop() is event_loop
    yield
    assert talker.return_code is not None

@pytest.mark.launch(fixture=launched, shutdown=True)
def test_after(talker):
    assert talker.return_code is not None

@pytest.mark.launch(fixture=launched, shutdown=True)
async def test_coroutine_after(talker):
    assert talker.return_code is not None
""")
    assert set(outcomes(text).values()) == {"PASSED"} and len(outcomes(text)) == 6, text


def test_what_fails_beside_a_launch_or_after_it_is_a_failure(run) -> None:
    text = run("""
@pytest.mark.launch(fixture=launched)
def test_function():
    assert 1 == 2

@pytest.mark.launch(fixture=launched)
async def test_coroutine():
    assert 1 == 3

@pytest.mark.launch(fixture=launched)
def test_generator():
    yield
    assert 1 == 4

@pytest.mark.launch(fixture=launched)
def test_twice():
    yield
    yield

@pytest.mark.launch(fixture=launched)
def test_never():
    return
    yield

@pytest.mark.launch(fixture=launched, shutdown=True)
def test_both():
    yield
""")
    assert set(outcomes(text).values()) == {"FAILED"} and len(outcomes(text)) == 6, text
    for reason in (
        *("assert 1 == 2", "assert 1 == 3", "assert 1 == 4"),
        "launch tests using a generator function must stop iteration after yielding once",
        "the test has ended before its yield",
        "generator or async generator based launch test items cannot be marked with shutdown=True",
    ):
        assert reason in text


MODULE = """
order = []

@launch_pytest.fixture(scope="module", params=["a", "b"])
def shared(request):
    order.append(request.param)
    return LaunchDescription([ExecuteProcess(cmd=["sleep", "100"])]), request.param

@pytest.mark.launch(fixture=shared, shutdown=True)
def test_after(shared):
    assert order[-3:] == [shared[1], "generator", "function"]

@pytest.mark.launch(fixture=shared)
def test_generator(shared):
    order.append("generator")
    yield
    order.append("after generator")

@pytest.mark.launch(fixture=shared)
def test_function(shared, launch_service):
    assert launch_service.task is not None
    order.append("function")
"""


def test_a_launch_of_a_module_is_shared_and_tests_after_it_come_last(run) -> None:
    text = run(MODULE)
    ran = [name.replace("[shutdown_test]", " after") for name in outcomes(text)]
    assert set(outcomes(text).values()) == {"PASSED"}, text
    assert [name for name in ran if "[a]" in name] == [
        "test_generator[a]",
        "test_function[a]",
        "test_after[a]",
        "test_generator after[a]",
    ]


def test_a_second_half_is_left_out_when_the_first_failed(run) -> None:
    text = run("""
@launch_pytest.fixture(scope="module")
def shared():
    return LaunchDescription([ExecuteProcess(cmd=["sleep", "100"])])

@pytest.mark.launch(fixture=shared)
async def test_generator():
    assert False
    yield
""")
    assert outcomes(text) == {"test_generator": "FAILED", "test_generator[shutdown_test]": "SKIPPED"}, text


@pytest.mark.parametrize(
    ("fixture", "reason"),
    [
        ("None", "return value must be either a launch description"),
        ("[]", "return value must be either a launch description"),
        ("LaunchDescription([ReadyToTest(), ReadyToTest()])", "containing only one ReadyToTest action"),
        (
            "LaunchDescription([OpaqueFunction(function=lambda context: 1 / 0), ReadyToTest()])",
            "the launch ended before the ReadyToTest action was carried out",
        ),
    ],
)
def test_a_fixture_that_launches_nothing_is_an_error(run, fixture: str, reason: str) -> None:
    text = run(f"""
@launch_pytest.fixture
def wrong():
    return {fixture}

@pytest.mark.launch(fixture=wrong)
def test_it():
    pass
""")
    assert outcomes(text) == {"test_it": "ERROR"} and reason in text, text


def test_a_launch_ends_by_itself_where_that_is_asked_for(run) -> None:
    text = run("""
@launch_pytest.fixture(auto_shutdown=False)
def short():
    return LaunchDescription([TimerAction(period=3.0, actions=[])])

@launch_pytest.fixture(shutdown_when_idle=False)
def idle():
    return LaunchDescription([])

@pytest.mark.launch(fixture=short)
async def test_short(event_loop):
    global before
    before = event_loop.time()
    yield
    assert event_loop.time() - before == pytest.approx(3.0)

@pytest.mark.launch(fixture=idle)
async def test_idle(launch_service):
    await asyncio.sleep(100.0)
    assert launch_service.event_loop is not None
""")
    assert outcomes(text) == {"test_short": "PASSED", "test_idle": "PASSED"}, text


def test_the_mark_needs_a_fixture(run) -> None:
    text = run("@pytest.mark.launch()\ndef test_it():\n    assert False\n")
    assert outcomes(text) == {"test_it": "SKIPPED"}
    assert 'LaunchTestWarning: "fixture" keyword argument is required in a pytest.mark.launch() decorator' in text


def test_waiting_in_vain_takes_as_long_as_was_asked_for(run) -> None:
    text = run("""
@pytest.mark.launch(fixture=launched)
async def test_coroutine(talker, launch_context, event_loop):
    before = event_loop.time()
    assert not await process.wait_for_exit(launch_context, talker, timeout=2)
    assert await process.wait_for_output(launch_context, talker, lambda text: "no" in text, timeout=2) is False
    with pytest.raises(AssertionError, match="never"):
        def never(text):
            assert False, "never"
        await process.assert_stderr(launch_context, talker, never, timeout=2)
    assert event_loop.time() - before == pytest.approx(6.0)

@pytest.mark.launch(fixture=launched)
def test_function(talker, launch_context, event_loop):
    assert process.wait_for_start_sync(launch_context, talker, timeout=2)
    with pytest.raises(AssertionError, match="never"):
        def never(text):
            assert False, "never"
        process.assert_output_sync(launch_context, talker, never, timeout=1)

class TestOfClass:
    @launch_pytest.fixture(scope="class")
    def in_class(self):
        return LaunchDescription([ExecuteProcess(cmd=["sleep", "100"])])

    @pytest.mark.launch(fixture=in_class)
    def test_method(self, launch_service):
        self.kept = 1
        yield
        assert self.kept == 1
""")
    assert set(outcomes(text).values()) == {"PASSED"} and len(outcomes(text)) == 4, text


def test_runs_without_launch_tests_do_not_import_launch(run, tmp_path: Path) -> None:
    plain = tmp_path / "test_plain.py"
    plain.write_text("import sys\ndef test_imports():\n    assert not {'launch', 'coursekit.core'} & set(sys.modules)\n")
    assert "test_plain.py::test_imports PASSED" in run("", "test_plain.py")


@pytest.mark.slow
def test_programs_that_a_test_starts_outside_of_the_session_join_it(run) -> None:
    text = """
@pytest.mark.launch(fixture=launched)
def test_join(talker, launch_context):
    import os, subprocess, sys
    assert process.wait_for_stderr_sync(launch_context, talker, lambda text: "World: 0" in text, timeout=10)
    command = [os.path.dirname(sys.executable) + "/ros2", "node", "list"]
    assert subprocess.run(command, capture_output=True, encoding="utf-8").stdout == "/talker\\n"
"""
    assert outcomes(run(text, clock="")) == {"test_join": "PASSED"}
