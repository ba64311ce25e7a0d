"""The logging configuration of a launch: level, folder, files, formats. Every process has its own."""

from __future__ import annotations

import logging
import os
import socket
import sys
import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

from coursekit.processes import session
from coursekit.processes.process import current_process

from . import handlers

NAMED = "[{levelname}] [{name}]: {message}"
STAMPED = "{created:.7f} " + NAMED


class LaunchConfig:
    """The logging state of one launching process."""

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Reset to level INFO, a new folder and default formats."""
        self.level = logging.INFO
        self.loggers: dict[str, Any] = {}
        self.file_handlers: dict[str, Any] = {}
        self.log_handler_factory: Callable[..., Any] = handlers.FileHandler
        self.__log_dir: str | None = None
        self.__screen_handler: handlers.StreamHandler | None = None
        self.set_screen_format("default")
        self.set_log_format("default")

    # -- the folder

    @property
    def log_dir(self) -> str:
        """The folder of this launch's log files; its name is created on first use."""
        if self.__log_dir is None:
            make = sys.modules[__package__]._make_unique_log_dir
            self.__log_dir = str(make(base_path=str(get_logging_directory())))
        return self.__log_dir

    @log_dir.setter
    def log_dir(self, value: str | None) -> None:
        if self.file_handlers:
            warnings.warn(f"Loggers have been configured to output to files below {self.__log_dir} already.", stacklevel=3)
        if value and not os.path.isdir(value):
            raise ValueError(f"{value} is not a directory")
        self.__log_dir = value

    def get_log_file_path(self, file_name: str = "launch.log") -> str:
        """Return the full path of a log file; create the folder."""
        os.makedirs(self.log_dir, exist_ok=True)
        return os.path.join(self.log_dir, file_name)

    # -- the handlers

    def get_log_file_handler(self, file_name: str = "launch.log") -> Any:
        """Return the handler of a log file; there is one per file."""
        if file_name not in self.file_handlers:
            handler = self.log_handler_factory(self.get_log_file_path(file_name))
            handler.setFormatter(self.__file_formatter)
            self.file_handlers[file_name] = handler
        return self.file_handlers[file_name]

    def get_screen_handler(self) -> Any:
        """Return the handler of the screen."""
        if self.__screen_handler is None:
            self.__screen_handler = handlers.StreamHandler()
            self.__screen_handler.setFormatter(self.__screen_formatter)
        return self.__screen_handler

    def set_screen_format(self, screen_format: str, *, screen_style: str | None = None) -> None:
        """Set the screen format: 'default', 'default_with_timestamp', or a format for logging.Formatter.

        The variable OVERRIDE_LAUNCH_SCREEN_FORMAT takes precedence. Raises ValueError for a default format with a style.
        """
        known = {"default": NAMED, "default_with_timestamp": STAMPED}
        self.__screen_formatter = _formatter("OVERRIDE_LAUNCH_SCREEN_FORMAT", screen_format, screen_style, known)
        if self.__screen_handler is not None:
            self.__screen_handler.setFormatter(self.__screen_formatter)

    def set_log_format(self, log_format: str, *, log_style: str | None = None) -> None:
        """Set the log file format: 'default' or a logging.Formatter format; OVERRIDE_LAUNCH_LOG_FORMAT takes precedence."""
        self.__file_formatter = _formatter("OVERRIDE_LAUNCH_LOG_FORMAT", log_format, log_style, {"default": STAMPED})
        for handler in self.file_handlers.values():
            handler.setFormatter(self.__file_formatter)

    def close(self) -> None:
        """Close all log files."""
        for handler in self.file_handlers.values():
            handler.close()


def _formatter(variable: str, form: str, style: str | None, known: dict[str, str]) -> logging.Formatter:
    override = os.environ.get(variable)
    if override:
        return logging.Formatter(override.encode("latin1").decode("unicode_escape"), style="{")
    if form in known and style is not None:
        raise ValueError(f"Cannot set a custom format style for the '{form}' format.")
    return logging.Formatter(known.get(form, form), style="{" if form in known else style or "%")  # type: ignore[arg-type]


class _CurrentConfig:
    """A proxy of the current process's LaunchConfig."""

    def __getattr__(self, name: str) -> Any:
        return getattr(current_config(), name)

    def __setattr__(self, name: str, value: Any) -> None:
        setattr(current_config(), name, value)


launch_config = _CurrentConfig()
_outside: dict[str, LaunchConfig] = {}
KEY = "launch.logging"


def _store() -> dict[Any, Any]:
    process = current_process()
    return _outside if process is None else process.locals


def current_config() -> LaunchConfig:
    """Return the LaunchConfig of the current process."""
    store = _store()
    if KEY not in store:
        store[KEY] = LaunchConfig()
        process = current_process()
        if process is not None:
            process.cleanups.append(store[KEY].close)
    config: LaunchConfig = store[KEY]
    return config


def reset() -> LaunchConfig:
    """Close the current process's logs and start again with a new folder."""
    current_config().close()
    del _store()[KEY]
    return current_config()


def get_logging_directory() -> Path:
    """Return ROS's folder for logs: ROS_LOG_DIR, else ROS_HOME/log, else ~/.ros/log."""
    if os.environ.get("ROS_LOG_DIR"):
        return Path(os.environ["ROS_LOG_DIR"]).expanduser()
    return Path(os.environ.get("ROS_HOME") or "~/.ros").expanduser() / "log"


def make_unique_log_dir(*, base_path: str) -> str:
    """Return a folder path in `base_path` with date, time, host and process id; the virtual clock makes it reproducible."""
    clock = session.current().clock
    seconds, nanoseconds = divmod(clock.now(), 1_000_000_000)
    moment = time.gmtime(seconds) if clock.virtual else time.localtime(seconds)
    stamp = time.strftime("%Y-%m-%d-%H-%M-%S", moment)
    process = current_process()
    pid = process.pid if process is not None else 0 if clock.virtual else os.getpid()
    host = "localhost" if clock.virtual else socket.gethostname()
    return os.path.join(base_path, f"{stamp}-{nanoseconds // 1000:06d}-{host}-{pid}")


def shown_log_dir() -> str:
    """Return the log folder in its printed form: on the virtual clock, with ~ for the home folder."""
    folder = current_config().log_dir
    home = str(Path.home())
    if session.current().clock.virtual and folder.startswith(home + os.sep):
        return "~" + folder[len(home) :]
    return folder


def log_launch_config(*, logger: logging.Logger = logging.root) -> None:
    """Tell where the log files are, once there are any, and the level."""
    config = current_config()
    if config.file_handlers:
        logger.info(f"All log files can be found below {shown_log_dir()}")
    logger.info(f"Default logging verbosity is set to {logging.getLevelName(config.level)}")
