"""The virtual clock: time jumps to the next event.

Every execution context is a greenlet of one thread. So exactly one runs at a time, control passes in a fixed order, and
every run is the same. It uses greenlets rather than threads, because a thread switch costs 10 to 30 µs.
"""

from __future__ import annotations

import contextvars
import heapq
import itertools
import threading
from collections import deque
from collections.abc import Callable
from time import monotonic_ns  # the real one: in a process, time.monotonic_ns() reads this clock
from typing import Any

from greenlet import getcurrent, greenlet

from coursekit.systems import waiting

from .clock import Event, TimerHandle, WallWaiter, waited_ns
from .execution_context import ExecutionContext
from .virtual_waiter import VirtualWaiter

START_NS = 1_700_000_000_000_000_000
"""System time at the start of every virtual session."""
POLLS_PER_TICK = 1000
POLL_TICK_NS = 1_000_000
"""Code that polls without waiting is charged a millisecond per thousand polls."""

_get_ident = threading.get_ident


class GreenletContext(ExecutionContext):
    """An execution context with its greenlet."""

    def __init__(self, green: greenlet) -> None:
        super().__init__()
        self.green = green


class VirtualClock:
    """Time that passes only while every execution context is waiting.

    >>> clock = VirtualClock()
    >>> before = clock.now(); clock.sleep(3600.0); (clock.now() - before) / 1e9
    3600.0
    """

    virtual = True

    def __init__(self) -> None:
        self.thread = _get_ident()
        self.phases = itertools.count()
        self.running: ExecutionContext = GreenletContext(getcurrent())
        self.main = self.running
        self.children = 0
        """Number of live child processes: while there are any, time passes no faster than on the wall clock."""
        self.frozen = 0
        """Number of child processes that take no virtual time (a build): while there are any, time does not advance."""
        self.partner: Any = None
        """Another interpreter that shares this time: `partner.meet(deadline)` is called before time advances."""
        self._elapsed = 0
        self._ready: deque[ExecutionContext] = deque()
        self._heap: list[tuple[int, int, Any, int]] = []
        self._numbers = itertools.count()
        self._posted: deque[Callable[[], Any]] = deque()
        self._outside = WallWaiter()

    def now(self) -> int:
        """Virtual system time, nanoseconds since the epoch."""
        return START_NS + self._elapsed

    def steady(self) -> int:
        """Nanoseconds since the session began."""
        return self._elapsed

    def jump(self, steady: int) -> None:
        """Advance to a time [steady ns] before which nothing is scheduled here; never go back."""
        self._elapsed = max(self._elapsed, steady)

    def new_waiter(self) -> VirtualWaiter:
        """A new waiter on this clock."""
        return VirtualWaiter(self)

    def new_event(self) -> Event:
        """A new event on this clock."""
        return Event(self)

    def sleep(self, seconds: float) -> None:
        """Let the other execution contexts run for `seconds` of virtual time."""
        deadline = self._elapsed + waited_ns(seconds)
        waiter = VirtualWaiter(self)
        while waiter.wait(deadline) or self._elapsed < deadline:
            pass  # notified, or woken by a signal whose handler has returned

    def poll(self, weight: int = 1) -> None:
        """Charge a poll that did not wait, so that a polling loop cannot stop time."""
        if _get_ident() == self.thread:
            context = self.running
            context.polls += weight
            if context.polls >= POLLS_PER_TICK:
                context.polls = 0
                self.sleep(POLL_TICK_NS * 1e-9)

    def spawn(self, function: Callable[[], Any], name: str) -> ExecutionContext:
        """Create an execution context that runs `function` once the contexts that are ready now are waiting.

        >>> clock = VirtualClock()
        >>> _ = clock.spawn(lambda: (clock.sleep(1.0), print("spawned, at", clock.steady() / 1e9)), "worker")
        >>> clock.sleep(2.0); print("here, at", clock.steady() / 1e9)
        spawned, at 1.0
        here, at 2.0
        """
        variables = contextvars.copy_context()
        context = GreenletContext.__new__(GreenletContext)

        def run(*_result_of_the_context_that_ended: Any) -> None:
            try:
                function()
            finally:
                self._leave(context)

        context.__init__(greenlet(run, parent=self.main.green))  # type: ignore[misc,attr-defined]
        context.green.gr_context = variables
        if _get_ident() == self.thread:
            self._ready.append(context)
        else:
            self.do_inside(lambda: self._ready.append(context))
        return context

    def call_at(self, deadline: int, function: Callable[[], None]) -> TimerHandle:
        """Call `function`, which must not block, at `deadline` (steady nanoseconds).

        >>> clock = VirtualClock()
        >>> handle = clock.call_at(2 * 10**9, lambda: print("at", clock.steady()))
        >>> clock.sleep(3.0)
        at 2000000000
        """
        handle = TimerHandle(deadline, function)
        heapq.heappush(self._heap, (deadline, next(self._numbers), handle, -1))
        if _get_ident() != self.thread:
            self.wake()
        return handle

    def close(self) -> None:
        """Cancel scheduled calls."""
        self._heap.clear()

    def do_inside(self, function: Callable[[], Any]) -> None:
        """Have the clock's own thread call `function` next: no other thread may touch its execution contexts."""
        self._posted.append(function)
        self._outside.notify()

    def wake(self) -> None:
        """Make the clock check again for changes from outside (safe from any thread)."""
        self.do_inside(lambda: None)

    def _block(self, context: ExecutionContext, waiter: VirtualWaiter, deadline: int | None) -> None:
        waiter.context = context
        context.blocked_on = waiter
        context.turn += 1
        context.polls = 0
        if deadline is not None:
            heapq.heappush(self._heap, (deadline, next(self._numbers), context, context.turn))
        try:
            if waiter._flag or context.pending:
                return  # a foreign thread notified it before the context was registered as waiting
            following = self._pick()
            if following is not context:
                self.running = following
                following.green.switch()  # type: ignore[attr-defined]
        finally:
            waiter.context = None
            context.blocked_on = None
            context.turn += 1

    def _leave(self, context: GreenletContext) -> None:
        """End the execution context: the next one becomes its greenlet's parent, and so gets control."""
        following = self._pick()
        self.running = following
        context.green.parent = following.green  # type: ignore[attr-defined]

    def _pick(self) -> ExecutionContext:
        while True:
            while self._posted:
                self._posted.popleft()()
            if self._ready:
                return self._ready.popleft()
            context_due = self._advance()
            if context_due is not None:
                return context_due

    def _advance(self) -> ExecutionContext | None:
        """Advance to the next scheduled event: make the call, or return the execution context that is due."""
        heap = self._heap
        while heap and _is_over(heap[0]):
            heapq.heappop(heap)
        if self.partner is not None and self.partner.meet(heap[0][0] if heap else None):
            return None
        if not heap:
            self._wait_outside(None)
            return None
        deadline = heap[0][0]
        if self.frozen and deadline > self._elapsed:
            self._wait_outside(None)
            return None
        if self.children and deadline > self._elapsed:
            began = monotonic_ns()
            woken = self._wait_outside((deadline - self._elapsed) * 1e-9)
            self._elapsed = min(deadline, self._elapsed + monotonic_ns() - began)
            if woken:
                return None
        _, _, due, turn = heapq.heappop(heap)
        self._elapsed = max(self._elapsed, deadline)
        if turn < 0:
            due.ring()
            return None
        due.blocked_on.context = None
        if due is not self.main:
            self._make_others_ready(deadline)
        return due

    def _make_others_ready(self, deadline: int) -> None:
        """Run contexts that are due together one after the other, before those that they wake: caches are then still warm.

        The main context, in which the user works, runs after all effects of its actions.
        """
        heap = self._heap
        while heap and heap[0][0] == deadline and heap[0][3] >= 0 and heap[0][2] is not self.main:
            _, _, context, turn = heapq.heappop(heap)
            if context.turn == turn:
                context.blocked_on.context = None
                self._ready.append(context)

    def _wait_outside(self, seconds: float | None) -> bool:
        """Wait for a thread, a child process or the keyboard: nothing can happen inside."""
        if self._posted:
            return True
        return waiting.acquire(self._outside._lock, seconds)


def _is_over(entry: tuple[int, int, Any, int]) -> bool:
    """Whether a heap entry is obsolete: a cancelled call, or a wait that has already ended."""
    _, _, what, turn = entry
    return what.function is None if turn < 0 else what.turn != turn


def is_virtual_thread(clock: Any) -> bool:
    """Whether the calling thread is the one whose execution contexts `clock` runs."""
    return bool(clock.virtual) and _get_ident() == clock.thread
