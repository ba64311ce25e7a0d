"""One sensor's measurement of some numbers of the state, at one time."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coursekit.nav.fusion.state import OUT_OF_PLANE, Array, Mask, Places

LEAST_VARIANCE = 1e-9
"""Nothing is measured without any error; without a little the filter's equations could not be solved."""


@dataclass(frozen=True)
class Measurement:
    """Values (15), their covariance (15, 15) and which of them count.

    It is left out when it is `threshold` or more standard deviations from what was expected.
    """

    source: str
    time_ns: int
    values: Array
    covariance: Array
    used: Mask
    threshold: float = math.inf

    def finite(self) -> Places:
        """The places of the numbers that count and are numbers."""
        return np.flatnonzero(self.used & np.isfinite(self.values))

    def noise(self, places: Places) -> Array:
        """The covariance of those numbers: variances that are negative lose their sign, tiny ones grow."""
        part = self.covariance[np.ix_(places, places)].copy()
        diagonal = np.einsum("ii->i", part)
        diagonal[:] = np.maximum(np.abs(diagonal), LEAST_VARIANCE)
        return part


def keep_in_plane(values: Array, covariance: Array, used: Mask) -> None:
    """Say, in place, that a body on the floor has no height, does not lean, and does not change that."""
    places = list(OUT_OF_PLANE)
    values[places] = 0.0
    covariance[places, :] = covariance[:, places] = 0.0
    covariance[places, places] = 1e-6
    used[places] = True
