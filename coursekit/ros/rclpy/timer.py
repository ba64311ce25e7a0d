"""Timers and rates."""

from __future__ import annotations

import inspect
import threading
from functools import partial
from typing import TYPE_CHECKING, Any

from coursekit.processes.session import current
from rclpy._rclpy_pybind11 import RCLError
from rclpy._rclpy_pybind11 import Timer as _Handle
from rclpy.exceptions import ROSInterruptException
from rclpy.impl.rcl_log import timer_called, timer_made
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.context import Context


class TimerInfo:
    """The expected and the actual time of a timer call (passed to callbacks that take an argument)."""

    def __init__(self, *, expected_call_time: int, actual_call_time: int, clock_type: Any) -> None:
        from rclpy.time import Time

        self.expected_call_time = Time(nanoseconds=expected_call_time, clock_type=clock_type)
        self.actual_call_time = Time(nanoseconds=actual_call_time, clock_type=clock_type)


class Timer:
    """A timer, created by `Node.create_timer`; its callback runs every `timer_period_ns` nanoseconds of `clock`."""

    def __init__(
        self,
        callback: Any,
        callback_group: CallbackGroup,
        timer_period_ns: int,
        clock: Any,
        *,
        context: Context | None = None,
        autostart: bool = True,
    ) -> None:
        self._context = context or get_default_context()
        self._clock = clock
        if timer_period_ns < 0:
            raise RCLError("failed to create timer: timer period must be non-negative")
        self.__timer = _Handle(clock.handle, self._context.handle, int(timer_period_ns))
        timer_made(int(timer_period_ns))
        self._sources_list = [self.__timer.core]
        if not autostart:
            self.__timer.cancel_timer()
        self.callback = callback
        self.callback_group = callback_group
        self._info_parameter = _parameter_for_info(callback)

    @property
    def handle(self) -> _Handle:
        """The timer's handle."""
        return self.__timer

    def destroy(self) -> None:
        """Use `Node.destroy_timer` instead."""
        self.__timer.destroy_when_not_in_use()

    @property
    def clock(self) -> Any:
        """The clock that the timer runs on."""
        return self._clock

    @property
    def timer_period_ns(self) -> int:
        """The period in nanoseconds."""
        with self.__timer:
            return self.__timer.get_timer_period()

    @timer_period_ns.setter
    def timer_period_ns(self, value: int) -> None:
        with self.__timer:
            self.__timer.change_timer_period(int(value))

    def is_ready(self) -> bool:
        """Whether the timer is due."""
        with self.__timer:
            return self.__timer.is_timer_ready()

    def is_canceled(self) -> bool:
        """Whether the timer was cancelled."""
        with self.__timer:
            return self.__timer.is_timer_canceled()

    def cancel(self) -> None:
        """Stop the timer; `reset` starts it again.

        >>> timer = node.create_timer(0.5, lambda: print("tick"))
        >>> timer.cancel()
        >>> timer.is_canceled(), timer.time_until_next_call()
        (True, None)
        """
        with self.__timer:
            self.__timer.cancel_timer()

    def reset(self) -> None:
        """Restart the period, whether cancelled or not.

        >>> timer = node.create_timer(0.5, lambda: print("tick"))
        >>> timer.cancel()
        >>> timer.reset()
        >>> rclpy.spin_once(node)
        tick
        """
        with self.__timer:
            self.__timer.reset_timer()

    def time_since_last_call(self) -> int:
        """Nanoseconds since the last call."""
        with self.__timer:
            return self.__timer.time_since_last_call()

    def time_until_next_call(self) -> int | None:
        """Nanoseconds until the next call, negative when late; None when cancelled."""
        with self.__timer:
            return self.__timer.time_until_next_call()

    def _begin_period(self) -> None:
        """Start the first period now, when `create_timer` returns the timer, not when its construction began."""
        if not self.__timer.is_timer_canceled():
            self.__timer.reset_timer()

    def _sources(self) -> list[Any]:
        return self._sources_list

    def _take(self) -> Any:
        timer = self.__timer.core
        if not timer.has_work():
            return None
        expected = timer.next
        timer_called()
        timer.call()
        if not self._info_parameter:
            return self.callback or (lambda: self.callback())  # to call None ends the spin, as in Humble
        info = TimerInfo(
            expected_call_time=expected, actual_call_time=timer.last, clock_type=self._clock.clock_type
        )
        return partial(self.callback, **{self._info_parameter: info})


def _parameter_for_info(callback: Any) -> str:
    """Return the name of the callback's parameter for a TimerInfo, '' if none is annotated so.

    Later ROS versions fill it in; Humble calls every timer's callback with nothing.
    """
    try:
        parameters = inspect.signature(callback).parameters.values()
    except (TypeError, ValueError):
        return ""
    return next((parameter.name for parameter in parameters if parameter.annotation in (TimerInfo, "TimerInfo")), "")


class Rate:
    """Sleeps to run a loop at a constant rate. Another thread must spin the node meanwhile.

    A period that began while no thread slept ends the next sleep at once: a loop may alternate spinning and sleeping.
    """

    def __init__(self, timer: Timer, *, context: Context) -> None:
        self._clock = timer.clock
        self._timer = timer
        self._timer.callback = self._tick
        self._sleepers: list[Any] = []
        self._ticked = False
        self._lock = threading.Lock()
        self._is_shutdown = False
        self._is_destroyed = False
        context.on_shutdown(self._on_shutdown)

    def _on_shutdown(self) -> None:
        self._is_shutdown = True
        self.destroy()

    def destroy(self) -> None:
        """Wake sleeping threads; use `Node.destroy_rate` instead."""
        self._is_destroyed = True
        self._tick()

    def _tick(self) -> None:
        with self._lock:
            sleepers, self._sleepers = self._sleepers, []
            self._ticked = not sleepers
        for sleeper in sleepers:
            sleeper.set()

    def sleep(self) -> None:
        """Block until the next period begins."""
        self._check()
        tick = current().clock.new_event()
        with self._lock:
            if self._ticked:
                tick.set()
            else:
                self._sleepers.append(tick)
            self._ticked = False
        tick.wait()
        if self._is_shutdown:
            raise ROSInterruptException()

    def _check(self) -> None:
        if self._is_shutdown:
            raise ROSInterruptException()
        if self._is_destroyed:
            raise RuntimeError("Rate cannot sleep because it has been destroyed")
        if not self._timer.handle.valid:
            self.destroy()
            raise RuntimeError("Rate cannot sleep because it has been destroyed")
