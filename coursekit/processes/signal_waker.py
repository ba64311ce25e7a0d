"""Makes every signal end the main thread's wait.

Python runs a signal handler between two bytecodes of the main thread. A signal that arrives after the last one and before
the thread blocks on a lock would have to wait until something else wakes it: Ctrl-C would seem to do nothing.
"""

from __future__ import annotations

import signal
import socket
import threading

from coursekit.core.clock import start_outside
from coursekit.core.execution_context import thread_context


class SignalWaker:
    """Wakes the main thread, which must create this, for each signal; its wait then checks its condition again."""

    def __init__(self) -> None:
        self._main = thread_context()
        self._hears, self._said = socket.socketpair()
        self._said.setblocking(False)
        self._before = signal.set_wakeup_fd(self._said.fileno(), warn_on_full_buffer=False)
        start_outside(threading.Thread(target=self._keep_waking, name="coursekit-signals", daemon=True))

    def _keep_waking(self) -> None:
        while self._hears.recv(64):
            waiter = self._main.blocked_on
            if waiter is not None:  # else it runs code before it sleeps, and handles the signal
                waiter.poke()
        self._hears.close()

    def close(self) -> None:
        """Stop waking; a wakeup fd set by other code since then is kept."""
        last = signal.set_wakeup_fd(self._before)
        if last != self._said.fileno():
            signal.set_wakeup_fd(last)
        self._said.close()
