"""Terminals for processes, functions as targets of handlers, and what ends when a launch fails on its way."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any
from unittest.mock import Mock, NonCallableMock

import launch.logging
import pytest
from launch import Action, LaunchContext, LaunchDescription, LaunchDescriptionEntity, LaunchService
from launch.actions import (
    DeclareLaunchArgument,
    ExecuteProcess,
    OpaqueFunction,
    RegisterEventHandler,
    SetLaunchConfiguration,
)
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from launch.events.process import ProcessExited, ProcessIO, ProcessStarted
from launch.frontend.parse_substitution import parse_substitution
from launch.substitutions import (
    AllSubstitution,
    AnySubstitution,
    LaunchLogDir,
    SubstitutionFailure,
    TextSubstitution,
)
from launch.utilities import ensure_argument_type
from launch.utilities.type_utils import coerce_to_type

from tests.needs import posix

ASKS = [sys.executable, "-c", "import sys; sys.exit(sys.stdout.isatty() + 2 * sys.stderr.isatty())"]


def run(*entities: Any) -> int:
    service = LaunchService()
    service.include_launch_description(LaunchDescription([*entities]))
    return service.run()


@posix("a child has no terminal there, as in Humble")
@pytest.mark.parametrize(
    ("before", "options", "code"),
    [
        ([], {}, 0),
        ([], {"emulate_tty": True}, 3),
        ([SetLaunchConfiguration("emulate_tty", "true")], {}, 3),
        ([SetLaunchConfiguration("emulate_tty", "false")], {"emulate_tty": True}, 0),
    ],
)
def test_a_process_has_a_terminal_when_it_or_the_configuration_asks_for_one(
    before: list[Any], options: dict[str, Any], code: int
) -> None:
    action = ExecuteProcess(cmd=ASKS, **options)
    run(*before, action)
    assert action.return_code == code


def test_what_is_written_to_a_terminal_arrives_in_lines(capfd: pytest.CaptureFixture[str]) -> None:
    writes = "import sys; print('one'); print('two', file=sys.stderr); print('three', end='')"
    action = ExecuteProcess(cmd=[sys.executable, "-c", writes], emulate_tty=True, output="screen", cached_output=True)
    assert run(action) == 0
    assert (action.get_stdout(), action.get_stderr()) == ("one\nthree", "two\n")


def event(kind: type, action: Any, **more: Any) -> Any:
    return kind(action=action, name="a", cmd=["ls"], cwd=None, env=None, pid=1, **more)


@pytest.mark.parametrize(
    ("handler", "given", "kind", "more"),
    [
        (OnProcessExit, {"on_exit": []}, ProcessExited, {"returncode": 0}),
        (OnProcessStart, {"on_start": []}, ProcessStarted, {}),
        (OnProcessIO, {}, ProcessIO, {"text": b"", "fd": 1}),
    ],
)
def test_a_target_that_can_be_called_is_asked(handler: Any, given: Any, kind: Any, more: Any) -> None:
    one, other = NonCallableMock(spec=ExecuteProcess), NonCallableMock(spec=ExecuteProcess)
    asked = handler(target_action=Mock(side_effect=lambda action: action is other), **given)
    assert [asked.matches(event(kind, action, **more)) for action in (one, other)] == [False, True]
    both = handler(target_action=Mock(spec=ExecuteProcess, return_value=True), **given)
    assert both.matches(event(kind, one, **more))
    mine = handler(target_action=one, **given)
    assert [mine.matches(event(kind, action, **more)) for action in (one, other)] == [True, False]
    with pytest.raises(TypeError):
        handler(target_action=NonCallableMock(), **given)


def test_actions_that_are_given_to_a_handler_come_out_of_it() -> None:
    actions = [NonCallableMock(spec=Action), NonCallableMock(spec=Action)]
    handler = OnProcessExit(on_exit=actions)
    assert handler.handle(event(ProcessExited, Mock(), returncode=0), Mock(spec=LaunchContext)) == actions


def test_processes_before_a_failure_are_started_and_ended() -> None:
    """Humble defers the end of a process that is about to start; its on_exit is called."""
    ended: list[int] = []
    waits = [sys.executable, "-c", "import time; time.sleep(100)"]

    def fail(context: LaunchContext) -> None:
        raise RuntimeError("no such thing")

    processes = [ExecuteProcess(cmd=waits, on_exit=lambda e, c: ended.append(e.returncode)) for _ in range(2)]
    assert run(*processes, OpaqueFunction(function=fail)) == 1
    assert len(ended) == 2
    assert 0 not in ended


def test_an_entity_without_a_description_says_so() -> None:
    with pytest.raises(NotImplementedError):
        LaunchDescriptionEntity().describe()


def test_a_default_that_is_no_choice_is_a_runtime_error() -> None:
    with pytest.raises(RuntimeError, match="not in provided choices"):
        DeclareLaunchArgument("a", choices=["x", "y"], default_value="z")
    with pytest.raises(RuntimeError, match="choices arg is empty"):
        DeclareLaunchArgument("a", choices=[])
    assert DeclareLaunchArgument("a", choices=["x"]).description == "One of: ['x']"


def test_an_empty_text_stays_one() -> None:
    assert coerce_to_type("") == ""


@pytest.mark.parametrize("types", [[123, str], [str, 123], "str", None])
def test_types_that_are_none_are_told(types: Any) -> None:
    with pytest.raises(TypeError, match=r"expected 'types' to be one of \[type, collections.abc.Iterable of type\]"):
        ensure_argument_type("foo", types, "a")


@pytest.mark.parametrize("kind", [AllSubstitution, AnySubstitution])
@pytest.mark.parametrize("values", [("true", "x"), ("false", "x")])
def test_every_value_has_to_be_a_truth_value(kind: Any, values: tuple[str, str]) -> None:
    with pytest.raises(SubstitutionFailure):
        kind(*values).perform(LaunchContext())


def test_a_handler_with_a_callable_entity_calls_it() -> None:
    """As RegisterEventHandler(OnProcessExit(on_exit=function)) does."""
    codes: list[int] = []
    action = ExecuteProcess(cmd=[sys.executable, "-c", "pass"])
    handler = OnProcessExit(target_action=lambda one: one is action, on_exit=lambda e, c: codes.append(e.returncode))
    assert run(RegisterEventHandler(handler), action) == 0
    assert codes == [0]


def test_the_log_folder_in_text_is_a_text(tmp_path: Path) -> None:
    """Humble gives a TextSubstitution for $(log_dir), and later ones LaunchLogDir."""
    launch.logging.reset()
    launch.logging.launch_config.log_dir = str(tmp_path)
    for name in ("log_dir", "launch_log_dir"):
        (sub,) = parse_substitution(f"$({name})")
        assert isinstance(sub, LaunchLogDir) and isinstance(sub, TextSubstitution)
        assert sub.text == sub.perform(LaunchContext()) == str(tmp_path)
    assert LaunchLogDir().describe() == "LaunchLogDir()"
