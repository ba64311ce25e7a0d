"""The common parts of all processes of a session, whether in this interpreter or as system processes."""

from __future__ import annotations

import signal
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from .output import Output

if TYPE_CHECKING:
    from .process import Process
    from .session import Session


class BaseProcess(ABC):
    """A program of the session: its number, output, signals and end.

    `exit_code` is None while it runs, as in `subprocess`: 0 is success, a negative number the signal that ended it.
    """

    def __init__(self, session: Session, name: str, argv: Sequence[str], parent: Process | None) -> None:
        self.session = session
        self.name = name
        self.argv = list(argv)
        self.pid = session.new_pid()
        self.parent = parent
        self.exit_code: int | None = None
        self.abandoned = False
        """Whether it could not be ended, and was detached."""
        self.was_interrupted = False
        """Whether it was sent Ctrl-C: the exit code that follows then says nothing of its work."""
        self.out = Output()
        self.tty = False
        """Whether its streams claim to be a terminal."""
        self._ended = session.clock.new_event()
        self._exit_listeners: list[Callable[[Any], None]] = []

    # -- inspection

    @property
    def state(self) -> str:
        """'running' or 'exited'."""
        return "running" if self.exit_code is None else "exited"

    @property
    def output(self) -> str:
        """Its output on stdout and stderr, in order."""
        return self.out.text()

    def on_output(self, callback: Callable[[str, str], None]) -> None:
        """Call `callback(stream, text)` for all output from now on."""
        self.out.listeners.append(callback)

    def on_exit(self, callback: Callable[[Any], None]) -> None:
        """Call `callback(process)` when it has ended, or at once if it has already."""
        if self.exit_code is not None:
            callback(self)
        else:
            self._exit_listeners.append(callback)

    def wait(self, timeout_sec: float | None = None) -> int | None:
        """Wait for its end, at most `timeout_sec` seconds; return the exit code, or None if it is still running."""
        self._ended.wait(timeout_sec)
        return self.exit_code

    def __repr__(self) -> str:
        ended = "" if self.exit_code is None else f" {self.exit_code}"
        return f"<Process {self.pid} {self.name!r} {self.state}{ended}>"

    # -- control

    @abstractmethod
    def begin(self) -> None:
        """Start it."""

    @abstractmethod
    def write_stdin(self, text: str) -> None:
        """Write `text` to its standard input."""

    @abstractmethod
    def close_stdin(self) -> None:
        """Close its standard input, as Ctrl-D does."""

    @abstractmethod
    def send_signal(self, signum: int) -> None:
        """Deliver a signal to it."""

    def interrupt(self) -> None:
        """Send Ctrl-C (SIGINT)."""
        self.was_interrupted = True
        self.send_signal(signal.SIGINT)

    def terminate(self) -> None:
        """Ask it to end, as `kill PID` does."""
        self.send_signal(signal.SIGTERM)

    def kill(self) -> None:
        """End it unconditionally; if it cannot be ended, it is detached and `abandoned` is set."""
        self.send_signal(9)

    # -- its end

    def _tell_of_end(self) -> None:
        """Leave the session and call the listeners; `exit_code` is set."""
        self.session.forget(self)
        for listener in self._exit_listeners:
            listener(self)
        self._exit_listeners.clear()
