from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

import pytest
from launch import LaunchContext
from launch.actions import (
    DeclareLaunchArgument,
    ExecuteProcess,
    GroupAction,
    LogInfo,
    OpaqueFunction,
    RegisterEventHandler,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    Shutdown,
)
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from launch.substitutions import FindExecutable, LaunchConfiguration
from launch_ros.actions import Node

from tests.needs import posix

USER = "[INFO] [launch.user]: "


def python(code: str, **kwargs: object) -> ExecuteProcess:
    return ExecuteProcess(cmd=[sys.executable, "-c", code], name="python", **kwargs)  # type: ignore[arg-type]


def test_a_real_process_starts_prints_and_finishes(launch) -> None:
    result = launch([ExecuteProcess(cmd=["echo", "hello there"], output="screen")])
    assert result.lines == [
        "[INFO] [echo-1]: process started with pid [1001]",
        "[echo-1] hello there",
        "[INFO] [echo-1]: process has finished cleanly [pid 1001]",
    ]


@posix("there is no sh, env, nor an end by a signal")
def test_a_process_that_fails_has_died_with_its_code(launch) -> None:
    result = launch([ExecuteProcess(cmd=["sh", "-c", "exit 3"])])
    assert result.code == 0
    assert result.lines[-1] == "[ERROR] [sh-1]: process has died [pid 1001, exit code 3, cmd 'sh -c exit 3']."


def test_a_program_that_does_not_exist_is_an_error_of_its_process_only(launch) -> None:
    result = launch([ExecuteProcess(cmd=["no-such-program"]), LogInfo(msg="still here")])
    assert result.code == 0
    assert USER + "still here" in result.lines
    assert "[ERROR] [no-such-program-1]: exception occurred while executing process:" in result.lines


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


@posix("there is no sh, env, nor an end by a signal")
def test_a_shell_runs_only_when_it_is_asked_for(launch, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SHELL", "/bin/sh")
    plain = launch([ExecuteProcess(cmd=["echo", "$((1 + 1))"], output="screen")])
    assert "[echo-1] $((1 + 1))" in plain.lines
    shell = launch([ExecuteProcess(cmd=["echo", "$((1 + 1))"], output="screen", shell=True)])
    assert "[echo-1] 2" in shell.lines


@posix("there is no sh, env, nor an end by a signal")
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
                OnProcessExit(target_action=lambda action: action is other, on_exit=[LogInfo(msg="the other")])
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


@posix("there is no sh, env, nor an end by a signal")
def test_a_required_process_ends_the_launch(launch) -> None:
    result = launch([ExecuteProcess(cmd=["sleep", "100"]), ExecuteProcess(cmd=["true"], on_exit=Shutdown())])
    assert "[INFO] [launch]: process[true-2] was required: shutting down launched system" in result.lines
    assert "[INFO] [sleep-1]: sending signal 'SIGINT' to process[sleep-1]" in result.lines
    assert "exit code -2, cmd 'sleep 100'" in result.lines[-1]


def test_two_runs_on_the_virtual_clock_print_the_same(talker, tmp_path) -> None:
    from launch import LaunchDescription, LaunchService

    from coursekit.processes.session import Session

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


@pytest.mark.parametrize("name", ["ros2", None])
def test_a_program_in_a_folder_with_spaces_is_one_word_for_a_shell(launch, workspace, tmp_path, monkeypatch, name) -> None:
    workspace.package("demo")
    programs = tmp_path / "José Pérez (1)"
    programs.mkdir()
    shutil.copy(FindExecutable(name="ros2").perform(LaunchContext()), programs)
    monkeypatch.setenv("PATH", str(programs))
    ros2 = FindExecutable(name="ros2")
    result = launch([ExecuteProcess(cmd=[[ros2, " pkg prefix demo"]], shell=True, name=name, output="screen")])
    number = "ros2-1" if name else f"{Path(ros2.perform(LaunchContext())).name} pkg prefix demo-1"
    assert f"[{number}] {workspace.prefix}" in result.lines


@posix("there is no sh, env, nor an end by a signal")
def test_what_needs_a_shell_is_left_to_it(launch, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SHELL", "/bin/sh")
    result = launch([ExecuteProcess(cmd=["echo", "b", "&&", "echo", "a"], shell=True, output="screen")])
    assert [line for line in result.lines if line.startswith("[echo-1] ")] == ["[echo-1] b", "[echo-1] a"]


def test_a_terminal_window_before_a_node_is_left_out(launch, talker) -> None:
    node = Node(package="demo", executable="talker", prefix="xterm -hold -e", output="screen")
    result = launch([node], interrupt_after=1.5)
    assert '[talker-1] [INFO] [1700000001.000000000] [talker]: Publishing: "hello 0" on /chatter' in result.lines


def test_the_wall_clock_launches_as_well(workspace, tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    from launch import LaunchDescription, LaunchService

    from coursekit.processes.session import Session

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
