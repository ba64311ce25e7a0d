"""Python programs started by path: `python3 node.py` in a terminal or a launch file.

They join the running session of the same user and ROS domain, so that they share its graph, as all programs on a robot
do. If there is none, or under pytest, a debugger or `python -m`, a program has its own session, and its nodes discover
those of other programs (`coursekit.cli.neighbours`). A program that starts other interpreters by multiprocessing also
has its own session: they must be copies of an interpreter that runs nothing else.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from coursekit.systems.folder import working_folder
from coursekit.wiring import JOIN, load

from .current_process import current_process

_PYTHON = re.compile(r"python(3(\.\d+)?)?(\.exe)?")
_USES_ROS = re.compile(rb"^\s*(import|from)\s+(rclpy|tf2_ros|launch|rosbag2_py)\b", re.MULTILINE)
_STARTS_INTERPRETERS = re.compile(rb"^\s*(import|from)\s+multiprocessing\b|\bProcessPoolExecutor\b", re.MULTILINE)
_READ = 1_000_000


def names_python(word: str) -> bool:
    """Whether a word of a command is the Python interpreter.

    >>> names_python("/usr/bin/python3.11"), names_python("plain.py")
    (True, False)
    """
    return _PYTHON.fullmatch(os.path.basename(word)) is not None


def joins() -> Path | None:
    """Return the program for which this interpreter was started, if it should join a session."""
    main = sys.modules.get("__main__")
    path = Path(getattr(main, "__file__", None) or "")
    if getattr(main, "__spec__", None) is not None or path.suffix != ".py" or current_process() is not None:
        return None
    alone = any(os.environ.get(name) for name in ("COURSEKIT_TIME", "COURSEKIT_STOP_AFTER", "COURSEKIT_ALONE"))
    if alone or sys.gettrace() is not None or sys.flags.interactive or Path(sys.prefix) in path.resolve().parents:
        return None
    return None if _STARTS_INTERPRETERS.search(_beginning(path)) else path.resolve()


def join() -> None:
    """Run this interpreter's program in the running session, and exit with its exit code.

    Called when rclpy or rosbag2_py is imported, usually a program's first action; returns if there is no session to
    join.
    """
    path = joins()
    code = None if path is None else load(JOIN)(path, sys.argv[1:])
    if code is not None:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


def of_command(cmd: Sequence[str], folder: str | None) -> tuple[Path, list[str]] | None:
    """Return program and arguments of a command `python3 [-u] FILE.py ...` whose file uses ROS; None for others."""
    if not names_python(cmd[0]):
        return None
    words = [word for at, word in enumerate(cmd[1:]) if not (at == 0 and word == "-u")]
    path = Path(folder or working_folder(), words[0]) if words else Path()
    if path.suffix != ".py" or not path.is_file():
        return None
    text = _beginning(path)
    return (path, words[1:]) if _USES_ROS.search(text) and not _STARTS_INTERPRETERS.search(text) else None


def _beginning(path: Path) -> bytes:
    with open(path, "rb") as file:
        return file.read(_READ)
