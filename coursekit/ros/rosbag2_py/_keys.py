"""Keys that control a recorder or a player, and Ctrl-C."""

from __future__ import annotations

import contextlib
import signal
import sys
from collections.abc import Callable, Iterator
from typing import Any

from coursekit.processes.process import current_process
from coursekit.processes.session import current

SPACE, RIGHT, UP, DOWN = " ", "\x1b[C", "\x1b[A", "\x1b[B"
NAMES = {SPACE: "SPACE", RIGHT: "CURSOR_RIGHT", UP: "CURSOR_UP", DOWN: "CURSOR_DOWN"}
"""rosbag2's names of the keys."""
_CTRL_C = "\x03"


class Keyboard:
    """Reads the keys typed to the process in the background until `stop()`, and calls `press(key)` for each."""

    def __init__(self, press: Callable[[str], None], interrupt: Callable[[], None]) -> None:
        self._press = press
        self._interrupt = interrupt
        self._stopped = False

    def start(self) -> None:
        """Start reading. A program that is not a process of a session has no keyboard of its own."""
        process = current_process()
        if process is not None:
            process.want_keys()
            current().spawn(self._read)

    def stop(self) -> None:
        """Ignore keys from now on."""
        self._stopped = True

    def _read(self) -> None:
        typed = ""
        while not self._stopped and (letter := sys.stdin.read(1)):
            typed += letter
            if letter == _CTRL_C:
                self._interrupt()
            elif any(key.startswith(typed) and key != typed for key in NAMES):
                continue
            elif typed in NAMES and not self._stopped:
                self._press(typed)
            typed = ""


@contextlib.contextmanager
def until_told_to_end(end: Callable[[], Any]) -> Iterator[None]:
    """Make Ctrl-C and `kill` call `end()` instead of aborting."""
    previous: dict[signal.Signals, Any] = {}
    try:
        for signum in (signal.SIGINT, signal.SIGTERM):
            previous[signum] = signal.signal(signum, lambda *_: end())
    except ValueError:  # not the main thread: signals are handled elsewhere
        pass
    try:
        yield
    finally:
        for signum, handler in previous.items():
            signal.signal(signum, handler)
