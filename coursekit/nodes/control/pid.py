"""A PID loop as control_toolbox has it: the integral's part is limited, or with antiwindup the integral itself."""

from __future__ import annotations

from dataclasses import dataclass, field

from .controller import ControlError


@dataclass(frozen=True)
class Gains:
    """Gains, and the limits of what the integral adds to a command."""

    p: float = 0.0
    i: float = 0.0
    d: float = 0.0
    i_max: float = 0.0
    i_min: float = 0.0
    antiwindup: bool = False

    def __post_init__(self) -> None:
        if self.i_min > self.i_max:
            raise ControlError(f"i_clamp_min ({self.i_min}) is more than i_clamp_max ({self.i_max})")


@dataclass
class Pid:
    """One loop.

    >>> loop = Pid(Gains(p=2.0, i=1.0, i_max=0.3, i_min=-0.3))
    >>> [loop.command(0.5, dt) for dt in (0.5, 0.5)]
    [1.25, 1.3]
    """

    gains: Gains
    _integral: float = field(default=0.0, init=False)
    _last: float = field(default=0.0, init=False)

    def reset(self) -> None:
        """Forget all errors."""
        self._integral = self._last = 0.0

    def command(self, error: float, dt: float, rate: float | None = None) -> float:
        """Return the command for an error that has lasted `dt` seconds; `rate` is its change [1/s], if it is known."""
        if dt <= 0:
            return 0.0
        if rate is None:
            rate, self._last = (error - self._last) / dt, error
        gains = self.gains
        self._integral += error * dt
        if gains.antiwindup and gains.i:
            low, high = sorted((gains.i_min / gains.i, gains.i_max / gains.i))
            self._integral = min(max(self._integral, low), high)
        added = gains.i * self._integral
        if not gains.antiwindup:
            added = min(max(added, gains.i_min), gains.i_max)
        return gains.p * error + added + gains.d * rate


__all__ = ["Gains", "Pid"]
