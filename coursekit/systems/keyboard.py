"""The keyboard of a terminal, which belongs to the job in its foreground: a job in the background waits for its turn.

On Windows it is the console's: a key that a terminal of Linux sends as several bytes comes as these bytes.
"""

from __future__ import annotations

import errno
import os
import signal
import sys
import threading
import time
from types import TracebackType
from typing import Any

from . import console

try:
    import termios
    import tty
except ImportError:  # Windows
    termios = tty = None  # type: ignore[assignment]

TURN_SECONDS = 0.2
"""A job in the background looks so often whether it was brought to the front."""
KEY_SECONDS = 0.01
"""Windows' console is looked at so often: a read could not be ended, once a program wants keys instead of lines."""
_JOB_SIGNALS = [getattr(signal, name) for name in ("SIGTTIN", "SIGTTOU") if hasattr(signal, name)]


class Keyboard:
    """Standard input. After `want_keys` each key is passed on at once, without echo; at the end it is as it was.

    Without this a job that is started with `&` is "Stopped": the system stops who reads or sets a terminal from behind.
    """

    def __init__(self) -> None:
        self._number = sys.stdin.fileno()
        self._is_terminal = termios is not None and os.isatty(self._number)
        self._is_console = console.is_there(self._number)
        self._wants_keys = False
        self._before: Any = None
        self._handlers: dict[Any, Any] = {}
        self._lock = threading.Lock()

    def __enter__(self) -> Keyboard:
        if self._is_terminal:
            self._handlers = {number: signal.signal(number, signal.SIG_IGN) for number in _JOB_SIGNALS}
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        with self._lock:
            self._wants_keys = False
            if self._before is not None and self.in_front():
                termios.tcsetattr(self._number, termios.TCSADRAIN, self._before)
            for number, handler in self._handlers.items():
                signal.signal(number, handler)

    def in_front(self) -> bool:
        """Whether what is typed is for us."""
        try:
            return self._is_terminal and os.tcgetpgrp(self._number) == os.getpgrp()
        except OSError:
            return False

    def want_keys(self) -> None:
        """Pass each key on from now on, or as soon as we are in front."""
        self._wants_keys = True
        self._set()

    def _set(self) -> None:
        with self._lock:
            if self._wants_keys and self._before is None and self.in_front():
                self._before = termios.tcgetattr(self._number)
                tty.setcbreak(self._number)

    def read(self) -> bytes:
        """The typed characters, empty at the end; in the background it waits."""
        while True:
            self._set()
            if self._is_console and (key := self._key_of_console()):
                return key
            try:
                return os.read(self._number, 4096)
            except OSError as error:
                if error.errno != errno.EIO or not self._is_terminal or self.in_front() or not _has_shell(self._number):
                    raise
            time.sleep(TURN_SECONDS)


    def _key_of_console(self) -> bytes:
        """The next key; nothing when a line is being typed, which is then to be read."""
        while True:
            while not console.has_key():
                time.sleep(KEY_SECONDS)
            if not self._wants_keys:
                return b""
            if key := console.key():
                return key.encode()


def _has_shell(number: int) -> bool:
    """Whether the terminal is still there: one that was closed has no job in front."""
    try:
        return os.tcgetpgrp(number) > 0
    except OSError:
        return False


__all__ = ["Keyboard"]
