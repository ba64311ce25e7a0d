"""One run of a program from start to end, reported as log lines and events."""

from __future__ import annotations

import asyncio
import contextvars
import logging
import traceback
from collections import deque
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from .events.process import ProcessExited, ProcessIO, ProcessStarted, ProcessStderr, ProcessStdout
from .logging import LaunchLogger
from .process_output import ProcessOutput
from .process_starter import start_process
from .temporary_files import temporary_files
from .utilities.futures import failed_future

if TYPE_CHECKING:
    from .launch_context import LaunchContext


class ProcessRun:
    """Starts a command and monitors it; `details` are the arguments of its events, with the pid once it is known.

    `options` are `shell` and `tty` for `start_process`.
    """

    def __init__(
        self, context: LaunchContext, details: dict[str, Any], lines: ProcessOutput, logger: LaunchLogger, **options: bool
    ) -> None:
        assert context.asyncio_loop is not None
        self.__context = context
        self.__details = details
        self.__options = options
        self.__logger = logger
        self.__lines = lines
        self.__here = contextvars.copy_context()  # the launch's context, in which its output is printed
        self.__loop = context.asyncio_loop
        self.__ended: asyncio.Future[int] = self.__loop.create_future()
        self.__pieces: deque[tuple[str, str]] = deque()
        self.__emits = False
        self.process: Any = None

    def start(self) -> bool:
        """Start the process; log an error and return False if that fails."""
        self.__details["pid"] = 0
        try:
            self.process = start_process(
                self.__details["cmd"],
                cwd=self.__details["cwd"],
                env=self.__details["env"],
                on_output=self.__on_output,
                **self.__options,
            )
        except Exception:
            self.__logger.error(f"exception occurred while executing process:\n{traceback.format_exc()}")
            return False
        self.__details["pid"] = self.process.pid
        self.__logger.info(f"process started with pid [{self.process.pid}]")
        self.__context._launched_processes.append(self.process)
        self.__context.emit_event_sync(ProcessStarted(**self.__details))
        self.process.on_exit(self.__on_end)
        return True

    def __on_output(self, stream: str, text: str) -> None:
        """Pass output on to the loop; this is called in the process's own execution context."""
        self.__pieces.append((stream, text))
        if not self.__emits:
            self.__emits = True
            self.__loop.call_soon_threadsafe(self.__emit_output, context=self.__here)

    def __emit_output(self) -> None:
        """Emit all output since the last call at once, like the content of a pipe."""
        self.__emits = False  # first: later output triggers another call
        pieces = [self.__pieces.popleft() for _ in range(len(self.__pieces))]
        for stream, group in groupby(pieces, itemgetter(0)):
            kind = ProcessStdout if stream == "stdout" else ProcessStderr
            text = "".join([piece for _, piece in group]).encode("utf-8", "replace")
            if not self.__is_only_logged(kind):
                self.__context.emit_event_sync(kind(text=text, **self.__details))
                continue
            try:
                self.__lines.write(stream, text.decode())
            except Exception as error:  # for example a format with an unknown field
                self.__context.add_completion_future(failed_future(self.__loop, error))

    def __is_only_logged(self, kind: type[ProcessIO]) -> bool:
        """Whether only the action itself handles such an event, and no debug log shows it: then none is emitted."""
        context = self.__context
        alone = len(context._handlers_of(kind, self.__details["action"])) == 1 and context._event_queue.empty()
        return alone and not self.__logger.isEnabledFor(logging.DEBUG)

    def __on_end(self, process: Any) -> None:
        self.__loop.call_soon_threadsafe(self.__ended.set_result, process.exit_code)

    async def to_end(self) -> None:
        """Wait for the end of the process, then report it after all its output."""
        code = await self.__ended
        await self.__events_handled()
        self.__context._launched_processes.remove(self.process)
        if code == 0:
            self.__logger.info(f"process has finished cleanly [pid {self.process.pid}]")
        else:
            command = command_line(self.__details["cmd"])
            self.__logger.error(
                f"process has died [pid {self.process.pid}, exit code {code}, cmd '{command}']."
            )
        self.__context.emit_event_sync(ProcessExited(returncode=code, **self.__details))

    async def __events_handled(self) -> None:
        """Wait until the output before the end has been logged; do not wait for a flood of events."""
        for _ in range(10):
            if self.__context._event_queue.empty():
                return
            await asyncio.sleep(0)


def command_line(cmd: list[str]) -> str:
    """Return a command in the form used in messages.

    >>> command_line(['ros2', ' ', 'run'])
    'ros2 run'
    """
    return temporary_files.shown(" ".join(part for part in cmd if part.strip()))
