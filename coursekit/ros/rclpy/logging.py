"""Loggers and their levels. In ROS 2: rclpy.logging."""

from __future__ import annotations

import os
from pathlib import Path

from coursekit.rcl.arguments import RosArguments
from rclpy.impl.log_file import logging_directory
from rclpy.impl.logging_state import LoggingSeverity as LoggingSeverity
from rclpy.impl.logging_state import logging_state
from rclpy.impl.rcutils_logger import RcutilsLogger

_root_logger = RcutilsLogger()


def get_logger(name: str) -> RcutilsLogger:
    """Return a logger of that name; ValueError for an empty name.

    >>> get_logger("robot").name
    'robot'
    """
    if not name:
        raise ValueError("Logger name must not be empty.")
    return _root_logger.get_child(name)


def initialize() -> None:
    """Initialize logging. Not required: the first message does it."""
    logging_state()


def shutdown() -> None:
    """Shut logging down: reset the levels that were set."""
    logging_state().forget_levels()


def clear_config() -> None:
    """Reset the levels that were set."""
    logging_state().forget_levels()


def configure(arguments: RosArguments) -> None:
    """Apply a command line's logging options, such as `--log-level` and `--disable-stdout-logs`; log its warnings."""
    state = logging_state()
    state.to_console = arguments.stdout_enabled
    state.to_file = arguments.external_lib_enabled
    for name, level in arguments.log_levels.items():
        state.set_level(name or "", level)
    for warning in arguments.warnings:
        RcutilsLogger("rcl").warning(warning)


def set_logger_level(name: str, level: LoggingSeverity | int, detailed_error: bool = False) -> None:
    """Set the level of the named logger; '' sets the default. ValueError for a number that is not a severity."""
    logging_state().set_level(name, LoggingSeverity(level).value)


def get_logger_effective_level(name: str) -> LoggingSeverity:
    """Return the lowest severity that the named logger shows."""
    return LoggingSeverity(logging_state().effective_level(name))


def get_logger_level(name: str) -> LoggingSeverity:
    """Return the level set for the named logger itself, or UNSET if there is none."""
    return LoggingSeverity(logging_state().level(name))


def get_logging_severity_from_string(log_severity: str) -> LoggingSeverity:
    """Return the severity with a name, case-insensitively; RuntimeError for an unknown name.

    >>> get_logging_severity_from_string("warn")
    <LoggingSeverity.WARN: 30>
    """
    try:
        return LoggingSeverity[log_severity.upper()]
    except KeyError:
        known = ", ".join(LoggingSeverity.__members__)
        raise RuntimeError(f"Failed to get severity name: '{log_severity}' is none of {known}") from None


def get_logging_directory() -> Path:
    """Return the folder of log files: ROS_LOG_DIR, else the folder log in ROS_HOME or ~/.ros."""
    return logging_directory(os.environ)
