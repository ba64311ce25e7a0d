"""Filters for repeated log messages of a line of code: once, skip_first, throttle."""

from __future__ import annotations

from typing import Any

from coursekit.processes import session


class Once:
    """Lets the first message through."""

    def __init__(self, options: dict[str, Any]) -> None:
        self._passed = False

    def agrees(self, options: dict[str, Any]) -> bool:
        return True

    def lets_through(self) -> bool:
        first, self._passed = not self._passed, True
        return first


class SkipFirst:
    """Lets every message but the first through."""

    def __init__(self, options: dict[str, Any]) -> None:
        self._passed = False

    def agrees(self, options: dict[str, Any]) -> bool:
        return True

    def lets_through(self) -> bool:
        later, self._passed = self._passed, True
        return later


class Throttle:
    """Lets a message through if the last one was at least `throttle_duration_sec` seconds ago.

    On simulated time, which begins at 0, the first message passes only after that duration, as in ROS.
    """

    def __init__(self, options: dict[str, Any]) -> None:
        self._seconds = options["throttle_duration_sec"]
        self._clock = options.get("throttle_time_source_type", _DEFAULT_CLOCK)
        if self._clock is None:
            text = 'Required parameter "throttle_time_source_type" was not specified for'
            raise TypeError(f'{text} logging filter "Throttle"')
        if self._clock is not _DEFAULT_CLOCK and not hasattr(self._clock, "now"):
            text = f'Received throttle_time_source_type of "{self._clock}" is not a clock instance'
            raise ValueError(text)
        self._last: int | None = None

    def agrees(self, options: dict[str, Any]) -> bool:
        clock = options.get("throttle_time_source_type", _DEFAULT_CLOCK)
        return options["throttle_duration_sec"] == self._seconds and clock is self._clock

    def lets_through(self) -> bool:
        now = self._now()
        if self._last is None and getattr(self._clock, "ros_time_is_active", False):
            self._last = 0
        if self._last is not None and now < self._last + int(self._seconds * 1e9):
            return False
        self._last = now
        return True

    def _now(self) -> int:
        if self._clock is _DEFAULT_CLOCK:
            return session.current().clock.steady()
        return self._clock.now().nanoseconds


_DEFAULT_CLOCK = object()
FILTERS: dict[str, type] = {"throttle": Throttle, "skip_first": SkipFirst, "once": Once}
_OPTIONS = ["throttle_duration_sec", "throttle_time_source_type", "skip_first", "once"]
_SWITCHES = ("skip_first", "once")


def get_filters_from_kwargs(**kwargs: Any) -> list[str]:
    """Return the names of the filters that the options request; TypeError for an unknown option.

    >>> get_filters_from_kwargs(once=True, skip_first=True)
    ['skip_first', 'once']
    """
    for option in kwargs:
        if option not in _OPTIONS:
            raise TypeError(f'parameter "{option}" is not one of the recognized logging options "{_OPTIONS}"')
    filters = ["throttle"] if "throttle_duration_sec" in kwargs else []
    if not filters and "throttle_time_source_type" in kwargs:
        raise TypeError(
            'required parameter "throttle_duration_sec" not specified '
            'but is required for the the logging filter "throttle"'
        )
    return filters + [name for name in _SWITCHES if kwargs.get(name)]
