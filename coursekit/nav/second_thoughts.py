"""Whether a new path is worth leaving the one that is driven: two ways of nearly one length must not take turns."""

from __future__ import annotations

import numpy as np

from coursekit.nav.planner import length

WORTH = 0.85
"""Another way is taken when it has at most this share of the length."""
SAME_WITHIN = 0.5
"""Paths that stay so near to each other are one way [m]."""


def remaining(path: np.ndarray, x: float, y: float) -> np.ndarray:
    """The part of a path (n, 2) ahead of its point nearest to (x, y) [m].

    >>> remaining(np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), 1.2, 0.3).tolist()
    [[1.0, 0.0], [2.0, 0.0]]
    """
    return path[int(np.hypot(path[:, 0] - x, path[:, 1] - y).argmin()) :]


def worth_it(new: np.ndarray, old: np.ndarray) -> bool:
    """Whether to take `new` (n, 2) instead of what remains of `old` (m, 2): it is the same way, or much shorter [m].

    >>> straight, around = np.array([[0, 0], [1, 0], [2, 0]]), np.array([[0, 0], [1, 0.6], [2, 0]])
    >>> worth_it(straight, around), worth_it(straight + 0.1, straight)
    (False, True)
    """
    gaps = np.hypot(new[:, None, 0] - old[None, :, 0], new[:, None, 1] - old[None, :, 1]).min(axis=1)
    return bool(gaps.max() < SAME_WITHIN or length(new) < WORTH * length(old))
