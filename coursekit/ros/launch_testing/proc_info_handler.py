"""The started processes, and their exit codes."""

from __future__ import annotations

import threading
from collections.abc import Callable, Collection, Iterator
from typing import Any

from launch.actions import ExecuteLocal
from launch.events.process import ProcessExited

from .util import NoMatchingProcessException, resolveProcesses


class ProcInfoHandler:
    """The latest event of each process: ProcessStarted or ProcessExited."""

    def __init__(self) -> None:
        self._info: dict[ExecuteLocal, Any] = {}

    def append(self, process_info: Any) -> None:
        """Store an event."""
        self._info[process_info.action] = process_info

    def __iter__(self) -> Iterator[Any]:
        return iter(list(self._info.values()))

    def processes(self) -> Collection[ExecuteLocal]:
        """Return the actions of all processes."""
        return self._info.keys()

    def process_names(self) -> list[str]:
        """Return the names of all processes."""
        return [info.process_name for info in self._info.values()]

    def __getitem__(self, key: str | ExecuteLocal) -> Any:
        """The event of a process, given by its action or a part of its name; raises KeyError."""
        if not isinstance(key, str):
            return self._info[key]
        for info in self._info.values():
            if key in info.process_name:
                return info
        raise KeyError(key)


class ActiveProcInfoHandler:
    """The events of running processes, with functions that wait for their start and end."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._proc_info_handler = ProcInfoHandler()

    @property
    def proc_event(self) -> threading.Condition:
        """Notified whenever a process has started or ended."""
        return self._changed

    def append(self, process_info: Any) -> None:
        """Store an event, and wake waiting threads."""
        with self._changed:
            self._proc_info_handler.append(process_info)
            self._changed.notify_all()

    def __iter__(self) -> Iterator[Any]:
        with self._changed:
            return iter(self._proc_info_handler)

    def processes(self) -> list[ExecuteLocal]:
        """Return the actions of all processes."""
        with self._changed:
            return list(self._proc_info_handler.processes())

    def process_names(self) -> list[str]:
        """Return the names of all processes."""
        with self._changed:
            return self._proc_info_handler.process_names()

    def __getitem__(self, key: str | ExecuteLocal) -> Any:
        """The event of a process, given by its action or a part of its name; raises KeyError."""
        with self._changed:
            return self._proc_info_handler[key]

    def assertWaitForShutdown(self, process: Any, cmd_args: Any = None, *, timeout: float | None = 10) -> None:
        """Wait until a process has ended; fail after `timeout` seconds."""
        if not self._wait(process, cmd_args, timeout, lambda info: isinstance(info, ProcessExited)):
            raise AssertionError(f"Timed out waiting for process '{process}' to finish")

    def assertWaitForStartup(self, process: Any, cmd_args: Any = None, *, timeout: float | None = 10) -> None:
        """Wait until a process has started; fail after `timeout` seconds."""
        if not self._wait(process, cmd_args, timeout, lambda info: True):
            raise AssertionError(f"Timed out waiting for process '{process}' to start")

    def _wait(self, process: Any, cmd_args: Any, timeout: float | None, wanted: Callable[[Any], bool]) -> bool:
        known = self._proc_info_handler

        def is_so() -> bool:
            try:
                action = resolveProcesses(known, process=process, cmd_args=cmd_args)[0]
            except NoMatchingProcessException:
                return False
            return wanted(known[action])

        with self._changed:
            return self._changed.wait_for(is_so, timeout)
