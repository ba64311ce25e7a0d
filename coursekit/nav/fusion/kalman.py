"""The extended Kalman filter: a prediction, corrected by measurements."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from coursekit.geometry.plane import wrap
from coursekit.nav.fusion.control import Control
from coursekit.nav.fusion.measurement import Measurement
from coursekit.nav.fusion.motion import jacobian, step
from coursekit.nav.fusion.state import POSE, ROLL, SIZE, TWIST, YAW, Array, Places, wrapped

PROCESS_NOISE = (0.05, 0.05, 0.06, 0.03, 0.03, 0.06, 0.025, 0.025, 0.04, 0.01, 0.01, 0.02, 0.01, 0.01, 0.015)
"""Variances added to each component of the state per second."""
FIRST_VARIANCE = 1e-9


@dataclass
class Estimate:
    """A state, its covariance, and its time."""

    state: Array = field(default_factory=lambda: np.zeros(SIZE))
    covariance: Array = field(default_factory=lambda: np.eye(SIZE) * FIRST_VARIANCE)
    time_ns: int = 0
    begun: bool = False


class Ekf:
    """Predicts with the motion model and corrects by measurements, in the given order.

    With `scaled` the noise of the pose grows with the speed: the pose of a stationary robot stays certain.
    """

    def __init__(self, noise: Array | None = None, *, control: Control | None = None, scaled: bool = False) -> None:
        self.noise = np.diag(PROCESS_NOISE) if noise is None else np.asarray(noise, float)
        self.control, self.scaled = control, scaled
        self.now = Estimate()

    def take(self, measurement: Measurement) -> bool:
        """Predict to a measurement's time and correct by it; return whether it was accepted, as the first one always is."""
        if not self.now.begun:
            self._begin(measurement)
            return True
        ahead = measurement.time_ns - self.now.time_ns
        if ahead > 0:
            self.predict(measurement.time_ns)
        return self.correct(measurement)

    def _begin(self, measurement: Measurement) -> None:
        places = measurement.finite()
        self.now.state[places] = measurement.values[places]
        self.now.covariance[np.ix_(places, places)] = measurement.noise(places)
        self.now.begun, self.now.time_ns = True, measurement.time_ns

    def predict(self, time_ns: int) -> None:
        """Predict to a later time without measurements."""
        now, seconds = self.now, (time_ns - self.now.time_ns) * 1e-9
        slope = jacobian(now.state, seconds)
        now.state = wrapped(step(self.controlled(time_ns, seconds), seconds))
        now.covariance = slope @ now.covariance @ slope.T + self.growth(seconds)
        now.time_ns = time_ns

    def controlled(self, time_ns: int, seconds: float) -> Array:
        """Return the state with the command applied."""
        return self.now.state if self.control is None else self.control.apply(self.now.state, time_ns, seconds)

    def growth(self, seconds: float) -> Array:
        """Return the growth of the covariance."""
        if not self.scaled:
            return self.noise * seconds
        noise = self.noise.copy()
        noise[POSE, POSE] *= float(self.now.state[TWIST] @ self.now.state[TWIST])
        return noise * seconds

    def correct(self, measurement: Measurement) -> bool:
        """Correct by a current measurement; False when it is too far from the prediction."""
        places = measurement.finite()
        if not len(places):
            return True
        now, noise = self.now, measurement.noise(places)
        shared = now.covariance[:, places]
        inverse = np.linalg.inv(shared[places] + noise)
        surprise = innovation(measurement, places, now.state[places])
        if measurement.threshold <= math.sqrt(max(float(surprise @ inverse @ surprise), 0.0)):
            return False
        gain = shared @ inverse
        rest = np.eye(SIZE)
        rest[:, places] -= gain
        now.state = wrapped(now.state + gain @ surprise)
        now.covariance = rest @ now.covariance @ rest.T + gain @ noise @ gain.T
        return True


def innovation(measurement: Measurement, places: Places, expected: Array) -> Array:
    """Return the innovation: measured minus expected, with angle differences wrapped."""
    surprise = measurement.values[places] - expected
    turning = (places >= ROLL) & (places <= YAW)
    surprise[turning] = wrap(surprise[turning])
    return surprise

