"""One sensor's measurement of some components of the state, at one time."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coursekit.nav.fusion.state import OUT_OF_PLANE, Array, Mask, Places

LEAST_VARIANCE = 1e-9
"""Minimum variance: no measurement is free of error, and zero variances would make the filter's equations singular."""


@dataclass(frozen=True)
class Measurement:
    """Values (15), their covariance (15, 15) and a mask of the ones in use.

    It is rejected when it is `threshold` or more standard deviations from the prediction.
    """

    source: str
    time_ns: int
    values: Array
    covariance: Array
    used: Mask
    threshold: float = math.inf

    def finite(self) -> Places:
        """Return the indices of the values in use that are finite."""
        return np.flatnonzero(self.used & np.isfinite(self.values))

    def noise(self, places: Places) -> Array:
        """Return the covariance of those values: negative variances become positive, tiny ones are raised to the minimum."""
        part = self.covariance[np.ix_(places, places)].copy()
        diagonal = np.einsum("ii->i", part)
        diagonal[:] = np.maximum(np.abs(diagonal), LEAST_VARIANCE)
        return part


def keep_in_plane(values: Array, covariance: Array, used: Mask) -> None:
    """Constrain, in place, a body to the floor: no height, no roll or pitch, and no change of them."""
    places = list(OUT_OF_PLANE)
    values[places] = 0.0
    covariance[places, :] = covariance[:, places] = 0.0
    covariance[places, places] = 1e-6
    used[places] = True
