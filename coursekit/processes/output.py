"""A process's output, and its keyboard input."""

from __future__ import annotations

import io
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .current_process import owner

if TYPE_CHECKING:
    from .session import Session

CTRL_C = "\x03"
OUTPUT_LIMIT = 2_000_000
"""Maximum length of the stored output in characters; older output is dropped and counted."""


class Output:
    """A process's newest `OUTPUT_LIMIT` characters of output, and its listeners."""

    def __init__(self) -> None:
        self._parts: deque[tuple[str, str]] = deque()
        self._size = 0
        self.dropped = 0
        self.listeners: list[Callable[[str, str], None]] = []

    def write(self, stream: str, text: str) -> None:
        """Store `text` and call the listeners, outside of the process: their output is not the process's."""
        self._parts.append((stream, text))
        self._size += len(text)
        while self._size > OUTPUT_LIMIT and len(self._parts) > 1:
            _, old = self._parts.popleft()
            self._size -= len(old)
            self.dropped += len(old)
        if self.listeners:
            token = owner.set(None)
            try:
                for listener in list(self.listeners):
                    listener(stream, text)
            finally:
                owner.reset(token)

    def text(self, stream: str | None = None) -> str:
        """Return all stored output, or that of one stream."""
        return "".join(part for name, part in list(self._parts) if stream in (None, name))


class Input(io.TextIOBase):
    """A process's standard input; reading waits on the session's clock."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._text = ""
        self._closed_by_writer = False
        self._changed = session.clock.new_event()
        self.settings: list[Any] = []
        """The terminal settings made by the program, in termios' format; initially empty."""
        self.by_keys = False
        """Whether it has ever requested single keys."""
        self.ctrl_c_is_a_key = False
        self.blocking = True
        """Whether reading blocks; if not, it returns the available text, possibly none."""

    def fileno(self) -> int:
        return 0

    def take_ctrl_c(self) -> bool:
        """Enter Ctrl-C as a key for a program that reads it; False if it must be a signal, or an earlier one is unread."""
        if not self.ctrl_c_is_a_key or CTRL_C in self._text:
            return False
        self.feed(CTRL_C)
        return True

    def wait_for_keys(self, timeout_sec: float | None) -> bool:
        """Wait until something can be read, at most `timeout_sec` seconds; return whether it can."""
        self._changed.clear()
        if not self._text and not self._closed_by_writer:
            self._changed.wait(timeout_sec)
        return self.has_keys()

    def has_keys(self) -> bool:
        """Return whether something can be read without waiting."""
        return bool(self._text) or self._closed_by_writer

    def feed(self, text: str) -> None:
        self._text += text
        self._changed.set()

    def end(self) -> None:
        self._closed_by_writer = True
        self._changed.set()

    def wake(self) -> None:
        """End the current wait for keys: there is something else to check."""
        self._changed.set()

    def readable(self) -> bool:
        return True

    def readline(self, size: int = -1) -> str:  # type: ignore[override]
        while "\n" not in self._text and not self._closed_by_writer:
            self._wait()
        line, newline, _ = self._text.partition("\n")
        return self._take(len(line) + len(newline), size)

    def read(self, size: int | None = -1) -> str:
        size = -1 if size is None else size
        if not self.blocking:
            self._session.clock.poll()
            return self._take(len(self._text), size)
        while not self._closed_by_writer and (size < 0 or not self._text):
            self._wait()
        return self._take(len(self._text), size)

    def _take(self, count: int, limit: int) -> str:
        count = count if limit is None or limit < 0 else min(count, limit)
        taken, self._text = self._text[:count], self._text[count:]
        return taken

    def _wait(self) -> None:
        self._changed.clear()
        self._changed.wait()
