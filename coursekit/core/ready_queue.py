"""The event queue: work is queued when it becomes ready, so its cost does not grow with the number of nodes."""

from __future__ import annotations

import heapq
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .clock import Clock
    from .timer import Timer


class Source:
    """Something that can become ready: a subscription with a message, a timer that is due, ...

    `sink` is the queue of the executor that serves it, `item` the object that the executor finds there.
    `queued` means that it is already in the queue: a source is queued once, however much it holds.
    With `yields` set it lets other ready sources go first, once.
    A `listener` is called with everything that arrives at a topic, service or event, before it is taken.
    """

    __slots__ = ("item", "listener", "queued", "sink", "yields")

    def __init__(self) -> None:
        self.sink: ReadyQueue | None = None
        self.item: Any = self
        self.listener: Callable[[Any], None] | None = None
        self.queued = False
        self.yields = False

    def signal(self) -> None:
        """Enter the queue."""
        sink = self.sink
        if sink is not None and not self.queued:
            self.queued = True
            sink.put(self.item)

    def has_work(self) -> bool:
        """Whether it is ready now; checked when another executor takes it over."""
        return False

    def attach(self, sink: ReadyQueue | None, item: object) -> None:
        """Be served through `sink` from now on; None detaches."""
        self.item = item
        self.sink = sink
        self.queued = False
        if sink is not None and self.has_work():
            self.signal()


class ReadyQueue:
    """An executor's work, in the order in which it became ready, and the pending timers.

    >>> from coursekit.core.virtual_clock import VirtualClock
    >>> queue = ReadyQueue(VirtualClock())
    >>> queue.put("scan"); queue.put("odometry")
    >>> queue.pop(), queue.pop(), queue.pop()
    ('scan', 'odometry', None)
    """

    def __init__(self, clock: Clock) -> None:
        self.clock = clock
        self.items: deque[Any] = deque()
        self._timers: list[tuple[int, int, int, Timer]] = []
        self._waiter = clock.new_waiter()
        self._sleeping = False

    def put(self, item: object) -> None:
        """Append `item`; safe from any thread."""
        self.items.append(item)
        if self._sleeping:
            self._waiter.notify()

    def wake(self) -> None:
        """End the present or the next `wait`."""
        self._waiter.notify()

    def arm(self, timer: Timer, deadline: int) -> None:
        """Ring `timer` at `deadline` (steady nanoseconds)."""
        heapq.heappush(self._timers, (deadline, timer.phase, timer.generation, timer))
        if self._sleeping:
            self._waiter.notify()

    def pop(self, until: int | None = None) -> Any:
        """Return the next ready item, or None; timers due after `until` (steady) do not count as ready."""
        if self._timers:
            now = self.clock.steady()
            if until is not None and until < now:
                now = until
            if self._timers[0][0] <= now:
                self._ring(now)
        try:
            return self.items.popleft() if self.items else None
        except IndexError:  # another thread was faster
            return None

    def count_ready(self) -> int:
        """Return the number of queued items, including due timers."""
        self._ring(self.clock.steady())
        return len(self.items)

    def wait(self, deadline: int | None) -> None:
        """Wait until something may be ready, or until `deadline` (steady nanoseconds)."""
        timers = self._timers
        while timers and timers[0][3].generation != timers[0][2]:
            heapq.heappop(timers)
        if timers and (deadline is None or timers[0][0] < deadline):
            deadline = timers[0][0]
        self._sleeping = True
        try:
            if not self.items:
                self._waiter.wait(deadline)
        finally:
            self._sleeping = False

    def _ring(self, now: int) -> None:
        timers = self._timers
        while timers and timers[0][0] <= now:
            _, _, generation, timer = heapq.heappop(timers)
            if timer.generation == generation and timer.sink is self:
                timer.ring()
