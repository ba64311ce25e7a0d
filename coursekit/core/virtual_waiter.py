"""Waiting on the virtual clock."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from .clock import WallWaiter

if TYPE_CHECKING:
    from .execution_context import ExecutionContext
    from .virtual_clock import VirtualClock

_get_ident = threading.get_ident


class VirtualWaiter:
    """A waiter of the virtual clock; a foreign thread may wait and notify too."""

    __slots__ = ("_clock", "_flag", "_foreign", "context")

    def __init__(self, clock: VirtualClock) -> None:
        self._clock = clock
        self._flag = False
        self._foreign: WallWaiter | None = None
        self.context: ExecutionContext | None = None

    def notify(self) -> None:
        """Let the present or the next `wait` return."""
        self._flag = True
        self.poke()

    def poke(self) -> None:
        """Wake the execution context without a notification (it has pending actions)."""
        if self._foreign is not None:
            self._foreign.notify()
        elif _get_ident() == self._clock.thread:
            self._rouse()
        else:
            self._clock.do_inside(self._rouse)

    def _rouse(self) -> None:
        """Make the context ready if it still waits here: the request of a foreign thread may be outdated."""
        context = self.context
        if context is not None and (self._flag or context.pending):
            self.context = None
            self._clock._ready.append(context)

    def wait(self, deadline: int | None = None) -> bool:
        """Yield control until notified or until `deadline` (steady nanoseconds); returns whether it was notified."""
        if _get_ident() != self._clock.thread:
            return self._wait_outside(deadline)
        context = self._clock.running
        if context.pending:
            context.run_pending()
        if not self._flag:
            self._clock._block(context, self, deadline)
        flag, self._flag = self._flag, False
        if context.pending:
            context.run_pending()
        return flag

    def _wait_outside(self, deadline: int | None) -> bool:
        self._foreign = foreign = WallWaiter()
        handle = None if deadline is None else self._clock.call_at(deadline, foreign.notify)
        try:
            if not self._flag:
                foreign.wait()
        finally:
            self._foreign = None
            if handle is not None:
                handle.cancel()
        flag, self._flag = self._flag, False
        return flag
