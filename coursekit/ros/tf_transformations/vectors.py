"""Lengths and directions of vectors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

Array = np.ndarray[Any, Any]
Vector = Sequence[float] | Array
Matrix = Sequence[Sequence[float]] | Array
EPS = float(np.finfo(float).eps * 4.0)


def vector_norm(data: Vector, axis: int | None = None, out: Array | None = None) -> Any:
    """The length of a vector; with `axis`, the lengths along it, written to `out` if given.

    >>> vector_norm([3.0, 4.0])
    5.0
    """
    values = np.array(data, dtype=np.float64)
    if out is not None:
        out[...] = np.sqrt(np.sum(values * values, axis=axis))
        return None
    if values.ndim == 1:
        return math.sqrt(float(np.dot(values, values)))
    return np.atleast_1d(np.sqrt(np.sum(values * values, axis=axis)))


def unit_vector(data: Vector, axis: int | None = None, out: Array | None = None) -> Any:
    """The vector divided by its length; with `axis`, along it, written to `out` if given.

    >>> unit_vector([0.0, 2.0]).tolist()
    [0.0, 1.0]
    """
    values = np.array(data, dtype=np.float64)
    squares = np.sum(values * values, axis=axis, keepdims=axis is not None)
    if values.size:
        values /= np.sqrt(squares)
    if out is None:
        return values
    out[...] = values
    return None


def random_vector(size: int | Sequence[int]) -> Array:
    """Random numbers from 0 up to 1."""
    return np.random.random(size)
