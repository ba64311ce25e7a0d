"""A compiled program as a part of a process of Python: on a robot that would load a library instead."""

from __future__ import annotations

from collections.abc import Sequence

from coursekit.nodes.compiled.channel import CallbackFailed, Gone
from coursekit.nodes.compiled.frames import Unpacker
from coursekit.nodes.compiled.host import Host

_PATIENCE_S = 5.0
"""The time for its end after `close` [s]; then it is killed."""


class EmbeddedProgram(Host):
    """Carries out requests of the process that makes it; its nodes, output and end are that process's."""

    def __init__(self, path: str, argv: Sequence[str]) -> None:
        super().__init__(path, list(argv))
        self.served = self
        self.code: int | None = None
        """The exit code, when it has ended by itself."""
        self._handler = 0
        self._is_ready, self._is_unneeded, self._has_ended = (self.clock.new_event() for _ in range(3))

    def start(self) -> None:
        """Start it, and wait until it can carry out requests. Raises Gone when it ends before."""
        self.session.spawn(self._live)
        self._is_ready.wait()
        if not self._handler:
            self._note_end()
            raise Gone

    def _live(self) -> None:
        try:
            self.run()
        finally:
            self._has_ended.set()
            self._is_ready.set()

    def _begin_signals(self) -> None:
        """Leave the signals to the process."""

    def offer(self, handler: int) -> None:
        """Make its handler known, and wait until `close`."""
        self._handler = handler
        self._is_ready.set()
        while not self._is_unneeded.wait():
            pass

    def ask(self, data: bytes) -> Unpacker:
        """Let it carry out a request. Raises Gone, with `code` set, when it ends meanwhile or has ended."""
        if self.code is not None:
            raise Gone
        try:
            return self.call(self._handler, data)
        except (CallbackFailed, Gone):
            self._note_end()
            raise Gone from None

    def _note_end(self) -> None:
        self.code = self._child.wait()
        self.output.drain()
        self._is_unneeded.set()

    def close(self) -> None:
        """End it."""
        self.stopping = True
        self._is_unneeded.set()
        if not self._has_ended.wait(_PATIENCE_S):
            self._child.kill()
