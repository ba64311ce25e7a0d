"""Loggers. In ROS 2: rclpy.impl.rcutils_logger."""

from __future__ import annotations

import sys
from types import FrameType
from typing import Any

from coursekit.processes import session
from rclpy.impl.log_filters import FILTERS, get_filters_from_kwargs
from rclpy.impl.logging_state import Listener, LoggingSeverity, logging_state


def add_rosout(name: str, callback: Listener) -> None:
    """Call `callback` with every message that the logger `name` and its children let through."""
    logging_state().listeners[name] = callback


def remove_rosout(name: str) -> None:
    """Remove the callback of the logger `name`."""
    logging_state().listeners.pop(name, None)


_SHOWN = 60
"""The number of characters of a wrong message that its error repeats."""


class _CallSite:
    """The logging options of a line of code at its first call; later calls must agree with them."""

    __slots__ = ("code", "filters", "name", "severity", "states")

    def __init__(self, code: Any, severity: int, name: str, options: dict[str, Any]) -> None:
        self.code = code  # kept alive: no other code object may get its id
        self.severity = severity
        self.name = name
        self.filters = get_filters_from_kwargs(**options) if options else []
        self.states = [FILTERS[each](options) for each in self.filters]

    def check(self, severity: int, name: str, options: dict[str, Any]) -> None:
        if self.severity != severity:
            raise ValueError("Logger severity cannot be changed between calls.")
        if self.name != name:
            raise ValueError("Logger name cannot be changed between calls.")
        if not options and not self.filters:
            return
        if get_filters_from_kwargs(**options) != self.filters:
            raise ValueError("Requested logging filters cannot be changed between calls.")
        if not all(state.agrees(options) for state in self.states):
            raise ValueError("Logging filter parameters cannot be changed between calls.")

    def lets_through(self) -> bool:
        return all(state.lets_through() for state in self.states)


class RcutilsLogger:
    """A named logger; the part of the name before the last dot is its parent.

    Every call takes the options `once`, `skip_first`, `throttle_duration_sec` (seconds) with
    `throttle_time_source_type` (a Clock), `name`. Calls return whether the message was logged.

    >>> RcutilsLogger("robot").get_child("arm").name
    'robot.arm'
    """

    def __init__(self, name: str = "") -> None:
        self.name = name
        self.contexts: dict[tuple[int, int], _CallSite] = {}
        self._rosout_name = name

    def get_child(self, name: str) -> RcutilsLogger:
        """Return the logger `self.name.name`; ValueError for an empty name."""
        if not name:
            raise ValueError("Child logger name must not be empty.")
        child = RcutilsLogger(f"{self.name}.{name}" if self.name else name)
        child._rosout_name = self._rosout_name or child.name
        return child

    def set_level(self, level: LoggingSeverity | int) -> None:
        """Show messages of this severity and above; ValueError for a number that is not a severity.

        >>> logger = RcutilsLogger("quiet")
        >>> logger.set_level(40)
        >>> logger.get_effective_level().name
        'ERROR'
        """
        logging_state().set_level(self.name, LoggingSeverity(level).value)

    def get_effective_level(self) -> LoggingSeverity:
        """Return the lowest severity that is shown."""
        return LoggingSeverity(logging_state().effective_level(self.name))

    def is_enabled_for(self, severity: LoggingSeverity | int) -> bool:
        """Return whether messages of the severity are shown."""
        return LoggingSeverity(severity).value >= logging_state().effective_level(self.name)

    def log(self, message: str, severity: LoggingSeverity | int, **kwargs: Any) -> bool:
        """Log with the severity; ValueError if it is invalid, or if a line of code changes its severity, name or filters."""
        return self._log(message, LoggingSeverity(severity).value, kwargs)

    def debug(self, message: str, **kwargs: Any) -> bool:
        """Log a message that only helps to find errors."""
        return self._log(message, 10, kwargs)

    def info(self, message: str, **kwargs: Any) -> bool:
        """Log a message about normal operation.

        >>> shown = node.get_logger().info("ready", once=True)
        """
        return self._log(message, 20, kwargs)

    def warning(self, message: str, **kwargs: Any) -> bool:
        """Log a warning about something that may go wrong."""
        return self._log(message, 30, kwargs)

    def warn(self, message: str, **kwargs: Any) -> bool:
        """Same as `warning`."""
        return self._log(message, 30, kwargs)

    def error(self, message: str, **kwargs: Any) -> bool:
        """Log an error."""
        return self._log(message, 40, kwargs)

    def fatal(self, message: str, **kwargs: Any) -> bool:
        """Log an error that ends the program."""
        return self._log(message, 50, kwargs)

    def _log(self, message: str, severity: int, options: dict[str, Any]) -> bool:
        if "severity" in options:
            raise TypeError("RcutilsLogger.log() got multiple values for argument 'severity'")
        state = logging_state()
        name = options.pop("name", self.name) if options else self.name
        if severity < state.effective_level(name) or not severity:
            return False
        frame = _caller()
        if not self._passes(frame, severity, name, options):
            return False
        code = frame.f_code
        caller = (code.co_filename, code.co_name, frame.f_lineno)
        stamp = session.current().clock.now()
        text = _as_text(message)
        state.write(severity, name, text, caller, stamp)
        listener = state.listeners.get(self._rosout_name)
        if listener is not None:
            listener(severity, name, text, *caller, stamp)
        return True

    def _passes(self, frame: FrameType, severity: int, name: str, options: dict[str, Any]) -> bool:
        """Whether the filters of the current line of `frame` let the message through; ValueError if its options changed."""
        key = (id(frame.f_code), frame.f_lasti)
        site = self.contexts.get(key)
        if site is None:
            site = self.contexts[key] = _CallSite(frame.f_code, severity, name, options)
        else:
            site.check(severity, name, options)
        return site.lets_through() if site.states else True


def _as_text(message: Any) -> str:
    """The text to log. rclpy's C code takes text only: a number that worked here would fail on a robot."""
    if isinstance(message, str):
        return str(message)
    if message is None:
        return "(null)"
    if isinstance(message, bytes):
        return message.decode(errors="replace")
    shown, kind = repr(message), type(message).__name__
    shown = shown if len(shown) <= _SHOWN else f"{shown[:_SHOWN]}..."
    raise TypeError(
        "rclpy_logging_rcutils_log(): incompatible function arguments. "
        f"A logger takes text, and {shown} is of type {kind}. Write f'{{...}}' or str(...) around it."
    )


def _caller() -> FrameType:
    """The nearest frame outside this file."""
    frame = sys._getframe(3)
    while frame.f_back is not None and frame.f_code.co_filename == __file__:
        frame = frame.f_back
    return frame
