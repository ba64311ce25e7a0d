"""The inner loop of the particle filter: the likelihood of a scan for each particle."""

from __future__ import annotations

import math

import numpy as np
from numba import njit


@njit(cache=True)
def scan_likelihoods(particles, ends, field, ox, oy, cell, outside, z_hit, z_rand, sigma, range_max):  # type: ignore[no-untyped-def]
    """Return (n,) 1 + the sum over all beams of p³, where p is the likelihood field model of Thrun, Burgard, Fox.

    `ends` (m, 2) are the beams' ends in the robot's frame [m]; `field` holds distances to the nearest wall [m], its corner
    at (ox, oy); outside of it walls count as `outside` away.
    """
    rows, columns = field.shape
    table_step = outside / 1023.0
    table = np.empty(1024)
    for t in range(1024):
        d = t * table_step
        table[t] = (z_hit * math.exp(-d * d / (2.0 * sigma * sigma)) + z_rand / range_max) ** 3
    likelihoods = np.empty(len(particles))
    for k in range(len(particles)):
        x, y = (particles[k, 0] - ox) / cell, (particles[k, 1] - oy) / cell
        c, s = math.cos(particles[k, 2]) / cell, math.sin(particles[k, 2]) / cell
        total = 1.0
        for b in range(len(ends)):
            j = math.floor(x + c * ends[b, 0] - s * ends[b, 1])
            i = math.floor(y + s * ends[b, 0] + c * ends[b, 1])
            if 0 <= i < rows and 0 <= j < columns:
                total += table[int(field[i, j] / table_step)]
            else:
                total += table[1023]
        likelihoods[k] = total
    return likelihoods
