"""The acceleration to come, by a commanded speed."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from coursekit.nav.fusion.state import ACCELERATION, ANGULAR, TWIST, Array, Mask


@dataclass
class Control:
    """Commands of six speeds: which count, how fast they may change [per s], and how eagerly they are followed."""

    used: Mask
    timeout_ns: int
    acceleration_limits: Array
    acceleration_gains: Array
    deceleration_limits: Array
    deceleration_gains: Array
    wanted: Array = field(default_factory=lambda: np.zeros(6))
    time_ns: int = 0

    def command(self, wanted: Array, time_ns: int) -> None:
        """A command of that time."""
        self.wanted, self.time_ns = wanted, time_ns

    def accelerations(self, speeds: Array, now_ns: int) -> Array:
        """Of all six speeds; a command that is too old counts as a command to stand."""
        wanted = self.wanted if now_ns - self.time_ns < self.timeout_ns else np.zeros(6)
        missing = wanted - speeds
        slower = (np.abs(wanted) <= np.abs(speeds)) | (wanted * speeds < 0)
        limits = np.where(slower, self.deceleration_limits, self.acceleration_limits)
        gains = np.where(slower, self.deceleration_gains, self.acceleration_gains)
        return np.where(self.used, np.clip(gains * missing, -limits, limits), 0.0)

    def apply(self, state: Array, now_ns: int, seconds: float) -> Array:
        """A state that is on its way to the commanded speeds."""
        made, change = state.copy(), self.accelerations(state[TWIST], now_ns)
        made[ANGULAR] += change[3:] * seconds
        made[ACCELERATION] = np.where(self.used[:3], change[:3], made[ACCELERATION])
        return made
