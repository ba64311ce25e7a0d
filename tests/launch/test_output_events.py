"""Output is an event for whoever wants it, and in the log in any case."""

from __future__ import annotations

import pytest
from launch.actions import ExecuteProcess, RegisterEventHandler, TimerAction
from launch.event_handler import EventHandler
from launch.event_handlers import OnProcessIO
from launch.events.process import ProcessStdout

TALK = "import time\nfor number in range(6):\n    print('line', number, flush=True)\n    time.sleep(0.5)\n"


@pytest.fixture
def talk(tmp_path) -> ExecuteProcess:
    path = tmp_path / "talk.py"
    path.write_text(TALK)
    return ExecuteProcess(cmd=["python3", str(path)], output="screen")


def logged(result) -> list[str]:
    return [line.removeprefix("[python3-1] ") for line in result.lines if line.startswith("[python3-1] line")]


EVERY = [f"line {number}" for number in range(6)]


def test_nobody_needs_to_listen(launch, talk) -> None:
    assert logged(launch([talk])) == EVERY


@pytest.mark.parametrize("kind", ["of the process", "of any event"])
def test_who_begins_to_listen_hears_the_rest_and_the_log_stays_whole(launch, talk, kind) -> None:
    heard: list[str] = []

    def hear(event, _context=None) -> None:
        heard.append(event.text.decode().strip())

    handler = OnProcessIO(target_action=talk, on_stdout=hear)
    if kind == "of any event":
        handler = EventHandler(matcher=lambda event: isinstance(event, ProcessStdout), entities=hear)
    later = TimerAction(period=1.25, actions=[RegisterEventHandler(handler)])
    assert logged(launch([talk, later])) == EVERY
    assert heard == EVERY[3:]


def test_with_debug_each_event_is_told(launch, talk) -> None:
    result = launch([talk], debug=True)
    assert "processing event: '<launch.events.process.process_io.ProcessStdout" in result.text
    assert logged(result) == EVERY
