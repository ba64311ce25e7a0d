"""The session's clock: every wait in coursekit goes through it.

There are two kinds: `WallClock` runs live, with threads; `coursekit.core.virtual_clock.VirtualClock` runs as fast as the
machine can, and deterministically.
"""

from __future__ import annotations

import contextvars
import heapq
import itertools
import threading
import time
from collections.abc import Callable
from typing import Any, Protocol

from coursekit.systems import waiting

from .execution_context import thread_context

_monotonic_ns = time.monotonic_ns
_time_ns = time.time_ns
_Thread_start = threading.Thread.start
_allocate_lock = threading.Lock


def start_outside(thread: threading.Thread) -> None:
    """Start a real thread, even where the threads of programs are execution contexts of the virtual clock."""
    _Thread_start(thread)


def waited_ns(seconds: float) -> int:
    """Return the duration [ns] of a wait of so many seconds: 0 for 0 or less, else at least 1.

    Seconds are floats: the remainder of a wait may be 1e-17 s, and a loop that waits for the remainder must end.

    >>> waited_ns(0.25), waited_ns(1e-17), waited_ns(-1.0)
    (250000000, 1, 0)
    """
    return max(round(seconds * 1e9), 1) if seconds > 0 else 0


class Waiter(Protocol):
    """A wake-up of one execution context: `notify` is remembered until the next `wait`."""

    def notify(self) -> None: ...
    def poke(self) -> None: ...
    def wait(self, deadline: int | None = None) -> bool: ...


class Clock(Protocol):
    """The interface of a session's clock."""

    virtual: bool
    phases: itertools.count[int]
    """Numbers for timers, in the order in which their periods begin."""

    def now(self) -> int: ...
    def steady(self) -> int: ...
    def sleep(self, seconds: float) -> None: ...
    def poll(self, weight: int = 1) -> None: ...
    def new_waiter(self) -> Waiter: ...
    def new_event(self) -> Event: ...
    def spawn(self, function: Callable[[], Any], name: str) -> Any: ...
    def call_at(self, deadline: int, function: Callable[[], None]) -> TimerHandle: ...


class TimerHandle:
    """A scheduled call; `cancel()` withdraws it.

    >>> handle = TimerHandle(0, lambda: print("ring"))
    >>> handle.ring(); handle.ring()
    ring
    """

    __slots__ = ("deadline", "function")

    def __init__(self, deadline: int, function: Callable[[], None]) -> None:
        self.deadline = deadline
        self.function: Callable[[], None] | None = function

    def cancel(self) -> None:
        """Cancel the call; harmless if it was made already."""
        self.function = None

    def ring(self) -> None:
        """Make the call, once."""
        function, self.function = self.function, None
        if function is not None:
            function()


class Event:
    """Like `threading.Event`, on the session's clock; Ctrl-C in the waiting process ends the wait.

    >>> from coursekit.core.clock import WallClock
    >>> event = WallClock().new_event()
    >>> event.wait(timeout_sec=0.0)
    False
    >>> event.set(); event.wait()
    True
    """

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._flag = False
        self._waiters: list[Waiter] = []

    def is_set(self) -> bool:
        """Whether `set` was called since the last `clear`."""
        if not self._flag:
            self._clock.poll()
        return self._flag

    def set(self) -> None:
        """Wake all waiting contexts, now and until `clear`."""
        self._flag = True
        for waiter in list(self._waiters):
            waiter.notify()

    def clear(self) -> None:
        """Make the next `wait` block again."""
        self._flag = False

    def wait(self, timeout_sec: float | None = None) -> bool:
        """Wait until `set`, at most `timeout_sec` seconds; returns whether it is set."""
        if self._flag:
            return True
        deadline = None if timeout_sec is None else self._clock.steady() + waited_ns(timeout_sec)
        waiter = self._clock.new_waiter()
        self._waiters.append(waiter)
        try:
            while not self._flag and waiter.wait(deadline):
                pass
        finally:
            self._waiters.remove(waiter)
        return self._flag


class WallWaiter:
    """A waiter of the wall clock: a lock that `notify` opens."""

    __slots__ = ("_lock",)

    def __init__(self) -> None:
        self._lock = _allocate_lock()
        self._lock.acquire()

    def notify(self) -> None:
        """Let the present or the next `wait` return."""
        try:
            self._lock.release()
        except RuntimeError:  # it was released already
            pass

    poke = notify

    def wait(self, deadline: int | None = None) -> bool:
        """Block until notified or until `deadline` (steady nanoseconds); returns whether it was notified."""
        context = thread_context()
        context.blocked_on = self  # before looking at pending, so that no Ctrl-C falls in between
        try:
            if context.pending:
                context.run_pending()
            got = waiting.acquire(self._lock, None if deadline is None else (deadline - _monotonic_ns()) * 1e-9)
        finally:
            context.blocked_on = None
        if context.pending:
            context.run_pending()
        return got


class WallClock:
    """The computer's own time."""

    virtual = False

    def __init__(self) -> None:
        self.phases = itertools.count()
        self._timers = _TimerThread()

    now = staticmethod(_time_ns)
    steady = staticmethod(_monotonic_ns)
    new_waiter = staticmethod(WallWaiter)

    def poll(self, weight: int = 1) -> None:
        """Do nothing: on the wall clock time passes by itself."""

    def sleep(self, seconds: float) -> None:
        """Sleep; Ctrl-C in the sleeping process ends the sleep."""
        deadline = _monotonic_ns() + round(seconds * 1e9)
        waiter = WallWaiter()
        while waiter.wait(deadline):
            pass

    def new_event(self) -> Event:
        """A new event on this clock."""
        return Event(self)

    def spawn(self, function: Callable[[], Any], name: str) -> Any:
        """Run `function` in a daemon thread that inherits the caller's context."""
        context = contextvars.copy_context()
        thread = threading.Thread(target=context.run, args=(function,), name=name, daemon=True)
        start_outside(thread)
        return thread

    def call_at(self, deadline: int, function: Callable[[], None]) -> TimerHandle:
        """Call `function`, which must not block, at `deadline` (steady nanoseconds), from the clock's timer thread."""
        return self._timers.add(TimerHandle(deadline, function))

    def close(self) -> None:
        """Cancel the scheduled calls and end their thread."""
        self._timers.close()


class _TimerThread:
    """One thread that makes scheduled calls; it lives only while there are any."""

    def __init__(self) -> None:
        self._heap: list[tuple[int, int, TimerHandle]] = []
        self._numbers = itertools.count()
        self._changed = threading.Condition()
        self._thread: threading.Thread | None = None

    def add(self, handle: TimerHandle) -> TimerHandle:
        with self._changed:
            heapq.heappush(self._heap, (handle.deadline, next(self._numbers), handle))
            if self._thread is None:
                self._thread = threading.Thread(target=self._run, name="coursekit-timer", daemon=True)
                start_outside(self._thread)
            self._changed.notify()
        return handle

    def close(self) -> None:
        with self._changed:
            self._heap.clear()
            self._changed.notify()

    def _run(self) -> None:
        while True:
            with self._changed:
                handle = self._next()
                if handle is None:
                    self._thread = None
                    return
            handle.ring()

    def _next(self) -> TimerHandle | None:
        while self._heap:
            deadline, _, handle = self._heap[0]
            late = _monotonic_ns() - deadline
            if handle.function is None or late >= 0:
                heapq.heappop(self._heap)
                if handle.function is not None:
                    return handle
            else:
                self._changed.wait(-late * 1e-9)
        return None
