"""Whatever fails in a launch file is told in Humble's line, ends the launch with 1, and shows nothing of coursekit."""

from __future__ import annotations

import asyncio
import sys
from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext, LaunchDescription, LaunchService, Substitution
from launch.actions import (
    DeclareLaunchArgument,
    ExecuteProcess,
    GroupAction,
    IncludeLaunchDescription,
    LogInfo,
    OpaqueCoroutine,
    OpaqueFunction,
    RegisterEventHandler,
    SetLaunchConfiguration,
    TimerAction,
)
from launch.conditions import IfCondition
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart, OnShutdown
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import PushRosNamespace, SetRemap

SAYS = ["echo", "said"]


def boom(*_: Any, **__: Any) -> Any:
    raise RuntimeError("boom")


async def boom_later(_: LaunchContext) -> None:
    await asyncio.sleep(0.01)
    boom()


class Boom(Substitution):
    def perform(self, context: LaunchContext) -> str:
        return boom()


def process(**options: Any) -> ExecuteProcess:
    return ExecuteProcess(cmd=SAYS, **options)


def upon(handler: Any, **given: Any) -> list[Any]:
    return [RegisterEventHandler(handler(**given)), process()]


CASES: dict[str, list[Any]] = {
    "function": [OpaqueFunction(function=boom)],
    "coroutine": [OpaqueCoroutine(coroutine=boom_later)],
    "substitution": [LogInfo(msg=[Boom()])],
    "condition": [LogInfo(msg="a", condition=IfCondition(Boom()))],
    "command": [ExecuteProcess(cmd=["echo", Boom()])],
    "in a group": [GroupAction([LogInfo(msg=Boom())])],
    "in a timer": [TimerAction(period=0.01, actions=[OpaqueFunction(function=boom)])],
    "the timer's period": [TimerAction(period=Boom(), actions=[])],
    "on start": upon(OnProcessStart, on_start=boom),
    "on exit": upon(OnProcessExit, on_exit=boom),
    "on output": upon(OnProcessIO, on_stdout=boom),
    "on completion": upon(OnExecutionComplete, on_completion=boom),
    "a target": upon(OnProcessExit, target_action=boom, on_exit=[]),
    "on shutdown": [RegisterEventHandler(OnShutdown(on_shutdown=boom))],
    "its own on_exit": [process(on_exit=boom)],
    "respawn": [process(respawn=Boom())],
}


def launched(entities: list[Any], capfd: pytest.CaptureFixture[str]) -> tuple[int, str]:
    service = LaunchService()
    service.include_launch_description(LaunchDescription(entities))
    code = service.run()
    output = capfd.readouterr()
    return code, output.out + output.err


@pytest.mark.parametrize("case", CASES)
def test_a_failure_is_told_in_one_line_and_ends_the_launch(case: str, capfd: pytest.CaptureFixture[str]) -> None:
    code, shown = launched(CASES[case], capfd)
    assert code == 1
    assert "[ERROR] [launch]: Caught exception in launch (see debug for traceback): boom" in shown
    assert "Traceback" not in shown and "never retrieved" not in shown and "coursekit/" not in shown


@pytest.mark.parametrize(
    ("entities", "text"),
    [
        ([process(output_format="{nope}")], "'nope'"),
        ([SetLaunchConfiguration("emulate_tty", "perhaps"), process()], "perhaps"),
        ([process(sigterm_timeout="soon"), TimerAction(period=0.5, actions=[])], None),
    ],
)
def test_settings_that_mean_nothing_are_told(entities: Any, text: Any, capfd: pytest.CaptureFixture[str]) -> None:
    code, shown = launched(entities, capfd)
    assert code == (0 if text is None else 1)
    assert "Traceback" not in shown and "never retrieved" not in shown
    if text is not None:
        assert "Caught exception in launch (see debug for traceback): " in shown and text in shown


INNER = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration

def generate_launch_description():
    again = LaunchConfiguration('use_respawn')
    cmd = [{python!r}, '-c', 'print(1)']
    return LaunchDescription([
        DeclareLaunchArgument('use_respawn', default_value='False'),
        DeclareLaunchArgument('namespace'),
        ExecuteProcess(cmd=cmd, respawn=again, respawn_delay=2.0),
    ])
"""


def test_a_group_that_includes_what_is_respawned_by_a_setting_of_its_own(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """As launch files for TurtleBot 4 do around nav2_bringup: the setting has gone when the process ends."""
    (tmp_path / "inner.launch.py").write_text(INNER.format(python=sys.executable))
    namespace = LaunchConfiguration("namespace")

    def setup(context: LaunchContext) -> list[Any]:
        source = PythonLaunchDescriptionSource(PathJoinSubstitution([str(tmp_path), "inner.launch.py"]))
        prefix = "/" + namespace.perform(context)
        include = IncludeLaunchDescription(source, launch_arguments=[("namespace", namespace)])
        remap = SetRemap(prefix + "/global_costmap/scan", prefix + "/scan")
        return [GroupAction([PushRosNamespace(namespace), remap, include])]

    declared = DeclareLaunchArgument("namespace", default_value="robot")
    code, shown = launched([declared, OpaqueFunction(function=setup)], capfd)
    assert code == 0
    assert "process has finished cleanly" in shown and "Traceback" not in shown and "[ERROR]" not in shown
