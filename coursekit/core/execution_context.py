"""An execution context is one line of execution: a thread on the wall clock, a greenlet on the virtual one."""

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


class CallbackAbandoned(BaseException):
    """Raised by a callback that also ends what called it, such as a spin; `except Exception` lets it pass.

    A future swallows the exceptions of its callbacks, as rclpy's does, and a spin would go on without its program.
    """


class ExecutionContext:
    """A thread of a program: it can be blocked, woken and interrupted.

    `pending` holds callables that the execution context runs itself, just before or after its next wait.
    This is how a Ctrl-C reaches code that sleeps, spins or waits.
    """

    def __init__(self) -> None:
        self.blocked_on: Any = None
        self.pending: deque[Callable[[], None]] = deque()
        self.ident = threading.get_ident()
        self.turn = 0
        self.polls = 0

    def post(self, action: Callable[[], None]) -> None:
        """Have the execution context run `action` (which may raise) and wake it if it waits."""
        self.pending.append(action)
        self.wake()

    def wake(self) -> None:
        """Wake it if it waits; unless there is something to do, it waits on."""
        waiter = self.blocked_on
        if waiter is not None:
            waiter.poke()

    def run_pending(self) -> None:
        """Run the posted actions; an exception in one ends the call and keeps the rest.

        >>> context = ExecutionContext()
        >>> context.post(lambda: print("a Ctrl-C arrives")); context.run_pending(); context.run_pending()
        a Ctrl-C arrives
        """
        while self.pending:
            try:
                action = self.pending.popleft()
            except IndexError:  # another thread was faster
                return
            action()


class _ThreadContexts(threading.local):
    context: ExecutionContext | None = None


_of_thread = _ThreadContexts()


def thread_context() -> ExecutionContext:
    """Return the calling thread's execution context, created on first use."""
    context = _of_thread.context
    if context is None:
        context = _of_thread.context = ExecutionContext()
    return context
