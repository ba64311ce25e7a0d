"""Clocks: system, steady and ROS time; ROS time follows /clock when `use_sim_time` is set."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from coursekit.processes.session import current
from rclpy._rclpy_pybind11 import Clock as _Handle
from rclpy._rclpy_pybind11 import ClockChange, ClockType
from rclpy.duration import Duration
from rclpy.exceptions import NotInitializedException
from rclpy.time import Time
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from rclpy.context import Context

__all__ = ["Clock", "ClockChange", "ClockType", "JumpHandle", "JumpThreshold", "ROSClock", "TimeJump"]


class JumpThreshold:
    """The clock jumps that trigger a callback."""

    def __init__(
        self, *, min_forward: Duration | None, min_backward: Duration | None, on_clock_change: bool = True
    ) -> None:
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise ValueError("min_forward must be a positive non-zero duration")
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise ValueError("min_backward must be a negative non-zero duration")
        if min_forward is None and min_backward is None and not on_clock_change:
            raise ValueError("At least one jump threshold must be enabled")
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change

    def exceeded_by(self, delta: int, toggled: bool) -> bool:
        """Whether a jump of `delta` nanoseconds exceeds the threshold."""
        if toggled:
            return bool(self.on_clock_change)
        forward = self.min_forward is not None and delta >= self.min_forward.nanoseconds
        return forward or (self.min_backward is not None and delta <= self.min_backward.nanoseconds)


class TimeJump:
    """A jump of a clock."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        if not isinstance(clock_change, ClockChange):
            raise TypeError("clock_change must be an instance of rclpy.clock.ClockChange")
        self._clock_change = clock_change
        self._delta = delta

    @property
    def clock_change(self) -> ClockChange:
        """Whether simulation time was switched on or off."""
        return self._clock_change

    @property
    def delta(self) -> Duration:
        """New time minus old time."""
        return self._delta


class JumpHandle:
    """A registered jump callback; `unregister()` removes it."""

    def __init__(
        self,
        *,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: Callable[[], Any] | None,
        post_callback: Callable[[TimeJump], Any] | None,
    ) -> None:
        if pre_callback is None and post_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        if pre_callback is not None and not callable(pre_callback):
            raise ValueError("pre_callback must be callable if given")
        if post_callback is not None and not callable(post_callback):
            raise ValueError("post_callback must be callable if given")
        self._clock: Clock | None = clock
        self._threshold = threshold
        self._before = pre_callback
        self._after = post_callback
        clock.handle.core.add_watcher(self, self._on_before, self._on_after)

    def _on_before(self, delta: int, toggled: bool, _active: bool) -> None:
        if self._before is not None and self._threshold.exceeded_by(delta, toggled):
            self._before()

    def _on_after(self, delta: int, toggled: bool, active: bool) -> None:
        if self._after is None or not self._threshold.exceeded_by(delta, toggled):
            return
        change = ClockChange.ROS_TIME_NO_CHANGE
        if toggled:
            change = ClockChange.ROS_TIME_ACTIVATED if active else ClockChange.ROS_TIME_DEACTIVATED
        self._after(TimeJump(change, Duration(nanoseconds=delta)))

    def unregister(self) -> None:
        """Remove the callbacks."""
        if self._clock is not None:
            self._clock.handle.core.remove_watcher(self)
            self._clock = None

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(self, *_error: object) -> None:
        self.unregister()


class Clock:
    """A clock of one type; a clock of ROS time is a `ROSClock`.

    >>> Clock(clock_type=ClockType.STEADY_TIME).now().clock_type
    <ClockType.STEADY_TIME: 3>
    """

    _clock_type: ClockType
    _handle: _Handle

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Any:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        clock: Any = super().__new__(ROSClock if clock_type is ClockType.ROS_TIME else cls)
        clock._clock_type = clock_type
        clock._handle = _Handle(clock_type)
        return clock

    @property
    def clock_type(self) -> ClockType:
        """The type of this clock."""
        return self._clock_type

    @property
    def handle(self) -> _Handle:
        """The clock's handle."""
        return self._handle

    def __repr__(self) -> str:
        return f"Clock(clock_type={self.clock_type.name})"

    def now(self) -> Time:
        """The current time."""
        base = self._handle.core
        base.clock.poll()
        return Time._of(base.now(), self._clock_type)

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Callable[[], Any] | None = None,
        post_callback: Callable[[TimeJump], Any] | None = None,
    ) -> JumpHandle:
        """Register callbacks that run before and after jumps that exceed `threshold`."""
        if post_callback is None and pre_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        return JumpHandle(
            clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post_callback
        )

    def sleep_until(self, until: Time, context: Context | None = None) -> bool:
        """Sleep until this clock reaches `until`; False if the context ends or ROS time is switched on or off first."""
        context = get_default_context() if context is None else context
        if not context.ok():
            raise NotInitializedException()
        if until.clock_type != self._clock_type:
            raise ValueError("until's clock type does not match this clock's type")
        return _Sleep(self, until.nanoseconds, context).run()

    def sleep_for(self, rel_time: Duration, context: Context | None = None) -> bool:
        """Sleep for a duration of this clock.

        >>> clock = node.get_clock()
        >>> begin = clock.now()
        >>> clock.sleep_for(rclpy.duration.Duration(seconds=1.5))
        True
        >>> (clock.now() - begin).nanoseconds
        1500000000
        """
        return self.sleep_until(self.now() + rel_time, context)


class _Sleep:
    """One `sleep_until`: wakes when the time is reached, when the clock jumps, or when the context ends."""

    def __init__(self, clock: Clock, until: int, context: Context) -> None:
        self._base = clock.handle.core
        self._until = until
        self._context = context
        self._toggled = False
        self._event = current().clock.new_event()

    def run(self) -> bool:
        """Sleep; return whether the time was reached."""
        self._base.add_watcher(self, None, self._on_jump)
        self._context.on_shutdown(self._event.set)
        try:
            while self._context.ok() and not self._toggled:
                left = self._until - self._base.now()
                if left <= 0:
                    return True
                self._event.wait(None if self._base.active else left * 1e-9)
                if self._context.ok():
                    self._event.clear()
        finally:
            self._base.remove_watcher(self)
            self._context.remove_on_shutdown(self._event.set)
        return False

    def _on_jump(self, _delta: int, toggled: bool, _active: bool) -> None:
        self._toggled = self._toggled or toggled
        self._event.set()


class ROSClock(Clock):
    """ROS time: the system's time, or the time of /clock while simulation time is used."""

    def __new__(cls) -> ROSClock:
        return super().__new__(Clock, clock_type=ClockType.ROS_TIME)

    @property
    def ros_time_is_active(self) -> bool:
        """Whether simulation time is used."""
        return bool(self.handle.core.active)

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        self.handle.core.set_active(enabled)

    def set_ros_time_override(self, time: Time) -> None:
        """Set the simulation time."""
        if not isinstance(time, Time):
            raise TypeError(
                f"Time must be specified as rclpy.time.Time. Received type: {type(time)}"
            )
        self.handle.core.set_override(time.nanoseconds)
