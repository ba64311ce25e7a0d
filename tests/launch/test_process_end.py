from __future__ import annotations

import signal
import sys

from launch.actions import (
    EmitEvent,
    ExecuteProcess,
    Shutdown,
    TimerAction,
)
from launch.events import Shutdown as ShutdownEvent
from launch.events import matches_action
from launch.events.process import ShutdownProcess, SignalProcess
from launch_ros.actions import Node

STUBBORN = """
import rclpy, time
while True:
    try:
        time.sleep(1000.0)
    except KeyboardInterrupt:
        print('ignored')
"""
VERY_STUBBORN = """
import signal, time
signal.signal(signal.SIGTERM, lambda number, frame: print('not that either'))
while True:
    try:
        time.sleep(1000.0)
    except KeyboardInterrupt:
        pass
"""


def python(code: str, **kwargs: object) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", code], name="python", **kwargs)  # type: ignore[arg-type]


def test_processes_are_respawned_after_their_delay(launch, workspace, session) -> None:
    workspace.executable("demo", "brief", 'print("again")\n')
    result = launch(
        [
            Node(
                package="demo",
                executable="brief",
                output="screen",
                respawn=True,
                respawn_delay=2.0,
                respawn_max_retries=2,
            )
        ]
    )
    assert result.lines.count("[brief-1] again") == 3
    assert session.clock.steady() == 4_000_000_000


def test_the_shutdown_ends_respawning(launch, workspace, session) -> None:
    workspace.executable("demo", "brief", "")
    launch(
        [
            Node(package="demo", executable="brief", respawn=True, respawn_delay=10.0),
            TimerAction(period=15.0, actions=[Shutdown()]),
        ]
    )
    assert session.clock.steady() == 15_000_000_000


def test_ctrl_c_reaches_the_processes_as_in_a_terminal(launch, talker) -> None:
    result = launch([Node(package="demo", executable="talker")], interrupt_after=2.5)
    assert result.code == 0
    assert result.lines[-2:] == [
        "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)",
        "[INFO] [talker-1]: process has finished cleanly [pid 1001]",
    ]


def test_a_launch_file_that_says_ctrl_c_was_pressed_sends_nothing(launch, talker, session) -> None:
    pressed = EmitEvent(event=ShutdownEvent(reason="none", due_to_sigint=True))
    result = launch([Node(package="demo", executable="talker"), TimerAction(period=1.0, actions=[pressed])])
    assert result.code == 0
    waited = "[ERROR] [talker-1]: process[talker-1] failed to terminate '5' seconds after receiving 'SIGINT', "
    assert f"{waited}escalating to 'SIGTERM'" in result.lines
    assert "[INFO] [talker-1]: sending signal 'SIGTERM' to process[talker-1]" in result.lines
    assert session.clock.steady() == 6_000_000_000


def test_without_a_terminal_the_launch_sends_the_signal_itself(launch, talker) -> None:
    result = launch([Node(package="demo", executable="talker")], interrupt_after=2.5, noninteractive=True)
    assert "[INFO] [talker-1]: sending signal 'SIGINT' to process[talker-1]" in result.lines


def test_a_process_that_ignores_ctrl_c_is_terminated_after_five_seconds(launch, workspace, session) -> None:
    workspace.executable("demo", "stubborn", STUBBORN)
    result = launch([Node(package="demo", executable="stubborn", output="screen")], interrupt_after=1.0)
    path = workspace.prefix / "lib/demo/stubborn"
    assert result.lines[1:] == [
        "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)",
        "[stubborn-1] ignored",
        "[ERROR] [stubborn-1]: process[stubborn-1] failed to terminate '5' seconds after receiving 'SIGINT', "
        "escalating to 'SIGTERM'",
        "[INFO] [stubborn-1]: sending signal 'SIGTERM' to process[stubborn-1]",
        f"[ERROR] [stubborn-1]: process has died [pid 1001, exit code -15, cmd '{path} --ros-args'].",
    ]
    assert session.clock.steady() == 6_000_000_000


def test_a_process_that_ignores_that_too_is_killed(launch, workspace, session) -> None:
    workspace.executable("demo", "rock", VERY_STUBBORN)
    result = launch(
        [
            Node(
                package="demo", executable="rock", output="screen", sigterm_timeout="1", sigkill_timeout="2"
            ),
            TimerAction(period=1.0, actions=[Shutdown()]),
        ]
    )
    assert (
        "[ERROR] [rock-1]: process[rock-1] failed to terminate '1' seconds after receiving 'SIGINT', "
        "escalating to 'SIGTERM'" in result.lines
    )
    assert "[rock-1] not that either" in result.lines
    assert (
        "[ERROR] [rock-1]: process[rock-1] failed to terminate '3.0' seconds after receiving 'SIGTERM', "
        "escalating to 'SIGKILL'" in result.lines
    )
    assert "exit code -9" in result.lines[-1]
    assert session.clock.steady() == 4_000_000_000


def test_a_second_ctrl_c_is_ignored_and_said_to_be(launch, workspace, session) -> None:
    workspace.executable("demo", "stubborn", STUBBORN)

    def press_again(service) -> None:
        session.clock.sleep(2.0)
        session.processes[0].interrupt()

    result = launch([Node(package="demo", executable="stubborn")], interrupt_after=1.0, meanwhile=press_again)
    assert "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT) again, ignoring..." in result.lines


def test_signals_can_be_sent_by_events(launch, talker) -> None:
    node = Node(package="demo", executable="talker")
    result = launch(
        [
            node,
            TimerAction(
                period=1.0,
                actions=[
                    EmitEvent(
                        event=SignalProcess(
                            signal_number=signal.SIGTERM, process_matcher=matches_action(node)
                        )
                    )
                ],
            ),
        ]
    )
    assert "[INFO] [talker-1]: sending signal 'SIGTERM' to process[talker-1]" in result.lines
    assert (
        "exit code 1" in result.lines[-1]
    )  # rclpy shuts down on SIGTERM, which spin tells with an exception


def test_a_single_process_can_be_shut_down(launch, talker) -> None:
    node = Node(package="demo", executable="talker")
    result = launch(
        [
            node,
            TimerAction(
                period=1.0, actions=[EmitEvent(event=ShutdownProcess(process_matcher=matches_action(node)))]
            ),
        ]
    )
    assert result.lines[-1] == "[INFO] [talker-1]: process has finished cleanly [pid 1001]"


def test_a_launch_that_is_killed_leaves_no_process_behind(session, talker) -> None:
    from launch import LaunchDescription, LaunchService

    def main() -> None:
        service = LaunchService()
        service.include_launch_description(LaunchDescription([Node(package="demo", executable="talker")]))
        service.run()

    process = session.start(main, name="launch")
    session.clock.sleep(1.0)
    assert len(session.processes) == 2
    process.kill()
    process.wait()
    session.clock.sleep(1.0)
    assert session.processes == []
