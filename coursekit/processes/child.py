"""System programs that run as child processes, with the interface of a session's process."""

from __future__ import annotations

import os
import subprocess
import threading
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from coursekit.core.clock import start_outside
from coursekit.systems import children
from coursekit.systems.child_terminal import open_terminal

from .base_process import BaseProcess
from .process import current_process

if TYPE_CHECKING:
    from .session import Session


class ChildProcess(BaseProcess):
    """A child process with the interface of a session's process.

    On the virtual clock time passes as on the wall while it runs, or not at all if `takes_time` is False. With
    `one_stream` its stderr is merged into its stdout in the order in which it was written, as in a terminal. With
    `tty` set before it begins, it writes to terminals.
    """

    def __init__(
        self,
        session: Session,
        command: Sequence[str],
        *,
        name: str,
        env: Mapping[str, str] | None = None,
        cwd: str | os.PathLike[str] | None = None,
        takes_time: bool = True,
        one_stream: bool = False,
    ) -> None:
        super().__init__(session, name, command, current_process())
        self._one_stream = one_stream
        self.takes_time = takes_time
        self.env = children.with_utf8(os.environ if env is None else env)
        self.cwd = None if cwd is None else os.fspath(cwd)
        self._child: subprocess.Popen[str] | None = None

    def begin(self) -> None:
        """Start it, with threads that read its output."""
        terminals = [open_terminal() if self.tty else None for _ in ("stdout", "stderr")]
        ends = [terminal[1] if terminal else subprocess.PIPE for terminal in terminals]
        try:
            self._child = subprocess.Popen(
                self.argv,
                stdin=subprocess.PIPE,
                stdout=ends[0],
                stderr=subprocess.STDOUT if self._one_stream else ends[1],
                encoding="utf-8",
                errors="replace",
                bufsize=1,
                env=self.env,
                cwd=self.cwd,
                **children.apart(),
            )
        finally:
            for terminal in terminals:
                if terminal:
                    os.close(terminal[1])
        self._count_child(1)
        pipes = [terminal[0] if terminal else pipe for terminal, pipe in zip(terminals, _outputs(self._child), strict=True)]
        readers = [
            threading.Thread(target=self._read, args=(stream, pipe), daemon=True)
            for stream, pipe in zip(("stdout", "stderr"), pipes, strict=True)
            if pipe is not None
        ]
        for thread in readers:
            start_outside(thread)
        start_outside(threading.Thread(target=self._watch, args=(readers,), daemon=True))

    def _count_child(self, change: int) -> None:
        clock = self.session.clock
        if clock.virtual and self.takes_time:
            clock.children += change
        elif clock.virtual:
            clock.frozen += change
            clock.wake()

    def _read(self, stream: str, pipe: Any) -> None:
        for line in pipe:
            self.out.write(stream, line)

    def _watch(self, readers: list[threading.Thread]) -> None:
        assert self._child is not None
        code = self._child.wait()
        for thread in readers:
            threading.Thread.join(thread, 1.0)
        self.exit_code = code
        self._tell_of_end()
        self._ended.set()
        self._count_child(-1)  # last: from here on virtual time may run, and all waiters have been woken

    def write_stdin(self, text: str) -> None:
        """Write `text` to its standard input."""
        if self._child is not None and self._child.stdin is not None:
            self._child.stdin.write(text)
            self._child.stdin.flush()

    def close_stdin(self) -> None:
        """Close its standard input."""
        if self._child is not None and self._child.stdin is not None:
            self._child.stdin.close()

    def send_signal(self, signum: int) -> None:
        """Deliver a signal to it."""
        if self._child is not None and self.exit_code is None:
            children.send_signal(self._child, signum)  # also to its children, like Ctrl-C in a terminal


def _outputs(child: subprocess.Popen[str]) -> tuple[Any, Any]:
    return child.stdout, child.stderr

