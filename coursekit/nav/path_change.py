"""Whether a new path is worth leaving the current one: two paths of similar length must not alternate."""

from __future__ import annotations

import numpy as np

from coursekit.nav.planner import length

WORTH = 0.85
"""A different path is taken only if its length is at most this share of the current one's."""
SAME_WITHIN = 0.5
"""Paths that stay this close to each other count as the same [m]."""


def remaining(path: np.ndarray, x: float, y: float) -> np.ndarray:
    """Return the part of a path (n, 2) ahead of its point nearest to (x, y) [m].

    >>> remaining(np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), 1.2, 0.3).tolist()
    [[1.0, 0.0], [2.0, 0.0]]
    """
    return path[int(np.hypot(path[:, 0] - x, path[:, 1] - y).argmin()) :]


def worth_it(new: np.ndarray, old: np.ndarray) -> bool:
    """Return whether to replace the rest of `old` (m, 2) by `new` (n, 2): it is the same path, or much shorter [m].

    >>> straight, around = np.array([[0, 0], [1, 0], [2, 0]]), np.array([[0, 0], [1, 0.6], [2, 0]])
    >>> worth_it(straight, around), worth_it(straight + 0.1, straight)
    (False, True)
    """
    gaps = np.hypot(new[:, None, 0] - old[None, :, 0], new[:, None, 1] - old[None, :, 1]).min(axis=1)
    return bool(gaps.max() < SAME_WITHIN or length(new) < WORTH * length(old))
