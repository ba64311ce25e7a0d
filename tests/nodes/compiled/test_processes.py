"""Compiled programs as processes: how they end, what is typed to them, debuggers, many of them."""

from __future__ import annotations

import gc
import os
import shutil
import threading

import psutil
import pytest

from coursekit.processes.executables import has_compiled_here, make_process
from coursekit.processes.session import Session
from tests.nodes.compiled.conftest import program

STARTS = int(os.environ.get("COURSEKIT_STARTS", "20"))
"""Starts on each clock; 500 are a thousand in all."""


@pytest.fixture
def launch(build):
    path_by_name = {}

    def started(session, name, *words, env=None):
        if name not in path_by_name:
            path_by_name[name] = build(name, program(f"{name}.cpp"))
        env = {**os.environ, **(env or {})}
        return session.launch(make_process(session, path_by_name[name], words, name=name, env=env))

    return started


@pytest.mark.parametrize("virtual", [True, False])
def test_however_a_program_ends_the_session_lives_and_its_node_is_gone(launch, virtual):
    ends = {"segfault": -11, "abort": -6, "throw": -6, "exit": 3, "kill": -9, "detached": 0}
    with (session := Session(virtual=virtual)).use():
        processes = {how: launch(session, "faults", how) for how in ends}
        assert {how: process.wait(20.0) for how, process in processes.items()} == ends
        assert "nobody catches this" in processes["throw"].output
        assert processes["detached"].output == "begins\nends\n"
        assert session.graph(0).nodes == []


def test_a_program_that_computes_for_ever_is_ended_and_told(launch):
    with (session := Session(virtual=True)).use():
        process = launch(session, "faults", "compute", env={"COURSEKIT_COMPUTE_LIMIT": "0.5"})
        assert process.wait(5.0) == -9
        assert "[coursekit] faults has computed for 0.5 s without asking rclcpp for anything" in process.output
        session.clock.sleep(1.0)  # time goes on


def test_a_program_that_computes_is_killed_on_the_wall_clock(launch):
    with (session := Session(virtual=False)).use():
        process = launch(session, "faults", "compute")
        session.clock.sleep(1.5)
        process.interrupt()
        session.clock.sleep(0.1)
        assert process.wait(0.1) is None  # rclcpp's handler only says that it is to stop, as on a robot
        process.kill()
        assert process.wait(5.0) == -9


@pytest.mark.parametrize("virtual", [True, False])
def test_what_is_typed_reaches_it_and_futures_wait_for_other_threads(launch, virtual):
    with (session := Session(virtual=virtual)).use():
        process = launch(session, "typed")
        for text in ("5 five and more\nwhole line\n", "word\n", "k", "a b\n", "c\n"):
            process.write_stdin(text)
        process.close_stdin()
        assert process.wait(20.0) == 0
        assert process.output.splitlines() == ["142", "7", "5fivewhole line", "1word", "1k", "a,b,c,end"]


@pytest.mark.parametrize("virtual", [True, False])
def test_ctrl_c_ends_a_program_that_waits_for_what_is_typed(launch, virtual):
    with (session := Session(virtual=virtual)).use():
        process = launch(session, "typed")
        while "7\n" not in process.output:
            session.clock.sleep(0.2)
        process.interrupt()
        assert process.wait(10.0) == 0
        assert process.output.splitlines()[-1].endswith("end")


def test_a_debugger_before_it_sees_the_crash(launch, session):
    if shutil.which("gdb") is None:
        pytest.skip("needs gdb")
    faults = launch(session, "faults", "exit").argv[1]
    command = [shutil.which("gdb"), "-batch", "-ex", "run", "-ex", "info program", "--args", faults, "segfault"]
    assert has_compiled_here(command)
    said = []
    from launch.process_starter import start_process

    debugger = start_process(
        command, cwd=None, env=dict(os.environ), shell=False, on_output=lambda _stream, text: said.append(text)
    )
    assert debugger.wait(60.0) == 0
    assert "begins" in "".join(said) and "SIGSEGV" in "".join(said)
    assert session.graph(0).nodes == []


def test_starts_and_ends_leave_no_thread_no_file_and_no_process(launch):
    def held():
        return threading.active_count(), psutil.Process().num_fds(), len(psutil.Process().children(recursive=True))

    for virtual in (True, False):
        with (session := Session(virtual=virtual)).use():
            assert launch(session, "faults", "exit").wait(20.0) == 3
            gc.collect()
            before = held()
            for number in range(STARTS):
                how, code = [("exit", 3), ("abort", -6), ("detached", 0), ("kill", -9)][number % 4]
                assert launch(session, "faults", how).wait(30.0) == code
            gc.collect()
            grown = [later - earlier for later, earlier in zip(held(), before, strict=True)]
            assert max(grown) <= 2, grown  # the last one's own connection may still be closing
