"""Limits of a speed, its acceleration and its jerk, as in diff_drive_controller's parameters."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from .controller import ControlError

NOTHING = (-math.inf, math.inf)


class SpeedLimiter:
    """Keeps one speed within limits; `ask(name, default)` returns parameters below `prefix`.

    >>> told = {"linear.x.has_velocity_limits": True, "linear.x.max_velocity": 0.5}
    >>> SpeedLimiter(told.get, "linear.x").limit(2.0, 0.02)
    0.5

    Raises:
        ControlError: when a limit is enabled without its `max_` value.
    """

    def __init__(self, ask: Callable[[str, Any], Any], prefix: str) -> None:
        self._velocity = _limits(ask, prefix, "velocity")
        self._acceleration = _limits(ask, prefix, "acceleration")
        self._jerk = _limits(ask, prefix, "jerk")
        self._last = self._before = 0.0

    def limit(self, wish: float, dt: float) -> float:
        """Return the limited speed after the last two speeds and `dt` seconds."""
        speed, change = wish, self._last - self._before
        if self._jerk != NOTHING:
            least, most = (2 * jerk * dt * dt for jerk in self._jerk)
            speed = self._last + change + _within(speed - self._last - change, least, most)
        if self._acceleration != NOTHING:
            least, most = (acceleration * dt for acceleration in self._acceleration)
            speed = self._last + _within(speed - self._last, least, most)
        speed = _within(speed, *self._velocity)
        self._before, self._last = self._last, speed
        return speed

    def restart(self) -> None:
        """Reset to standstill."""
        self._last = self._before = 0.0


def _limits(ask: Callable[[str, Any], Any], prefix: str, kind: str) -> tuple[float, float]:
    """Return the minimum and maximum; infinite if not limited."""
    wanted = ask(f"{prefix}.has_{kind}_limits", False)
    most, least = (float(_or_nan(ask(f"{prefix}.{end}_{kind}", math.nan))) for end in ("max", "min"))
    if not wanted:
        return NOTHING
    if math.isnan(most):
        raise ControlError(
            f"Cannot apply {kind} limits if max_{kind} is not specified: give {prefix}.max_{kind}, "
            f"or set {prefix}.has_{kind}_limits to false"
        )
    return (-most if math.isnan(least) else least), most


def _or_nan(value: float | None) -> float:
    return math.nan if value is None else value


def _within(value: float, least: float, most: float) -> float:
    return max(least, min(most, value))


__all__ = ["SpeedLimiter"]
