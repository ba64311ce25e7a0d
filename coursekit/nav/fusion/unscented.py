"""The unscented Kalman filter: it propagates states around the expected one instead of using derivatives."""

from __future__ import annotations

import math

import numpy as np

from coursekit.geometry.plane import wrap
from coursekit.nav.fusion.control import Control
from coursekit.nav.fusion.kalman import Ekf, innovation
from coursekit.nav.fusion.measurement import Measurement
from coursekit.nav.fusion.motion import step
from coursekit.nav.fusion.state import ANGLES, SIZE, Array, wrapped


class Ukf(Ekf):
    """Like Ekf, with 31 sigma points around the expected state; alpha, kappa and beta set their spread and weights."""

    def __init__(
        self,
        noise: Array | None = None,
        *,
        control: Control | None = None,
        scaled: bool = False,
        alpha: float = 0.001,
        kappa: float = 0.0,
        beta: float = 2.0,
    ) -> None:
        super().__init__(noise, control=control, scaled=scaled)
        spread = alpha**2 * (SIZE + kappa)
        self._spread = spread
        self._weights = np.full(2 * SIZE + 1, 0.5 / spread)
        self._weights[0] = (spread - SIZE) / spread
        self._covariance_weights = self._weights.copy()
        self._covariance_weights[0] += 1 - alpha**2 + beta

    def _around(self, state: Array) -> Array:
        """Return the sigma points around a state, (31, 15)."""
        sizes, directions = np.linalg.eigh(self.now.covariance * self._spread)
        root = (directions * np.sqrt(np.maximum(sizes, 0.0))).T
        return np.vstack([state, state + root, state - root])

    def _offsets(self, states: Array) -> Array:
        """Return the differences of states from the first, with angles wrapped."""
        off = states - states[0]
        off[:, ANGLES] = wrap(off[:, ANGLES])
        return off

    def predict(self, time_ns: int) -> None:
        """Predict to a later time without measurements."""
        now, seconds = self.now, (time_ns - self.now.time_ns) * 1e-9
        later = np.array([step(point, seconds) for point in self._around(self.controlled(time_ns, seconds))])
        off = self._offsets(later)
        mean = self._weights @ off  # of the offsets: large weights of opposite sign cancel better than for the states
        off -= mean
        covariance = (off.T * self._covariance_weights) @ off + self.growth(seconds)
        now.state, now.covariance = wrapped(later[0] + mean), (covariance + covariance.T) / 2
        now.time_ns = time_ns

    def correct(self, measurement: Measurement) -> bool:
        """Correct by a current measurement; False when it is too far from the prediction."""
        places = measurement.finite()
        if not len(places):
            return True
        now, noise = self.now, measurement.noise(places)
        off = self._offsets(self._around(now.state))
        weighted = off.T * self._covariance_weights
        shared = weighted @ off[:, places]
        spread = shared[places] + noise
        inverse = np.linalg.inv(spread)
        surprise = innovation(measurement, places, now.state[places])
        if measurement.threshold <= math.sqrt(max(float(surprise @ inverse @ surprise), 0.0)):
            return False
        gain = shared @ inverse
        now.state = wrapped(now.state + gain @ surprise)
        covariance = now.covariance - gain @ spread @ gain.T
        now.covariance = (covariance + covariance.T) / 2
        return True
