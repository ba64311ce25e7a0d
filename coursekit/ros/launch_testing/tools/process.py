"""A program that a test starts and ends."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess
from launch.events import IncludeLaunchDescription, matches_action
from launch.events.process import ProcessExited, ProcessStarted, ShutdownProcess
from launch.utilities import ensure_argument_type

from ..io_handler import ActiveIoHandler
from ..proc_info_handler import ActiveProcInfoHandler

OutputFilter = Callable[[str], str]


class ProcessProxy:
    """A test's view of a process: its output, filtered by `output_filter`, and its end."""

    def __init__(
        self,
        process_action: ExecuteProcess,
        proc_info: ActiveProcInfoHandler,
        proc_output: ActiveIoHandler,
        *,
        output_filter: OutputFilter | None = None,
    ) -> None:
        ensure_argument_type(process_action, ExecuteProcess, "process_action")
        ensure_argument_type(proc_info, ActiveProcInfoHandler, "proc_info")
        ensure_argument_type(proc_output, ActiveIoHandler, "proc_output")
        if output_filter is not None and not callable(output_filter):
            raise TypeError(f"Expected 'output_filter' to be callable but got '{output_filter!r}'")
        self._action = process_action
        self._proc_info = proc_info
        self._proc_output = proc_output
        self._filter = output_filter or str

    def wait_for_shutdown(self, timeout: float | None = None) -> bool:
        """Wait until the process ends, at most `timeout` seconds; return whether it has ended."""
        event = self._proc_info.proc_event
        with event:
            return event.wait_for(lambda: self.terminated, timeout)

    def wait_for_output(self, condition: Callable[[str], Any] | None = None, timeout: float | None = None) -> BoolWithText:
        """Wait until the process has started and `condition` holds for its whole output, at most `timeout` seconds.

        Raises:
            TypeError: when the condition is not callable.
        """
        if condition is not None and not callable(condition):
            raise TypeError(f"Expected 'condition' to be callable but got '{condition!r}'")
        seen: list[str] = []

        def holds() -> bool:
            if not (self.running or self.terminated):  # a short process may have ended before this check
                return False
            seen[:] = [self.output]
            return condition is None or bool(condition(seen[0]))

        event = self._proc_output.io_event
        with event:
            return BoolWithText(event.wait_for(holds, timeout), seen[0] if seen else None)

    @property
    def target_process_action(self) -> ExecuteProcess:
        """The action that starts the process."""
        return self._action

    @property
    def stderr(self) -> str:
        """The output to standard error."""
        return self._written(lambda event: event.from_stderr)

    @property
    def stdout(self) -> str:
        """The output to standard output."""
        return self._written(lambda event: event.from_stdout)

    @property
    def output(self) -> str:
        """The output to both streams."""
        return self._written(lambda event: True)

    def _written(self, wanted: Callable[[Any], bool]) -> str:
        events = self._proc_output[self._action]
        return self._filter("".join(event.text.decode() for event in events if wanted(event)))

    @property
    def running(self) -> bool:
        """Whether the process has started and has not ended."""
        return self._is(ProcessStarted)

    @property
    def terminated(self) -> bool:
        """Whether the process has ended."""
        return self._is(ProcessExited)

    def _is(self, kind: type) -> bool:
        known = self._action in self._proc_info.processes()
        return known and isinstance(self._proc_info[self._action], kind)

    @property
    def exit_code(self) -> int:
        """The exit code of the process."""
        code: int = self._proc_info[self._action].returncode
        return code


class BoolWithText:
    """Whether a condition became true. Its text contains the output, which a failed assertion thus shows."""

    def __init__(self, result: bool, output: str | None) -> None:
        self._result = result
        self._output = output

    def __bool__(self) -> bool:
        return self._result

    def __repr__(self) -> str:
        return f"<BoolWithText({self._result}): {self._output!r}>"


@contextmanager
def launch_process(
    launch_service: LaunchService,
    process_action: ExecuteProcess,
    proc_info: ActiveProcInfoHandler,
    proc_output: ActiveIoHandler,
    **kwargs: Any,
) -> Iterator[ProcessProxy]:
    """Start a process in a running launch, and shut it down at the end of the block if it still runs.

    Other arguments are those of `ProcessProxy`.
    """
    ensure_argument_type(process_action, ExecuteProcess, "process_action")
    launch_service.emit_event(IncludeLaunchDescription(LaunchDescription([process_action])))
    proxy = ProcessProxy(process_action, proc_info, proc_output, **kwargs)
    try:
        yield proxy
    finally:
        if not proxy.terminated:
            launch_service.emit_event(ShutdownProcess(process_matcher=matches_action(process_action)))
