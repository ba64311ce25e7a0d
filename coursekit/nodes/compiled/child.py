"""A compiled program as a system process: start, signals, end and exit code."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Sequence

from coursekit.nodes.compiled.output import ChildOutput
from coursekit.processes.process import Process
from coursekit.systems import children, operating_system
from coursekit.systems.signal_names import signal_called

_ENDED_BY_CTRL_C = 0xC000013A
"""The exit code of a Windows program ended by Ctrl-C."""


class Child:
    """The program, started with the environment and folder of its process in the session.

    `address` is the host's address. `tell_signal` sends it a signal over its connection: on Windows a program without
    a console receives none.
    """

    def __init__(self, words: Sequence[str], address: str, process: Process, tell_signal: Callable[[int], bool]) -> None:
        self._child = subprocess.Popen(
            words,
            env={**process.env, "COURSEKIT_LINK": address},
            cwd=process.cwd,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            **children.apart(),
        )
        self.output = ChildOutput(self._child, process.out.write)
        self._tell_signal = tell_signal
        self._signalled = 0
        """The last signal sent."""

    def wait(self) -> int:
        """Wait for its end. Returns its exit code, or minus the signal that ended it."""
        code = self._child.wait()
        return -self._signalled if operating_system.WINDOWS and code == _ENDED_BY_CTRL_C and self._signalled else code

    def send(self, signum: int) -> None:
        """Send it a signal; does nothing when it has ended."""
        self._signalled = signum
        if operating_system.WINDOWS and self._tell_signal(signum):
            return
        if self._child.poll() is None:
            children.send_signal(self._child, signum)

    def kill(self) -> None:
        """Kill it and its child processes, such as a debugger's program."""
        if self._child.poll() is None:
            children.send_signal(self._child, signal_called("SIGKILL"))
