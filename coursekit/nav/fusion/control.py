"""The acceleration expected from a commanded velocity."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from coursekit.nav.fusion.state import ACCELERATION, ANGULAR, TWIST, Array, Mask


@dataclass
class Control:
    """Commands for six velocities: the ones in use, their maximum changes [per s], and the gains of their controllers."""

    used: Mask
    timeout_ns: int
    acceleration_limits: Array
    acceleration_gains: Array
    deceleration_limits: Array
    deceleration_gains: Array
    wanted: Array = field(default_factory=lambda: np.zeros(6))
    time_ns: int = 0

    def command(self, wanted: Array, time_ns: int) -> None:
        """Set a command received at that time."""
        self.wanted, self.time_ns = wanted, time_ns

    def accelerations(self, speeds: Array, now_ns: int) -> Array:
        """Return the accelerations for all six velocities; an outdated command counts as a command to stop."""
        wanted = self.wanted if now_ns - self.time_ns < self.timeout_ns else np.zeros(6)
        missing = wanted - speeds
        slower = (np.abs(wanted) <= np.abs(speeds)) | (wanted * speeds < 0)
        limits = np.where(slower, self.deceleration_limits, self.acceleration_limits)
        gains = np.where(slower, self.deceleration_gains, self.acceleration_gains)
        return np.where(self.used, np.clip(gains * missing, -limits, limits), 0.0)

    def apply(self, state: Array, now_ns: int, seconds: float) -> Array:
        """Return the state after accelerating towards the commanded velocities."""
        moved, change = state.copy(), self.accelerations(state[TWIST], now_ns)
        moved[ANGULAR] += change[3:] * seconds
        moved[ACCELERATION] = np.where(self.used[:3], change[:3], moved[ACCELERATION])
        return moved
