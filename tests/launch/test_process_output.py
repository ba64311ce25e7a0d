"""What processes write: where it goes, in which form, and who hears of it."""

from __future__ import annotations

import sys

import pytest
from launch.actions import ExecuteProcess, LogInfo, OpaqueFunction, RegisterEventHandler, TimerAction
from launch.event_handler import EventHandler
from launch.event_handlers import OnProcessIO
from launch.events.process import ProcessStdout


@pytest.mark.parametrize(
    ("output", "shown"),
    [
        ("log", ["err"]),
        ("screen", ["out", "err"]),
        ("both", ["out", "err"]),
        ("own_log", []),
        ({"stdout": "screen", "stderr": "log"}, ["out"]),
    ],
)
def test_output_goes_where_it_is_sent(launch, output, shown: list[str]) -> None:
    code = "import sys; print('out', flush=True); print('err', file=sys.stderr)"
    result = launch([ExecuteProcess(cmd=[sys.executable, "-c", code], name="python", output=output)])
    lines = [line for line in result.lines if line.startswith("[python-1]")]
    assert sorted(lines) == sorted(f"[python-1] {word}" for word in shown)


def test_own_logs_are_files_in_the_log_folder(launch, tmp_path) -> None:
    launch([ExecuteProcess(cmd=["echo", "hi"], output="own_log")])
    (folder,) = (tmp_path / "log").iterdir()
    assert sorted(path.name for path in folder.iterdir()) == ["echo-1-stdout.log", "echo-1.log", "launch.log"]
    assert "[echo-1] hi" in (folder / "echo-1.log").read_text()
    assert "process started with pid" in (folder / "launch.log").read_text()


def test_lines_have_the_session_s_time_to_the_millisecond(launch, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OVERRIDE_LAUNCH_SCREEN_FORMAT", "{asctime} {message}")
    echo = ExecuteProcess(cmd=["echo", "hi"], output="screen", output_format="{line}")
    result = launch([TimerAction(period=1.25, actions=[LogInfo(msg="late"), echo])])
    (late,) = [line for line in result.lines if line.endswith("late")]
    assert ",250 " in late


def test_an_unknown_output_is_an_error(launch) -> None:
    result = launch([ExecuteProcess(cmd=["true"], output="scren")])
    assert result.code == 1
    assert "'scren' is not a valid standard output config, expected one of ['screen', 'log'" in result.text


def test_a_last_line_without_end_is_shown_too(launch) -> None:
    result = launch([ExecuteProcess(cmd=[sys.executable, "-c", r"print('a\nb', end='')"], name="printf", output="screen")])
    assert [line for line in result.lines if line.startswith("[printf-1] ")] == [
        "[printf-1] a",
        "[printf-1] b",
    ]


@pytest.mark.parametrize(
    ("form", "shown"),
    [("<{line}>", "<a>"), ("{{line}} {line}", "{line} a"), ("{{line}}", "{line}"), ("{line!r}", "'a'"), ("- {line}", "- a")],
)
def test_the_output_format_may_be_changed(launch, form: str, shown: str) -> None:
    result = launch([ExecuteProcess(cmd=["echo", "a"], output="screen", output_format=form)])
    assert shown in result.lines


def test_output_can_be_asked_for_afterwards(launch) -> None:
    process = ExecuteProcess(cmd=["echo", "kept"], cached_output=True)
    launch([process])
    assert (process.get_stdout(), process.get_stderr(), process.return_code) == ("kept\n", "", 0)
    with pytest.raises(RuntimeError, match="cached output must be true"):
        ExecuteProcess(cmd=["true"]).get_stdout()


def test_the_output_of_all_processes_can_be_shown(launch, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OVERRIDE_LAUNCH_PROCESS_OUTPUT", "both")
    result = launch([ExecuteProcess(cmd=["echo", "shown"], output="log")])
    assert "[echo-1] shown" in result.lines


TALK = """
import os, sys, time
for number in range(6):
    while number == 3 and sys.argv[1:] and not os.path.exists(sys.argv[1]):
        time.sleep(0.01)
    print('line', number, flush=True)
"""
"""Six lines; with a path as its argument it waits in the middle until there is such a file."""


@pytest.fixture
def talk(tmp_path) -> ExecuteProcess:
    path = tmp_path / "talk.py"
    path.write_text(TALK)
    return ExecuteProcess(cmd=[sys.executable, str(path)], output="screen")


def logged(result) -> list[str]:
    return [line.partition("] ")[2] for line in result.lines if "-1] line" in line]


EVERY = [f"line {number}" for number in range(6)]


def test_nobody_needs_to_listen(launch, talk) -> None:
    assert logged(launch([talk])) == EVERY


@pytest.mark.parametrize("kind", ["of the process", "of any event"])
def test_who_begins_to_listen_hears_the_rest_and_the_log_stays_whole(launch, talk, tmp_path, kind) -> None:
    go = tmp_path / "go"
    talk = ExecuteProcess(cmd=[*(word[0].text for word in talk.cmd), str(go)], output="screen", cached_output=True)
    heard: list[str] = []

    def hear(event, _context=None) -> None:
        heard.append(event.text.decode().strip())

    handler = OnProcessIO(target_action=talk, on_stdout=hear)
    if kind == "of any event":
        handler = EventHandler(matcher=lambda event: isinstance(event, ProcessStdout), entities=hear)

    def listen(_context) -> list:
        if "line 2" not in talk.get_stdout():
            return [TimerAction(period=0.05, actions=[OpaqueFunction(function=listen)])]
        return [RegisterEventHandler(handler), OpaqueFunction(function=lambda _context: go.touch())]

    assert logged(launch([talk, TimerAction(period=0.05, actions=[OpaqueFunction(function=listen)])])) == EVERY
    assert "\n".join(heard).splitlines() == EVERY[3:]  # a read may bring several lines


def test_with_debug_each_event_is_told(launch, talk) -> None:
    result = launch([talk], debug=True)
    assert "processing event: '<launch.events.process.process_io.ProcessStdout" in result.text
    assert logged(result) == EVERY
