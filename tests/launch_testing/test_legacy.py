"""Launches whose tests are programs, as nav2 and geometry2 write theirs."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess, OpaqueCoroutine, RegisterEventHandler, TimerAction
from launch.event_handlers import OnShutdown
from launch_ros.actions import Node
from launch_testing.legacy import LaunchTestService

from coursekit.processes.session import Session

Launch = tuple[LaunchTestService, LaunchDescription, Callable[[], int], list[str]]
TALKER = ["ros2", "run", "demo_nodes_py", "talker"]
ANSWER = ["ros2", "topic", "echo", "--once", "/chatter"]
REFUSED = ["ros2", "no_such_verb"]


@pytest.fixture
def launch(session: Session) -> Launch:
    """The service, its description, the run of both in the session, and the reasons for which launches were shut down."""
    service, description, reasons = LaunchTestService(), LaunchDescription(), []

    def end(event: object, context: object) -> None:
        reasons.append(event.reason)  # type: ignore[attr-defined]

    description.add_action(RegisterEventHandler(OnShutdown(on_shutdown=end)))

    def run() -> int:
        codes: list[int] = []

        def main() -> None:
            launcher = LaunchService(argv=[])
            launcher.include_launch_description(description)
            codes.append(service.run(launcher))

        session.start(main, name="test").wait()
        return codes[0]

    return service, description, run, reasons


def test_a_launch_ends_well_when_all_its_tests_have(launch: Launch) -> None:
    service, description, run, reasons = launch
    talker = Node(package="demo_nodes_py", executable="talker")
    assert service.add_fixture_action(description, talker) is talker
    tests = [ExecuteProcess(cmd=ANSWER), TimerAction(period=5.0, actions=[])]
    assert [service.add_test_action(description, test) for test in tests] == tests
    assert run() == 0
    assert reasons == ["all tests finished"]


def test_the_first_failure_ends_the_launch_and_is_its_exit_code(launch: Launch) -> None:
    service, description, run, reasons = launch
    service.add_test_action(description, ExecuteProcess(cmd=REFUSED, name="bad"))
    service.add_test_action(description, ExecuteProcess(cmd=TALKER))
    assert run() == 2
    assert reasons == ["bad-1 test failed!"]


def test_an_action_fails_by_its_exception(launch: Launch) -> None:
    service, description, run, reasons = launch

    async def broken(context: object) -> None:
        raise ValueError("no arm")

    service.add_test_action(description, OpaqueCoroutine(coroutine=broken))
    assert run() == 1
    assert "no arm" in reasons[0]


@pytest.mark.parametrize(("allowed", "code"), [((0,), 2), ([0, 2], 0), (True, 0), (False, 2)])
def test_what_tests_need_may_end_only_as_allowed(launch: Launch, allowed: bool | list[int], code: int) -> None:
    service, description, run, reasons = launch
    service.add_fixture_action(description, ExecuteProcess(cmd=REFUSED, name="arm"), exit_allowed=allowed)
    service.add_test_action(description, TimerAction(period=5.0, actions=[]))
    assert run() == code
    assert reasons == ["arm-1 fixture process died!" if code else "all tests finished"]
