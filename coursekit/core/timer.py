"""Timers: periodic, on any clock; missed periods are skipped, not made up for."""

from __future__ import annotations

from .ready_queue import ReadyQueue, Source
from .time_base import TimeBase


class Timer(Source):
    """Becomes ready every `period` nanoseconds of its clock.

    Of timers that are due at one instant the one whose periods began first, its `phase`, rings first: on a robot no two
    begin at one instant.

    >>> from coursekit.core.time_base import STEADY_TIME
    >>> from coursekit.core.virtual_clock import VirtualClock
    >>> clock = VirtualClock()
    >>> timer = Timer(TimeBase(STEADY_TIME, clock), 500_000_000)
    >>> clock.sleep(1.7)
    >>> timer.has_work(), timer.time_until_next_call()
    (True, -1200000000)
    >>> timer.call()
    >>> timer.time_until_next_call()
    300000000
    """

    __slots__ = ("__weakref__", "base", "canceled", "generation", "last", "next", "number", "period", "phase")

    def __init__(self, base: TimeBase, period: int) -> None:
        super().__init__()
        self.base = base
        self.period = period
        self.canceled = False
        self.generation = 0
        self.number = base.new_number()
        self._begin(base.now())
        base.add_timer(self)

    def _begin(self, now: int) -> None:
        self.last = now
        self.next = now + self.period
        self.phase = next(self.base.clock.phases)

    def has_work(self) -> bool:
        """Whether it is due."""
        return not self.canceled and self.base.now() >= self.next

    def attach(self, sink: ReadyQueue | None, item: object) -> None:
        """Be served through `sink`."""
        super().attach(sink, item)
        self._arm()

    def call(self) -> None:
        """Count a call: the next one is due a period later, and always in the future."""
        now = self.base.now()
        self.last = now
        self.next += self.period
        if self.period == 0:
            self.next = now
        elif self.next < now:
            self.next += (1 + (now - self.next - 1) // self.period) * self.period
        self._arm(now)

    def cancel(self) -> None:
        """Stop being due."""
        self.canceled = True
        self.generation += 1

    def reset(self) -> None:
        """Restart: due one period from now, cancelled or not.

        >>> from coursekit.core.time_base import STEADY_TIME
        >>> from coursekit.core.virtual_clock import VirtualClock
        >>> clock = VirtualClock()
        >>> timer = Timer(TimeBase(STEADY_TIME, clock), 500_000_000)
        >>> clock.sleep(0.4); timer.reset(); timer.time_until_next_call()
        500000000
        """
        self.canceled = False
        self._begin(self.base.now())
        self._arm()

    def time_until_next_call(self) -> int | None:
        """Return the nanoseconds until the next call, negative when it is late; None when cancelled."""
        return None if self.canceled else self.next - self.base.now()

    def ring(self) -> None:
        """Signal if it is due, else arm again; called by the queue at the timer's deadline."""
        if self.has_work():
            self.signal()
        else:
            self._arm()

    def time_changed(self, delta: int, toggled: bool) -> None:
        """React to a change of its clock: a backward jump restarts the period."""
        if self.canceled:
            return
        if toggled or delta < 0:
            now = self.base.now()
            if toggled or now < self.last:
                self._begin(now)
        if self.has_work():
            self.signal()
        elif toggled:
            self._arm()

    def _arm(self, now: int | None = None) -> None:
        self.generation += 1
        sink = self.sink
        base = self.base
        if sink is None or self.canceled or base.active:
            return
        rest = self.next - (base.now() if now is None else now)
        sink.arm(self, base.clock.steady() + (rest if rest > 0 else 0))
