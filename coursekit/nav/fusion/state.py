"""The 15 components of a state: pose in the world, velocities and accelerations in the body's own frame."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from coursekit.geometry.plane import wrap

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]
Places = npt.NDArray[np.intp]

SIZE = 15
NAMES = (
    "X", "Y", "Z", "ROLL", "PITCH", "YAW",
    "X_VELOCITY", "Y_VELOCITY", "Z_VELOCITY", "ROLL_VELOCITY", "PITCH_VELOCITY", "YAW_VELOCITY",
    "X_ACCELERATION", "Y_ACCELERATION", "Z_ACCELERATION",
)  # fmt: skip
X, Y, Z, ROLL, PITCH, YAW, VX, VY, VZ, VROLL, VPITCH, VYAW, AX, AY, AZ = range(SIZE)
POSITION, ANGLES = slice(0, 3), slice(3, 6)
LINEAR, ANGULAR, ACCELERATION = slice(6, 9), slice(9, 12), slice(12, 15)
POSE, TWIST = slice(0, 6), slice(6, 12)
OUT_OF_PLANE = (Z, ROLL, PITCH, VZ, VROLL, VPITCH, AZ)
"""The components that stay zero for a body that never leaves the floor."""


def wrapped(state: Array) -> Array:
    """Return a state with its three angles within -π … π."""
    wrapped = state.copy()
    wrapped[ANGLES] = wrap(wrapped[ANGLES])
    return wrapped
