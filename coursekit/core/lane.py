"""A lane is one line of execution: a thread on the wall clock, a greenlet on the virtual one."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from typing import Any


class ProcessKilled(BaseException):
    """Raised inside a process that was killed; it is not an Exception, so `except Exception` lets it pass."""

    def __init__(self, signum: int = 9) -> None:
        super().__init__(signum)
        self.signum = signum


class Lane:
    """What can be blocked, woken and interrupted.

    `pending` holds callables that the lane runs itself, the next time it is about to wait or has waited:
    that is how a Ctrl-C reaches code that sleeps, spins or waits.
    """

    def __init__(self) -> None:
        self.blocked_on: Any = None
        self.pending: deque[Callable[[], None]] = deque()
        self.ident = threading.get_ident()
        self.turn = 0
        self.polls = 0

    def post(self, action: Callable[[], None]) -> None:
        """Have the lane run `action` (which may raise) and wake it if it waits."""
        self.pending.append(action)
        waiter = self.blocked_on
        if waiter is not None:
            waiter.poke()

    def run_pending(self) -> None:
        """Run what was posted; an exception of the first action ends the call and keeps the rest."""
        while self.pending:
            try:
                action = self.pending.popleft()
            except IndexError:  # taken by another thread in between
                return
            action()


class _ThreadLanes(threading.local):
    lane: Lane | None = None


_of_thread = _ThreadLanes()


def thread_lane() -> Lane:
    """The lane of the thread that asks, made on first use."""
    lane = _of_thread.lane
    if lane is None:
        lane = _of_thread.lane = Lane()
    return lane
