"""Euler angles: 24 orders of axes, static ('s') or rotating with the body ('r')."""

from __future__ import annotations

import itertools
import math

import numpy as np

from .vectors import EPS, Array, Matrix

Axes = str | tuple[int, int, int, int]


def _encodings() -> dict[str, tuple[int, int, int, int]]:
    """Name -> (first axis, parity, repetition, frame). A rotating order is the reversed static order."""
    table = {}
    for first, parity, repetition in itertools.product(range(3), (0, 1), (0, 1)):
        second = (first + 1 + parity) % 3
        third = first if repetition else 3 - first - second
        letters = "".join("xyz"[axis] for axis in (first, second, third))
        table["s" + letters] = (first, parity, repetition, 0)
        table["r" + letters[::-1]] = (first, parity, repetition, 1)
    return table


_AXES2TUPLE = _encodings()
_TUPLE2AXES = {code: name for name, code in _AXES2TUPLE.items()}


def encoding(axes: Axes) -> tuple[int, int, int, int]:
    """The four numbers of an order; raises KeyError for an unknown order."""
    if isinstance(axes, str):
        return _AXES2TUPLE[axes.lower()]
    if tuple(axes) not in _TUPLE2AXES:
        raise KeyError(axes)
    return tuple(axes)  # type: ignore[return-value]


def turns(ai: float, aj: float, ak: float, axes: Axes) -> tuple[tuple[int, float], tuple[int, float], tuple[int, float]]:
    """The three rotations about static axes as (axis, angle), in the order of application."""
    first, parity, repetition, frame = encoding(axes)
    if frame:
        ai, ak = ak, ai
    second = (first + 1 + parity) % 3
    third = first if repetition else 3 - first - second
    return (first, ai), (second, aj), (third, ak)


def euler_matrix(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> Array:
    """The 4x4 rotation of three angles (roll, pitch, yaw for 'sxyz').

    >>> round(float(euler_matrix(1, 2, 3, "syxz")[0].sum()), 6)
    -1.347865
    """
    matrix = np.identity(4)
    for axis, angle in turns(ai, aj, ak, axes):
        matrix[:3, :3] = _about(axis, angle) @ matrix[:3, :3]
    return matrix


def _about(axis: int, angle: float) -> Array:
    matrix = np.identity(3)
    b, c = (axis + 1) % 3, (axis + 2) % 3
    matrix[b, b] = matrix[c, c] = math.cos(angle)
    matrix[c, b] = math.sin(angle)
    matrix[b, c] = -matrix[c, b]
    return matrix


def euler_from_matrix(matrix: Matrix, axes: Axes = "sxyz") -> tuple[float, float, float]:
    """The three angles of a rotation (3x3 or 4x4); if they are not unique, one is 0."""
    first, parity, repetition, frame = encoding(axes)
    i, j = first, (first + 1 + parity) % 3
    k = 3 - i - j
    m = np.asarray(matrix, dtype=np.float64)[:3, :3].tolist()
    a, b, c = _repeated(m, i, j, k) if repetition else _distinct(m, i, j, k)
    if parity:
        a, b, c = -a, -b, -c
    return (c, b, a) if frame else (a, b, c)


def _repeated(m: list[list[float]], i: int, j: int, k: int) -> tuple[float, float, float]:
    size = math.hypot(m[i][j], m[i][k])
    middle = math.atan2(size, m[i][i])
    if size > EPS:
        return math.atan2(m[i][j], m[i][k]), middle, math.atan2(m[j][i], -m[k][i])
    return math.atan2(-m[j][k], m[j][j]), middle, 0.0


def _distinct(m: list[list[float]], i: int, j: int, k: int) -> tuple[float, float, float]:
    size = math.hypot(m[i][i], m[j][i])
    middle = math.atan2(-m[k][i], size)
    if size > EPS:
        return math.atan2(m[k][j], m[k][k]), middle, math.atan2(m[j][i], m[i][i])
    return math.atan2(-m[j][k], m[j][j]), middle, 0.0
