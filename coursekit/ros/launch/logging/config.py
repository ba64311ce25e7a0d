"""Where a launch logs to: the level, the folder and its files. Every process has its own."""

from __future__ import annotations

import logging
import os
import socket
import time
from pathlib import Path
from typing import Any

from coursekit.core import session
from coursekit.core.process import current_process


class LaunchConfig:
    """The logging state of one process that launches."""

    def __init__(self) -> None:
        self.level = logging.INFO
        self.loggers: dict[str, Any] = {}
        self.files: dict[str, logging.Handler] = {}
        self.__log_dir: str | None = None

    @property
    def log_dir(self) -> str:
        """The folder of this launch's log files; its name is made on first use."""
        if self.__log_dir is None:
            self.__log_dir = str(logging_directory() / _folder_name())
        return self.__log_dir

    @log_dir.setter
    def log_dir(self, value: str) -> None:
        if self.files:
            raise RuntimeError("cannot set log directory after loggers have been created")
        self.__log_dir = str(value)

    def get_log_file_path(self, file_name: str = "launch.log") -> str:
        """Return the full path of a log file; makes the folder."""
        os.makedirs(self.log_dir, exist_ok=True)
        return os.path.join(self.log_dir, file_name)

    def close(self) -> None:
        """Close all log files."""
        for handler in self.files.values():
            handler.close()


class _CurrentConfig:
    """Stands for the current process's LaunchConfig."""

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
    """Close the current process's logs and begin anew, with a new folder."""
    current_config().close()
    del _store()[KEY]
    return current_config()


def logging_directory() -> Path:
    """Return ROS's folder for logs: ROS_LOG_DIR, else ROS_HOME/log, else ~/.ros/log."""
    if os.environ.get("ROS_LOG_DIR"):
        return Path(os.environ["ROS_LOG_DIR"]).expanduser()
    return Path(os.environ.get("ROS_HOME") or "~/.ros").expanduser() / "log"


def _folder_name() -> str:
    """Return date, time, host and process id; on the virtual clock the same in every run."""
    clock = session.current().clock
    seconds, nanoseconds = divmod(clock.now(), 1_000_000_000)
    moment = time.gmtime(seconds) if clock.virtual else time.localtime(seconds)
    stamp = time.strftime("%Y-%m-%d-%H-%M-%S", moment)
    process = current_process()
    pid = process.pid if process is not None else 0 if clock.virtual else os.getpid()
    host = "localhost" if clock.virtual else socket.gethostname()
    return f"{stamp}-{nanoseconds // 1000:06d}-{host}-{pid}"


def shown_log_dir() -> str:
    """Return the log folder as it is printed: on the virtual clock with ~ for the home folder."""
    folder = current_config().log_dir
    home = str(Path.home())
    if session.current().clock.virtual and folder.startswith(home + os.sep):
        return "~" + folder[len(home) :]
    return folder
