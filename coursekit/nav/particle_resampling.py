"""The required number of particles, and their clusters."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components

BIN = np.array([0.5, 0.5, math.radians(10)])
"""Size of the bins in which particles are counted [m, m, rad]."""
TURNS = 36
"""Number of heading bins."""
_HALF = [step for step in product((-1, 0, 1), repeat=3) if step > (0, 0, 0)]
"""Offsets to half of the neighbouring bins; the other half is covered by symmetry."""


def bins_of(particles: np.ndarray) -> np.ndarray:
    """Return (n, 3) integer indices of each particle's bin."""
    bins = np.floor(particles / BIN).astype(np.int64)
    bins[:, 2] %= TURNS
    return bins


def enough(bins: np.ndarray, error: float, z: float) -> np.ndarray:
    """Return the particles needed for `bins` occupied bins (Fox, 2003) to keep the sampling error below `error`.

    >>> enough(np.array([1, 2, 100]), 0.05, 0.99).tolist()
    [1, 20, 1129]
    """
    many = np.maximum(bins - 1, 1).astype(float)
    b = 2 / (9 * many)
    return np.where(bins < 2, 1, np.ceil(many / (2 * error) * (1 - b + np.sqrt(b) * z) ** 3)).astype(np.int64)


def draw(
    weights: np.ndarray, particles: np.ndarray, least: int, most: int, error: float, z: float, rng: np.random.Generator
) -> np.ndarray:
    """Return indices drawn by weight, as many as their occupied bins require, between `least` and `most`.

    >>> rng = np.random.default_rng(0)
    >>> chosen = draw(np.array([0.0, 0.9, 0.1]), np.zeros((3, 3)), 10, 100, 0.05, 0.99, rng)
    >>> len(chosen), 0 in chosen  # all in one bin: the minimum is enough; the first has no weight
    (10, False)
    """
    total = np.cumsum(weights)
    chosen = np.searchsorted(total, rng.random(most) * total[-1]).clip(0, len(weights) - 1)
    bins = bins_of(particles)
    _, first = np.unique(_keys(bins, *_frame(bins))[chosen], return_index=True)
    filled = np.zeros(most, dtype=np.int64)
    filled[first] = 1
    wanted = enough(np.cumsum(filled), error, z)
    done = np.nonzero(np.arange(1, most + 1) >= np.maximum(wanted, least))[0]
    return chosen[: int(done[0]) + 1] if len(done) else chosen


def clusters(particles: np.ndarray) -> np.ndarray:
    """Return (n,) the cluster of each particle: particles in adjacent bins belong together.

    >>> clusters(np.array([[0.0, 0.0, 0.0], [0.3, 0.2, 0.0], [5.0, 5.0, 0.0]])).tolist()
    [0, 0, 1]
    """
    bins = bins_of(particles)
    low, width = _frame(bins)
    keys, first, inverse = np.unique(_keys(bins, low, width), return_index=True, return_inverse=True)
    cells = bins[first]
    pairs = [_neighbours(keys, _keys(cells + np.array(step), low, width)) for step in _HALF]
    one, other = (np.concatenate([pair[k] for pair in pairs]) for k in (0, 1))
    links = csr_matrix((np.ones(len(one)), (one, other)), shape=(len(cells), len(cells)))
    label = connected_components(links, directed=False)[1]
    return np.asarray(label[inverse.reshape(-1)])


def _frame(bins: np.ndarray) -> tuple[np.ndarray, int]:
    """Return the lower left of all bins, and the number of rows, with one more on each side."""
    return bins[:, :2].min(axis=0) - 1, int(bins[:, 1].max() - bins[:, 1].min()) + 3


def _keys(cells: np.ndarray, low: np.ndarray, width: int) -> np.ndarray:
    """Return one integer key for each bin."""
    place = (cells[:, 0] - low[0]) * width + cells[:, 1] - low[1]
    return np.asarray(place * TURNS + cells[:, 2] % TURNS)


def _neighbours(keys: np.ndarray, wanted: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return which bins have a neighbour with key `wanted`, and its index; `keys` are sorted."""
    at = np.searchsorted(keys, wanted).clip(0, len(keys) - 1)
    there = np.nonzero(keys[at] == wanted)[0]
    return there, at[there]
