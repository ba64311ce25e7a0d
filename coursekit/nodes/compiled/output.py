"""A compiled program's output, passed on in the order of printing."""

from __future__ import annotations

import socket
import subprocess
import threading
from collections.abc import Callable
from time import monotonic as _now  # the real one: in a process, `time` uses the session's clock

from coursekit.systems.pipes import never_wait, read_now, wait_readable


class ChildOutput:
    """The child's two pipes; whichever thread notices first passes on all output so far."""

    def __init__(self, child: subprocess.Popen[bytes], write: Callable[[str, str], None]) -> None:
        assert child.stdout is not None and child.stderr is not None
        self._streams = {child.stdout.fileno(): "stdout", child.stderr.fileno(): "stderr"}
        self._write = write
        self._lock = threading.Lock()
        for pipe in self._streams:
            never_wait(pipe)

    def drain(self) -> None:
        """Pass on the available output."""
        with self._lock:
            for pipe in list(self._streams):
                while self._pass_on(pipe):
                    pass

    def _pass_on(self, pipe: int) -> bool:
        try:
            data = read_now(pipe, 65_536)
        except BlockingIOError:
            return False
        if not data:
            self._streams.pop(pipe, None)
            return False
        self._write(self._streams[pipe], data.decode(errors="replace"))
        return True

    def wait_for(self, awaited: socket.socket, seconds: float | None = None) -> bool:
        """Wait in real time for input there, passing on output meanwhile; False when both pipes are closed.

        TimeoutError after `seconds`.
        """
        end = None if seconds is None else _now() + seconds
        while True:
            pipes = list(self._streams)
            left = None if end is None else max(0.0, end - _now())
            ready = wait_readable([awaited, *pipes], left if pipes else 0)
            if awaited in ready:
                return True
            if not pipes:
                return False
            if not ready:
                raise TimeoutError
            self.drain()

    def pass_all_on(self) -> None:
        """Pass on output until the child has closed both pipes."""
        never, other = socket.socketpair()
        with never, other:
            while self.wait_for(never):
                pass
