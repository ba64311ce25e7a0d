"""The output of the launched processes."""

from __future__ import annotations

import threading
from collections.abc import Callable, Collection, Iterator
from typing import Any

from launch.actions import ExecuteLocal
from launch.events.process import ProcessIO

from .asserts.assert_output import assertInStream
from .util import NoMatchingProcessException, resolveProcesses


class IoHandler:
    """The output of all processes in order of arrival, and the output of each process."""

    def __init__(self) -> None:
        self._all: list[ProcessIO] = []
        self._by_name: dict[str, list[ProcessIO]] = {}

    def track(self, process_name: str) -> None:
        """Register a process that has not printed anything yet."""
        self._by_name.setdefault(process_name, [])

    def append(self, process_io: ProcessIO) -> None:
        """Store a piece of output."""
        self._all.append(process_io)
        self._by_name.setdefault(process_io.process_name, []).append(process_io)

    def __iter__(self) -> Iterator[ProcessIO]:
        return iter(self._all)

    def processes(self) -> list[ExecuteLocal]:
        """Return the processes that have printed something."""
        return [pieces[0].action for pieces in self._by_name.values() if pieces]

    def process_names(self) -> Collection[str]:
        """Return the names of all known processes."""
        return self._by_name.keys()

    def __getitem__(self, key: str | ExecuteLocal) -> list[ProcessIO]:
        """The output of a process, given by its name or its action; raises KeyError."""
        if isinstance(key, str):
            return list(self._by_name[key])
        if key.process_details is None:
            raise KeyError(key)
        return list(self._by_name[key.process_details["name"]])


class ActiveIoHandler:
    """The output of running processes, with functions that wait for output."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._io_handler = IoHandler()

    @property
    def io_event(self) -> threading.Condition:
        """Notified whenever there is more output."""
        return self._changed

    def track(self, process_name: str) -> None:
        """Register a process that has not printed anything yet."""
        with self._changed:
            self._io_handler.track(process_name)
            self._changed.notify_all()

    def append(self, process_io: ProcessIO) -> None:
        """Store a piece of output, and wake waiting threads."""
        with self._changed:
            self._io_handler.append(process_io)
            self._changed.notify_all()

    def __iter__(self) -> Iterator[ProcessIO]:
        with self._changed:
            return iter(list(self._io_handler))

    def processes(self) -> list[ExecuteLocal]:
        """Return the processes that have printed something."""
        with self._changed:
            return self._io_handler.processes()

    def process_names(self) -> list[str]:
        """Return the names of all known processes."""
        with self._changed:
            return list(self._io_handler.process_names())

    def __getitem__(self, key: str | ExecuteLocal) -> list[ProcessIO]:
        """The output of a process, given by its name or its action; raises KeyError."""
        with self._changed:
            return self._io_handler[key]

    def assertWaitFor(self, *args: Any, **kwargs: Any) -> None:
        """Wait as `waitFor` does, and fail on a timeout."""
        if not self.waitFor(*args, **kwargs):
            raise AssertionError("Waiting for output timed out")

    def waitFor(
        self,
        expected_output: Any,
        process: Any = None,
        cmd_args: Any = None,
        *,
        strict_proc_matching: bool = True,
        output_filter: Callable[[str], str] | None = None,
        timeout: float | None = 10,
        strip_ansi_escape_sequences: bool = True,
        stream: str = "stderr",
    ) -> bool:
        """Wait for output, at most `timeout` seconds; return whether it came. See `assertInStream`.

        Raises:
            Exception: when the wait timed out and no known process matches.
        """

        def has_come() -> bool:
            try:
                assertInStream(
                    self._io_handler,
                    expected_output,
                    process,
                    cmd_args,
                    output_filter=output_filter,
                    strict_proc_matching=strict_proc_matching,
                    strip_ansi_escape_sequences=strip_ansi_escape_sequences,
                    stream=stream,
                )
            except (NoMatchingProcessException, AssertionError):
                return False
            return True

        with self._changed:
            success = self._changed.wait_for(has_come, timeout)
        if not success:
            self._check_known(process, cmd_args)
        return success

    def _check_known(self, process: Any, cmd_args: Any) -> None:
        """Raise if no known process matches, which explains why the output did not come."""
        resolveProcesses(self, process=process, cmd_args=cmd_args, strict_proc_matching=False)
