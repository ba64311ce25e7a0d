"""ROS 2's clocks: system, steady and ROS time, the last with an override (simulation time) and time jumps."""

from __future__ import annotations

import itertools
import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .clock import Clock
    from .timer import Timer

ROS_TIME, SYSTEM_TIME, STEADY_TIME = 1, 2, 3

JumpCallback = Callable[[int, int, bool], None]


class TimeBase:
    """One clock; `now()` in nanoseconds.

    >>> from coursekit.core.virtual_clock import VirtualClock
    >>> base = TimeBase(ROS_TIME, VirtualClock())
    >>> base.set_override(5); base.set_active(True); base.now()
    5
    """

    def __init__(self, kind: int, clock: Clock) -> None:
        self.kind = kind
        self.clock = clock
        self.active = False
        self.override = 0
        self._watchers: list[tuple[object, JumpCallback | None, JumpCallback | None]] = []
        self._numbers = itertools.count()
        self._timers: weakref.WeakSet[Timer] = weakref.WeakSet()

    def now(self) -> int:
        """The time on this clock."""
        if self.active:
            return self.override
        return self.clock.steady() if self.kind == STEADY_TIME else self.clock.now()

    def new_number(self) -> int:
        """Return a number for a timer of this clock: timers are notified of changes in the order of their creation."""
        return next(self._numbers)

    def add_timer(self, timer: Timer) -> None:
        """Notify `timer` when this clock is set or jumps."""
        self._timers.add(timer)

    def add_watcher(self, token: object, before: JumpCallback | None, after: JumpCallback | None) -> None:
        """Call `before` and `after` around each change with (delta ns, kind of change 1..4, went_active).

        >>> from coursekit.core.virtual_clock import VirtualClock
        >>> base = TimeBase(ROS_TIME, VirtualClock())
        >>> base.set_override(5); base.set_active(True)
        >>> base.add_watcher("mine", None, lambda delta, kind, went_active: print(delta))
        >>> base.set_override(2)  # a jump back in time
        -3
        """
        self._watchers.append((token, before, after))

    def remove_watcher(self, token: object) -> None:
        """Remove callbacks."""
        self._watchers = [entry for entry in self._watchers if entry[0] is not token]

    def set_active(self, active: bool) -> None:
        """Switch the override on or off."""
        if active == self.active:
            return
        self._change(0, True, lambda: setattr(self, "active", active))  # as in rcl, it has no length

    def set_override(self, nanoseconds: int) -> None:
        """Set the time used while the override is active."""
        if not self.active:
            self.override = nanoseconds
            return
        self._change(nanoseconds - self.override, False, lambda: setattr(self, "override", nanoseconds))

    def _change(self, delta: int, toggled: bool, apply: Callable[[], None]) -> None:
        watchers = list(self._watchers)
        for _, before, _ in watchers:
            if before is not None:
                before(delta, toggled, self.active)
        apply()
        for _, _, after in watchers:
            if after is not None:
                after(delta, toggled, self.active)
        for timer in sorted(self._timers, key=lambda timer: timer.number):
            timer.time_changed(delta, toggled)
