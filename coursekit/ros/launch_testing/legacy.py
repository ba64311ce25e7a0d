"""Launches whose tests are programs: the exit codes decide. In ROS 2: launch_testing.legacy, as nav2's own tests use it."""

from __future__ import annotations

from collections.abc import Collection
from functools import partial
from typing import Any, TypeVar

from launch import Action, LaunchContext, LaunchDescription, LaunchService
from launch.actions import EmitEvent, ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnExecutionComplete, OnProcessExit
from launch.events import ExecutionComplete, Shutdown
from launch.events.process import ProcessExited

SomeAction = TypeVar("SomeAction", bound=Action)


class LaunchTestService:
    """Adds tests and what they need to a launch description, and runs it until all tests have ended or one has failed."""

    def __init__(self) -> None:
        self._waiting: set[int] = set()
        """The tests that have not ended yet, by their actions."""
        self._failures: list[int] = []
        """Exit codes, in the order of the failures."""

    def add_fixture_action(
        self, launch_description: LaunchDescription, action: SomeAction, exit_allowed: bool | Collection[int] = (0,)
    ) -> SomeAction:
        """Add an action that tests need. If its process ends in a way that is not allowed, the launch fails."""
        launch_description.add_action(action)
        if isinstance(action, ExecuteProcess):
            ended = partial(self._fixture_ended, exit_allowed)
            launch_description.add_action(RegisterEventHandler(OnProcessExit(target_action=action, on_exit=ended)))
        return action

    def _fixture_ended(
        self, allowed: bool | Collection[int], event: ProcessExited, context: LaunchContext
    ) -> EmitEvent | None:
        is_allowed = allowed if isinstance(allowed, bool) else event.returncode in allowed
        if is_allowed or context.is_shutdown:
            return None
        return self._fail(context, event.returncode, f"{event.process_name} fixture process died!")

    def add_test_action(self, launch_description: LaunchDescription, action: SomeAction) -> SomeAction:
        """Add a test: a process, which has to exit with 0, or an action, which has to complete without an exception."""
        handler = (
            OnProcessExit(target_action=action, on_exit=partial(self._process_ended, action))
            if isinstance(action, ExecuteProcess)
            else OnExecutionComplete(target_action=action, on_completion=partial(self._action_ended, action))
        )
        launch_description.add_action(RegisterEventHandler(handler))
        launch_description.add_action(action)
        self._waiting.add(id(action))
        return action

    def _process_ended(self, test: Action, event: ProcessExited, context: LaunchContext) -> EmitEvent | None:
        if event.returncode:
            return self._fail(context, event.returncode, f"{event.process_name} test failed!")
        return self._succeed(context, test)

    def _action_ended(self, test: Action, event: ExecutionComplete, context: LaunchContext) -> EmitEvent | None:
        future = test.get_asyncio_future()
        if future is not None and future.cancelled():
            self._waiting.discard(id(test))
            return None
        error = None if future is None else future.exception()
        return self._succeed(context, test) if error is None else self._fail(context, 1, str(error))

    def _succeed(self, context: LaunchContext, test: Action) -> EmitEvent | None:
        self._waiting.discard(id(test))
        return None if self._waiting else _shutdown(context, "all tests finished")

    def _fail(self, context: LaunchContext, code: int, reason: str) -> EmitEvent | None:
        self._waiting.clear()
        self._failures.append(code or 1)
        return _shutdown(context, reason)

    def run(self, launch_service: LaunchService, *args: Any, **kwargs: Any) -> int:
        """Run the launch; return its exit code, or if that is 0 the exit code of the first failure."""
        code = launch_service.run(*args, **kwargs)
        return code or next(iter(self._failures), 0)


def _shutdown(context: LaunchContext, reason: str) -> EmitEvent | None:
    """End the launch, unless it ends already."""
    return None if context.is_shutdown else EmitEvent(event=Shutdown(reason=reason))


__all__ = ["LaunchTestService"]
