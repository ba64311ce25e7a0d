"""Waiting for the output, the start and the end of a launched process.

Each function has two forms: a coroutine for tests that run in the launch's loop, and a form with `_sync` for tests in a
separate thread. `assert_...` take a function that raises AssertionError until it is satisfied, and raise its last error.
"""

from __future__ import annotations

import asyncio
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from launch import LaunchContext
from launch.actions import ExecuteLocal
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart

Handler = Callable[[ExecuteLocal, Callable[[], None]], Any]
Condition = Callable[[], Any]
Validate = Callable[[str], Any]


def _on_stdout(action: ExecuteLocal, tell: Callable[[], None]) -> OnProcessIO:
    return OnProcessIO(target_action=action, on_stdout=lambda _: tell())


def _on_stderr(action: ExecuteLocal, tell: Callable[[], None]) -> OnProcessIO:
    return OnProcessIO(target_action=action, on_stderr=lambda _: tell())


def _on_start(action: ExecuteLocal, tell: Callable[[], None]) -> OnProcessStart:
    return OnProcessStart(target_action=action, on_start=lambda *_: tell())


def _on_exit(action: ExecuteLocal, tell: Callable[[], None]) -> OnProcessExit:
    return OnProcessExit(target_action=action, on_exit=lambda *_: tell())


@contextmanager
def _registered(context: LaunchContext, handler: Any) -> Iterator[None]:
    context.register_event_handler(handler, append=True)  # after the handlers that store the output
    try:
        yield
    finally:
        context.unregister_event_handler(handler)


async def _wait(
    context: LaunchContext, action: ExecuteLocal, handler: Handler, condition: Condition, timeout: float | None
) -> Any:
    """Return the condition's value as soon as it is true, or after `timeout` seconds."""
    happened = asyncio.Event()
    loop = asyncio.get_running_loop()
    deadline = None if timeout is None else loop.time() + timeout
    with _registered(context, handler(action, happened.set)):
        value = condition()
        while not value:
            left = None if deadline is None else deadline - loop.time()
            try:
                await asyncio.wait_for(happened.wait(), left)
            except asyncio.TimeoutError:
                break
            happened.clear()
            value = condition()
    return value


def _wait_sync(
    context: LaunchContext, action: ExecuteLocal, handler: Handler, condition: Condition, timeout: float | None
) -> Any:
    """Return the condition's value as soon as it is true, or after `timeout` seconds."""
    happened = threading.Event()
    deadline = None if timeout is None else time.monotonic() + timeout
    with _registered(context, handler(action, happened.set)):
        value = condition()
        while not value and happened.wait(None if deadline is None else deadline - time.monotonic()):
            happened.clear()
            value = condition()
    return value


def _asserted(validate: Validate, text: Callable[[], str]) -> Condition:
    def holds() -> bool:
        try:
            validate(text())
        except AssertionError:
            return False
        return True

    return holds


def _value(validate: Validate, text: Callable[[], str]) -> Condition:
    def value() -> Any:
        try:
            return validate(text())
        except AssertionError:
            return False

    return value


async def wait_for_output(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Validate,
    timeout: float | None = None,
) -> Any:
    """Wait until `validate_output(stdout)` is true; return its last value. The action needs `cached_output=True`.

    Raises:
        AssertionError: from `validate_output`, if it still raises one after `timeout` seconds.
    """
    action = execute_process_action
    value = await _wait(launch_context, action, _on_stdout, _value(validate_output, action.get_stdout), timeout)
    return value or validate_output(action.get_stdout())


def wait_for_output_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Validate,
    timeout: float | None = None,
) -> Any:
    """Wait until `validate_output(stdout)` is true; return its last value. The action needs `cached_output=True`.

    Raises:
        AssertionError: from `validate_output`, if it still raises one after `timeout` seconds.
    """
    action = execute_process_action
    value = _wait_sync(launch_context, action, _on_stdout, _value(validate_output, action.get_stdout), timeout)
    return value or validate_output(action.get_stdout())


async def assert_output(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """Wait until `validate_output(stdout)` does not raise AssertionError; after the timeout, propagate its error."""
    action = execute_process_action
    if not await _wait(launch_context, action, _on_stdout, _asserted(validate_output, action.get_stdout), timeout):
        validate_output(action.get_stdout())


def assert_output_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """Wait until `validate_output(stdout)` does not raise AssertionError; after the timeout, propagate its error."""
    action = execute_process_action
    if not _wait_sync(launch_context, action, _on_stdout, _asserted(validate_output, action.get_stdout), timeout):
        validate_output(action.get_stdout())


async def wait_for_stderr(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Validate,
    timeout: float | None = None,
) -> Any:
    """Wait until `validate_output(stderr)` is true; return its last value. The action needs `cached_output=True`.

    Raises:
        AssertionError: from `validate_output`, if it still raises one after `timeout` seconds.
    """
    action = execute_process_action
    value = await _wait(launch_context, action, _on_stderr, _value(validate_output, action.get_stderr), timeout)
    return value or validate_output(action.get_stderr())


def wait_for_stderr_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Validate,
    timeout: float | None = None,
) -> Any:
    """Wait until `validate_output(stderr)` is true; return its last value. The action needs `cached_output=True`.

    Raises:
        AssertionError: from `validate_output`, if it still raises one after `timeout` seconds.
    """
    action = execute_process_action
    value = _wait_sync(launch_context, action, _on_stderr, _value(validate_output, action.get_stderr), timeout)
    return value or validate_output(action.get_stderr())


async def assert_stderr(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """Wait until `validate_output(stderr)` does not raise AssertionError; after the timeout, propagate its error."""
    action = execute_process_action
    if not await _wait(launch_context, action, _on_stderr, _asserted(validate_output, action.get_stderr), timeout):
        validate_output(action.get_stderr())


def assert_stderr_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteLocal,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """Wait until `validate_output(stderr)` does not raise AssertionError; after the timeout, propagate its error."""
    action = execute_process_action
    if not _wait_sync(launch_context, action, _on_stderr, _asserted(validate_output, action.get_stderr), timeout):
        validate_output(action.get_stderr())


def _has_started(action: ExecuteLocal) -> Condition:
    return lambda: action.process_details is not None and bool(action.process_details.get("pid"))


def _has_ended(action: ExecuteLocal) -> Condition:
    return lambda: action.return_code is not None


async def wait_for_start(
    launch_context: LaunchContext, execute_process_action: ExecuteLocal, timeout: float | None = None
) -> bool:
    """Wait until the process has started, at most `timeout` seconds; return whether it has."""
    action = execute_process_action
    return bool(await _wait(launch_context, action, _on_start, _has_started(action), timeout))


def wait_for_start_sync(
    launch_context: LaunchContext, execute_process_action: ExecuteLocal, timeout: float | None = None
) -> bool:
    """Wait until the process has started, at most `timeout` seconds; return whether it has."""
    action = execute_process_action
    return bool(_wait_sync(launch_context, action, _on_start, _has_started(action), timeout))


async def wait_for_exit(
    launch_context: LaunchContext, execute_process_action: ExecuteLocal, timeout: float | None = None
) -> bool:
    """Wait until the process has ended, at most `timeout` seconds; return whether it has."""
    action = execute_process_action
    return bool(await _wait(launch_context, action, _on_exit, _has_ended(action), timeout))


def wait_for_exit_sync(
    launch_context: LaunchContext, execute_process_action: ExecuteLocal, timeout: float | None = None
) -> bool:
    """Wait until the process has ended, at most `timeout` seconds; return whether it has."""
    action = execute_process_action
    return bool(_wait_sync(launch_context, action, _on_exit, _has_ended(action), timeout))
