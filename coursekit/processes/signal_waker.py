"""A signal ends the main thread's wait, whenever it comes.

Python runs a signal's handler between two steps of the main thread. A signal that comes after the last step and before the
thread sleeps in a lock would have to wait for what else wakes it, perhaps for ever: Ctrl-C would seem to do nothing.
"""

from __future__ import annotations

import signal
import socket
import threading

from coursekit.core.clock import start_outside
from coursekit.core.execution_context import thread_context


class SignalWaker:
    """Wakes the main thread, which has to make this, for each signal; its wait looks again at what it waits for."""

    def __init__(self) -> None:
        self._main = thread_context()
        self._hears, self._said = socket.socketpair()
        self._said.setblocking(False)
        self._before = signal.set_wakeup_fd(self._said.fileno(), warn_on_full_buffer=False)
        start_outside(threading.Thread(target=self._keep_waking, name="coursekit-signals", daemon=True))

    def _keep_waking(self) -> None:
        while self._hears.recv(64):
            waiter = self._main.blocked_on
            if waiter is not None:  # else it takes a step before it sleeps, and sees the signal
                waiter.poke()
        self._hears.close()

    def close(self) -> None:
        """Wake it no more; who has asked to be told of signals since then still is."""
        last = signal.set_wakeup_fd(self._before)
        if last != self._said.fileno():
            signal.set_wakeup_fd(last)
        self._said.close()
