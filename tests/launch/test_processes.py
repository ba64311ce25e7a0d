from __future__ import annotations

import re
import signal
import sys

import pytest
from launch import LaunchContext
from launch.actions import (
    DeclareLaunchArgument,
    EmitEvent,
    ExecuteProcess,
    GroupAction,
    LogInfo,
    OpaqueFunction,
    RegisterEventHandler,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    Shutdown,
    TimerAction,
)
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from launch.events import matches_action
from launch.events.process import ShutdownProcess, SignalProcess
from launch.substitutions import FindExecutable, LaunchConfiguration
from launch_ros.actions import Node

USER = "[INFO] [launch.user]: "

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


def test_a_real_process_starts_prints_and_finishes(launch) -> None:
    result = launch([ExecuteProcess(cmd=["echo", "hello there"], output="screen")])
    assert result.lines == [
        "[INFO] [echo-1]: process started with pid [1001]",
        "[echo-1] hello there",
        "[INFO] [echo-1]: process has finished cleanly [pid 1001]",
    ]


def test_a_process_that_fails_has_died_with_its_code(launch) -> None:
    result = launch([ExecuteProcess(cmd=["sh", "-c", "exit 3"])])
    assert result.code == 0
    assert result.lines[-1] == "[ERROR] [sh-1]: process has died [pid 1001, exit code 3, cmd 'sh -c exit 3']."


def test_a_program_that_does_not_exist_is_an_error_of_its_process_only(launch) -> None:
    result = launch([ExecuteProcess(cmd=["no-such-program"]), LogInfo(msg="still here")])
    assert result.code == 0
    assert USER + "still here" in result.lines
    assert "[ERROR] [no-such-program-1]: exception occurred while executing process:" in result.lines


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
    result = launch([python(code, output=output)])
    lines = [line for line in result.lines if line.startswith("[python-1]")]
    assert sorted(lines) == sorted(f"[python-1] {word}" for word in shown)


def test_own_logs_are_files_in_the_log_folder(launch, tmp_path) -> None:
    launch([ExecuteProcess(cmd=["echo", "hi"], output="own_log")])
    (folder,) = (tmp_path / "log").iterdir()
    assert sorted(path.name for path in folder.iterdir()) == ["echo-1-stdout.log", "echo-1.log", "launch.log"]
    assert "[echo-1] hi" in (folder / "echo-1.log").read_text()
    assert "process started with pid" in (folder / "launch.log").read_text()


def test_an_unknown_output_is_an_error(launch) -> None:
    result = launch([ExecuteProcess(cmd=["true"], output="scren")])
    assert result.code == 1
    assert "'scren' is not a valid standard output config, expected one of ['screen', 'log'" in result.text


def test_a_last_line_without_end_is_shown_too(launch) -> None:
    result = launch([ExecuteProcess(cmd=["printf", r"a\nb"], output="screen")])
    assert [line for line in result.lines if line.startswith("[printf-1] ")] == [
        "[printf-1] a",
        "[printf-1] b",
    ]


def test_the_output_format_may_be_changed(launch) -> None:
    result = launch([ExecuteProcess(cmd=["echo", "a"], output="screen", output_format="<{line}>")])
    assert "<a>" in result.lines


def test_environment_and_folder_are_the_ones_given(launch, tmp_path) -> None:
    code = "import os; print(os.environ.get('A'), os.environ.get('B'), os.path.basename(os.getcwd()))"
    (tmp_path / "here").mkdir()
    result = launch(
        [
            SetEnvironmentVariable("A", "1"),
            python(
                code,
                output="screen",
                additional_env={"B": LaunchConfiguration("b", default="2")},
                cwd=str(tmp_path / "here"),
            ),
        ]
    )
    assert "[python-1] 1 2 here" in result.lines


def test_a_shell_runs_only_when_it_is_asked_for(launch, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SHELL", "/bin/sh")
    plain = launch([ExecuteProcess(cmd=["echo", "$((1 + 1))"], output="screen")])
    assert "[echo-1] $((1 + 1))" in plain.lines
    shell = launch([ExecuteProcess(cmd=["echo", "$((1 + 1))"], output="screen", shell=True)])
    assert "[echo-1] 2" in shell.lines


def test_a_prefix_goes_before_the_command(launch) -> None:
    result = launch([ExecuteProcess(cmd=["echo", "x"], prefix="env echo before", output="screen")])
    assert "[echo-1] before echo x" in result.lines
    everywhere = launch(
        [
            SetLaunchConfiguration("launch-prefix", "echo"),
            SetLaunchConfiguration("launch-prefix-filter", "tr.e"),
            ExecuteProcess(cmd=["true"], output="screen"),
            ExecuteProcess(cmd=["printf", "x"], output="screen"),
        ]
    )
    assert {"[true-1] true", "[printf-2] x"} <= set(everywhere.lines)


def test_the_command_is_logged_on_request(launch) -> None:
    result = launch([ExecuteProcess(cmd=["true"], log_cmd=True)])
    assert result.lines[0] == "[INFO] [true-1]: process details: cmd='true', cwd='None', custom_env?=False"


def test_output_can_be_asked_for_afterwards(launch) -> None:
    process = ExecuteProcess(cmd=["echo", "kept"], cached_output=True)
    launch([process])
    assert (process.get_stdout(), process.get_stderr(), process.return_code) == ("kept\n", "", 0)
    with pytest.raises(RuntimeError, match="cached output must be true"):
        ExecuteProcess(cmd=["true"]).get_stdout()


def test_an_action_cannot_be_carried_out_twice(launch) -> None:
    process = ExecuteProcess(cmd=["true"])
    result = launch([process, process])
    assert result.code == 1
    assert "executed more than once" in result.text


def test_handlers_hear_of_start_output_and_exit(launch) -> None:
    process = ExecuteProcess(cmd=["echo", "hi"])
    other = ExecuteProcess(cmd=["true"])
    heard: list[str] = []
    result = launch(
        [
            RegisterEventHandler(OnProcessStart(target_action=process, on_start=[LogInfo(msg="started")])),
            RegisterEventHandler(
                OnProcessIO(target_action=process, on_stdout=lambda event: heard.append(event.text.decode()))
            ),
            RegisterEventHandler(
                OnProcessExit(
                    target_action=process,
                    on_exit=lambda event, context: LogInfo(msg=f"{event.process_name} {event.returncode}"),
                )
            ),
            RegisterEventHandler(
                OnProcessExit(
                    target_action=lambda action: action is other, on_exit=[LogInfo(msg="the other")]
                )
            ),
            process,
            other,
        ]
    )
    assert heard == ["hi\n"]
    said = [line for line in result.lines if line.startswith(USER)]
    assert sorted(said) == [USER + "echo-1 0", USER + "started", USER + "the other"]


def test_what_comes_on_exit_may_be_given_with_the_process(launch) -> None:
    result = launch([ExecuteProcess(cmd=["true"], on_exit=[LogInfo(msg="gone")])])
    assert result.lines[-1] == USER + "gone"


def test_a_required_process_ends_the_launch(launch) -> None:
    result = launch([ExecuteProcess(cmd=["sleep", "100"]), ExecuteProcess(cmd=["true"], on_exit=Shutdown())])
    assert "[INFO] [launch]: process[true-2] was required: shutting down launched system" in result.lines
    assert "[INFO] [sleep-1]: sending signal 'SIGINT' to process[sleep-1]" in result.lines
    assert "exit code -2, cmd 'sleep 100'" in result.lines[-1]


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


def test_two_runs_on_the_virtual_clock_print_the_same(talker, tmp_path) -> None:
    from launch import LaunchDescription, LaunchService

    from coursekit.core.session import Session

    def run() -> str:
        def main() -> None:
            service = LaunchService()
            service.include_launch_description(
                LaunchDescription(
                    [
                        GroupAction(
                            [
                                DeclareLaunchArgument("n", default_value="1"),
                                Node(
                                    package="demo",
                                    executable="talker",
                                    name=f"talker{number}",
                                    output="screen",
                                    parameters=[{"rate": float(number)}],
                                ),
                            ]
                        )
                        for number in (1, 2, 3)
                    ]
                )
            )
            service.run()

        with Session(virtual=True).use() as session:
            process = session.start(main, name="launch")
            session.clock.sleep(5.2)
            process.interrupt()
            process.wait()
            return process.output

    first = run()
    assert first == run()
    assert len(re.findall("Publishing", first)) == 5 + 10 + 15


def test_the_names_of_processes_are_counted_per_launch(context: LaunchContext) -> None:
    for expected in ("a-1", "b-2"):
        process = ExecuteProcess(cmd=[f"/bin/{expected[0]}"])
        process.prepare(context)
        assert process.process_details is not None and process.process_details["name"] == expected


def test_a_launch_can_be_shut_down_from_another_lane(launch, talker, session) -> None:
    def stop(service) -> None:
        session.clock.sleep(3.0)
        service.shutdown()

    result = launch([Node(package="demo", executable="talker")], meanwhile=stop)
    assert "[INFO] [talker-1]: sending signal 'SIGINT' to process[talker-1]" in result.lines
    assert result.code == 0


def test_the_output_of_all_processes_can_be_shown(launch, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OVERRIDE_LAUNCH_PROCESS_OUTPUT", "both")
    result = launch([ExecuteProcess(cmd=["echo", "shown"], output="log")])
    assert "[echo-1] shown" in result.lines


def test_a_function_may_start_processes(launch) -> None:
    result = launch([OpaqueFunction(function=lambda context: [ExecuteProcess(cmd=["true"])])])
    assert result.lines[-1] == "[INFO] [true-1]: process has finished cleanly [pid 1001]"


@pytest.mark.parametrize(
    ("cmd", "shell"),
    [
        (["ros2", "pkg", "prefix", "demo"], False),
        ([["ros2", " pkg prefix ", "demo"]], True),
        ([[FindExecutable(name="ros2"), " pkg prefix ", '"demo"']], True),
    ],
)
def test_ros2_commands_are_carried_out_in_the_session(launch, workspace, cmd, shell: bool) -> None:
    workspace.package("demo")
    result = launch([ExecuteProcess(cmd=cmd, shell=shell, name="ros2", output="screen")])
    assert result.lines[1:] == [
        f"[ros2-1] {workspace.prefix}",
        "[INFO] [ros2-1]: process has finished cleanly [pid 1001]",
    ]


def test_what_needs_a_shell_is_left_to_it(launch, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SHELL", "/bin/sh")
    result = launch([ExecuteProcess(cmd=["echo", "b", "&&", "echo", "a"], shell=True, output="screen")])
    assert [line for line in result.lines if line.startswith("[echo-1] ")] == ["[echo-1] b", "[echo-1] a"]


def test_a_terminal_window_before_a_node_is_left_out(launch, talker) -> None:
    node = Node(package="demo", executable="talker", prefix="xterm -hold -e", output="screen")
    result = launch([node], interrupt_after=1.5)
    assert (
        '[talker-1] [INFO] [1700000001.000000000] [talker]: Publishing: "hello 0" on /chatter' in result.lines
    )


def test_the_wall_clock_launches_as_well(workspace, tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    from launch import LaunchDescription, LaunchService

    from coursekit.core.session import Session

    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    workspace.executable("demo", "brief", "print('brief')")

    def main() -> int:
        service = LaunchService()
        service.include_launch_description(
            LaunchDescription(
                [
                    Node(package="demo", executable="brief", output="screen"),
                    ExecuteProcess(cmd=["echo", "real"], output="screen"),
                ]
            )
        )
        return service.run()

    with Session(virtual=False).use() as session:
        process = session.start(main, name="launch")
        assert process.wait(60.0) == 0
    assert {"[brief-1] brief", "[echo-2] real"} <= set(process.output.splitlines())
