"""The factors of a matrix: rotation, scales and shears."""

from __future__ import annotations

import math

import numpy as np

from .vectors import Array, Matrix


def rotation_part(matrix: Matrix) -> Array:
    """The rotation in a 3x3 or 4x4 matrix, without scales and shears."""
    return factors(np.asarray(matrix, dtype=np.float64)[:3, :3])[0]


def factors(m: Array) -> tuple[Array, Array, Array]:
    """Rotation, scales and shears with m = rotation · scales · shears, by Gram-Schmidt orthogonalization of the columns."""
    rotation, scale, shear = np.empty((3, 3)), np.empty(3), {}
    for column in range(3):
        rest = m[:, column].copy()
        for before in range(column):
            along = float(rotation[:, before] @ rest)
            rest -= along * rotation[:, before]
            shear[before, column] = along / scale[before]
        scale[column] = math.sqrt(float(np.sum(rest**2)))
        if not scale[column]:
            raise ValueError("Matrix is degenerate: it has no inverse")
        rotation[:, column] = rest / scale[column]
    if np.linalg.det(rotation) < 0.0:
        scale[0] *= -1.0
        rotation[:, 0] *= -1.0
    return rotation, scale, np.array((shear[0, 1], shear[0, 2], shear[1, 2]))
