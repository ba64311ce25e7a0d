"""The logging of one process: levels, outputs, and listeners for /rosout."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable
from datetime import datetime
from enum import IntEnum
from typing import Any, TextIO

from coursekit.processes.process import Process, current_process
from coursekit.processes.session import locals_here
from rclpy.impl.log_file import LogFile


class LoggingSeverity(IntEnum):
    """The severity of a message; UNSET means the parent logger's level."""

    UNSET = 0
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


Listener = Callable[[int, str, str, str, str, int, int], None]
"""Called with level, logger name, text, file, function, line, and stamp in nanoseconds."""

DEFAULT_FORMAT = "[{severity}] [{time}] [{name}]: {message}"
_TOKEN = re.compile(r"\{([a-z_]+)\}")
_COLOURS = {10: "\033[32m", 20: "\033[0m", 30: "\033[33m", 40: "\033[31m", 50: "\033[31m"}
_NAMES = {level.value: level.name for level in LoggingSeverity}


class LoggingState:
    """The levels and outputs of one process, read from its environment at its first log message.

    >>> state = LoggingState({})
    >>> state.set_level("a", 30)
    >>> state.effective_level("a.b"), state.effective_level("c")
    (30, 20)
    """

    def __init__(self, environ: Any, program: str = "python", pid: int | None = None) -> None:
        self.listeners: dict[str, Listener] = {}
        self.to_console = True
        self.to_file = True
        self._file = LogFile(environ, program, os.getpid() if pid is None else pid)
        self._levels: dict[str, int] = {"": LoggingSeverity.INFO.value}
        self._effective: dict[str, int] = {}
        self._to_stdout = environ.get("RCUTILS_LOGGING_USE_STDOUT") == "1"
        self._colour = environ.get("RCUTILS_COLORIZED_OUTPUT") == "1"
        self._format = _unescaped(environ.get("RCUTILS_CONSOLE_OUTPUT_FORMAT") or DEFAULT_FORMAT)

    def set_level(self, name: str, level: int) -> None:
        """Set the level of a logger and of those below it that have none; '' means all loggers.

        UNSET removes the level; for '' it lets everything through.
        """
        self._effective.clear()
        if level or not name:
            self._levels[name] = level
        else:
            self._levels.pop(name, None)

    def level(self, name: str) -> int:
        """Return the level set for the logger itself, or UNSET if there is none."""
        return self._levels.get(name, 0)

    def effective_level(self, name: str) -> int:
        """Return the logger's own level, or that of its nearest parent."""
        try:
            return self._effective[name]
        except KeyError:
            known = name
            while known and known not in self._levels:
                known = known.rpartition(".")[0]
            self._effective[name] = self._levels[known]
            return self._effective[name]

    def levels_of(self, other: LoggingState) -> None:
        """Share the levels of another state from now on."""
        self._levels, self._effective = other._levels, other._effective

    def forget_levels(self) -> None:
        """Reset every logger to INFO."""
        self._levels = {"": LoggingSeverity.INFO.value}
        self._effective.clear()

    def write(self, level: int, name: str, text: str, caller: tuple[str, str, int], stamp: int) -> None:
        """Write one line to the console and the file; `caller` is file, function and line, `stamp` ns since the epoch."""
        if not (self.to_console or self.to_file):
            return
        if self._format == DEFAULT_FORMAT:
            line = f"[{_NAMES[level]}] [{_seconds(stamp)}] [{name}]: {text}\n"
        else:
            line = _formatted(self._format, level, name, text, caller, stamp) + "\n"
        if self.to_file:
            self._file.append(line)
        if not self.to_console:
            return
        if self._colour:
            line = f"{_COLOURS[level]}{line[:-1]}\033[0m\n"
        stream: TextIO = sys.stdout if self._to_stdout else sys.stderr
        stream.write(line)


def _seconds(stamp: int) -> str:
    seconds, nanoseconds = divmod(stamp, 1_000_000_000)
    return f"{seconds}.{nanoseconds:09d}"


def _unescaped(text: str) -> str:
    return text.replace("\\n", "\n").replace("\\t", "\t").replace("\\r", "\r")


def _formatted(
    pattern: str, level: int, name: str, text: str, caller: tuple[str, str, int], stamp: int
) -> str:
    values = dict(zip(("file_name", "function_name", "line_number"), map(str, caller), strict=True))
    values |= {"severity": _NAMES[level], "name": name, "message": text, "time": _seconds(stamp)}
    values["time_as_nanoseconds"] = str(stamp)
    values["date_time_with_ms"] = datetime.fromtimestamp(stamp / 1e9).strftime("%Y-%m-%d %H:%M:%S.%f")[:-3]
    return _TOKEN.sub(lambda match: values.get(match[1], match[0]), pattern)


_KEY = "rclpy.logging"


def logging_state() -> LoggingState:
    """Return the state of the current process, or of the session for the interpreter's own code."""
    kept = locals_here()
    state: LoggingState | None = kept.get(_KEY)
    if state is None:
        process = current_process()
        own = (process.name, process.pid) if process is not None else ()
        state = kept[_KEY] = LoggingState(os.environ, *own)
    return state


def share_levels(part: Process) -> None:
    """Share the running program's logger levels with `part`, a part of it, as nodes of one process share them."""
    state = part.locals[_KEY] = LoggingState(os.environ, part.name, part.pid)
    state.levels_of(logging_state())
