"""The keyboard of a terminal, which belongs to the foreground job: a background job waits until it is in front.

On Windows it is the console's: a key that a Linux terminal sends as several bytes is converted to these bytes.
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
"""Interval in which a background job checks whether it is in front [s]."""
KEY_SECONDS = 0.01
"""Polling interval of Windows' console [s]: a blocking read could not end when a program switches from lines to keys."""
_JOB_SIGNALS = [getattr(signal, name) for name in ("SIGTTIN", "SIGTTOU") if hasattr(signal, name)]


class Keyboard:
    """Standard input. After `want_keys` each key is passed on at once, without echo; at exit the settings are restored.

    Without this a job started with `&` is "Stopped": the system stops background jobs that read or configure a terminal.
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
        """Whether this job is in the foreground of the terminal."""
        try:
            return self._is_terminal and os.tcgetpgrp(self._number) == os.getpgrp()
        except OSError:
            return False

    def want_keys(self) -> None:
        """Pass each key on from now on, or as soon as this job is in front."""
        self._wants_keys = True
        self._set()

    def _set(self) -> None:
        with self._lock:
            if self._wants_keys and self._before is None and self.in_front():
                self._before = termios.tcgetattr(self._number)
                tty.setcbreak(self._number)

    def read(self) -> bytes:
        """Return the typed characters, empty at the end; wait while in the background."""
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
        """Return the next key; empty in line mode, when a line must be read instead."""
        while True:
            while not console.has_key():
                time.sleep(KEY_SECONDS)
            if not self._wants_keys:
                return b""
            if key := console.key():
                return key.encode()


def _has_shell(number: int) -> bool:
    """Whether the terminal is still open: a closed one has no foreground job."""
    try:
        return os.tcgetpgrp(number) > 0
    except OSError:
        return False


__all__ = ["Keyboard"]
