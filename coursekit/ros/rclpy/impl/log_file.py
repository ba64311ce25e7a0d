"""The log file of one program. In ROS 2: rcl_logging_spdlog."""

from __future__ import annotations

import os
import re
import time
from collections.abc import Mapping
from pathlib import Path

_NO_FILE_NAME = re.compile(r"[^\w.+-]")


def logging_directory(environ: Mapping[str, str]) -> Path:
    """The folder of log files: ROS_LOG_DIR, else the folder log in ROS_HOME or in ~/.ros.

    >>> logging_directory({"ROS_HOME": "/tmp/ros"}).as_posix()
    '/tmp/ros/log'
    """
    if named := environ.get("ROS_LOG_DIR"):
        return Path(named).expanduser()
    home = environ.get("ROS_HOME")
    return (Path(home).expanduser() if home else Path.home() / ".ros") / "log"


class LogFile:
    """Appends lines to PROGRAM_PID_MILLISECONDS.log; the first line creates the folder and the file.

    The file is closed between lines: a session of many programs keeps none of their files open. If the folder is not
    writable, there is no log file, but the program continues.
    """

    def __init__(self, environ: Mapping[str, str], program: str, pid: int) -> None:
        self._folder = logging_directory(environ)
        self._name = f"{_NO_FILE_NAME.sub('_', program)[:100]}_{pid}_{time.time_ns() // 1_000_000}.log"
        self._path: Path | None = None
        self._lost = False

    def append(self, line: str) -> None:
        """Add a line, with its line break."""
        if self._lost:
            return
        try:
            begins = os.O_TRUNC if self._path is None else 0  # on the virtual clock each run has the same file names
            if self._path is None:
                self._folder.mkdir(parents=True, exist_ok=True)
                self._path = self._folder / self._name
            file = os.open(self._path, os.O_WRONLY | os.O_APPEND | os.O_CREAT | begins, 0o644)
            try:
                os.write(file, line.encode("utf-8", "backslashreplace"))
            finally:
                os.close(file)
        except OSError:
            self._lost = True
