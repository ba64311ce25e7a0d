"""The uncertainty of a pose: the ellipsoid of its position and the fan of its heading, at one standard deviation."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from coursekit.view.scene import Pose
from coursekit.view.scene_shapes import Colour, Shape, Triangles, ball, rotation

if TYPE_CHECKING:
    from numpy.typing import NDArray

_POSITION: Colour = (0.8, 0.2, 0.8, 0.3)
_HEADING: Colour = (1.0, 1.0, 0.5, 0.5)
_THIN = 0.001
"""The minimum half axis [m], which keeps a flat ellipsoid visible"""
_STEPS = 12


def doubt(covariance: NDArray[np.float64], pose: Pose) -> list[Shape]:
    """Return the shapes of a 6x6 covariance, in the frame of its pose; empty if it is not a covariance."""
    matrix = np.asarray(covariance, float).reshape(6, 6)
    if not np.isfinite(matrix).all():
        return []
    sizes, axes = np.linalg.eigh((matrix[:3, :3] + matrix[:3, :3].T) / 2)
    if sizes.min() < -1e-9 or matrix[5, 5] < 0:
        return []
    vertices, faces = ball(3)
    half = np.maximum(np.sqrt(np.maximum(sizes, 0.0)), _THIN)
    unturned = (vertices * 2 * half) @ axes.T @ rotation(np.array(pose[3:]))  # it is given in the header's frame
    shapes: list[Shape] = [Triangles(unturned, faces, _POSITION)] if sizes.max() > 0 else []
    return shapes + ([_fan(math.sqrt(matrix[5, 5]))] if matrix[5, 5] > 0 else [])


def _fan(spread: float) -> Triangles:
    """Return a flat fan of one metre about x."""
    angles = np.linspace(-min(spread, math.pi), min(spread, math.pi), _STEPS)
    rim = np.stack([np.cos(angles), np.sin(angles), np.zeros(_STEPS)], axis=1)
    at = np.arange(1, _STEPS)
    one_side = np.stack([np.zeros_like(at), at, at + 1], axis=1)
    return Triangles(np.concatenate([np.zeros((1, 3)), rim]), np.concatenate([one_side, one_side[:, ::-1]]), _HEADING)
