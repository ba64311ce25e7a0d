"""A real child process of the system, behind the interface of the session's own processes."""

from __future__ import annotations

import _thread
import codecs
import os
import signal
import subprocess
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from coursekit.core import session

OutputCallback = Callable[[str, str], None]
DRAIN_SEC = 1.0
"""How long output that grandchildren still hold open is waited for after the end."""


class ChildProcess:
    """A child process; its output is read by threads of its own and its end is told.

    It leads a process group, so a terminal's Ctrl-C reaches it only through whoever started it, and its
    signals reach its children as well. While it lives the virtual clock passes no faster than the wall.
    """

    def __init__(
        self,
        cmd: Sequence[str],
        *,
        cwd: str | None,
        env: Mapping[str, str],
        on_output: OutputCallback,
    ) -> None:
        self.__session = session.current()
        self.argv = list(cmd)
        self.name = os.path.basename(cmd[0])
        self.exit_code: int | None = None
        self.__on_output = on_output
        self.__exit_listeners: list[Callable[[Any], None]] = []
        self.__popen = subprocess.Popen(
            self.argv, cwd=cwd, env=dict(env), stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, start_new_session=True)
        self.pid = self.__session.new_pid() if self.__session.clock.virtual else self.__popen.pid
        self.__count(1)

    def begin(self) -> None:
        """Start to read its output and to wait for its end."""
        done = []
        for stream, pipe in (('stdout', self.__popen.stdout), ('stderr', self.__popen.stderr)):
            finished = _thread.allocate_lock()
            finished.acquire()
            done.append(finished)
            _thread.start_new_thread(self.__read, (stream, pipe, finished))
        _thread.start_new_thread(self.__wait, (done,))

    @property
    def state(self) -> str:
        """'running' or 'exited'."""
        return 'running' if self.exit_code is None else 'exited'

    def on_exit(self, callback: Callable[[Any], None]) -> None:
        """Call `callback(process)` when it has ended, at once if it has already."""
        if self.exit_code is not None:
            callback(self)
        else:
            self.__exit_listeners.append(callback)

    def send_signal(self, signum: int) -> None:
        """Send a signal to it and its children; nothing happens when it has ended."""
        if self.exit_code is None:
            try:
                os.killpg(self.__popen.pid, signum)
            except ProcessLookupError:
                pass

    def interrupt(self) -> None:
        """Press Ctrl-C."""
        self.send_signal(signal.SIGINT)

    def kill(self) -> None:
        """End it whatever it does."""
        self.send_signal(signal.SIGKILL)

    def write_stdin(self, text: str) -> None:
        """Type `text` into its standard input."""
        assert self.__popen.stdin is not None
        self.__popen.stdin.write(text.encode())
        self.__popen.stdin.flush()

    def __count(self, change: int) -> None:
        clock = self.__session.clock
        if clock.virtual:
            clock.children += change
            clock.wake()

    def __read(self, stream: str, pipe: Any, finished: Any) -> None:
        decoder = codecs.getincrementaldecoder('utf-8')('replace')
        with pipe:
            while data := os.read(pipe.fileno(), 65536):
                self.__on_output(stream, decoder.decode(data))
        finished.release()

    def __wait(self, readers: list[Any]) -> None:
        code = self.__popen.wait()
        for finished in readers:
            finished.acquire(timeout=DRAIN_SEC)
        self.exit_code = code
        for listener in self.__exit_listeners:
            listener(self)
        self.__count(-1)


def start_child(
    cmd: Sequence[str], *, cwd: str | None, env: Mapping[str, str], on_output: OutputCallback
) -> ChildProcess:
    """Start a real child process.

    Raises:
        FileNotFoundError: when there is no such program.
    """
    child = ChildProcess(cmd, cwd=cwd, env=env, on_output=on_output)
    child.begin()
    return child
