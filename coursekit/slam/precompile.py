"""Compiles the inner loops in advance: the first scan and the first loop then take no longer than the next."""

from __future__ import annotations

import math

import numpy as np

from coursekit.geometry.plane import Array, Pose2D
from coursekit.slam.localizer import Localizer
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Laser, Scan
from coursekit.slam.slam import Slam

_SMALL = SlamParameters(submap_keyframes=4, loop_least_way=1.0)
"""Parameters with which loops are closed even in a room."""
_WAY = [0.35 * (4 - abs(4 - step)) for step in range(9)]
"""The robot's positions in the room [m]: there and back."""


def warm() -> None:
    """Run a tiny session once; about 20 s the first time on a machine, then a fraction of a second."""
    slam, laser = Slam(_SMALL), Laser(-math.pi, math.radians(4))
    for number, x in enumerate(_WAY):
        slam.add_ranges(float(number), _room(laser.angles(90), x), laser, Pose2D(x, 0.0, 0.0))
    slam.map()
    slam.finish()
    localizer = Localizer.from_keyframes(slam.keyframes, slam.graph.poses, slam.params)
    localizer.find(Scan.from_ranges(_room(laser.angles(90), 0.0), laser, slam.params), Pose2D(), 0.3, 0.1)


def _room(angles: Array, x: float) -> Array:
    """Return the ranges from (x, 0) in a room from -2 to 4 m and from -2 to 2 m."""
    ahead, aside = np.cos(angles), np.sin(angles)
    ends = np.where(ahead > 0, 4.0 - x, 2.0 + x)
    ranges: Array = np.minimum(ends / np.maximum(np.abs(ahead), 1e-9), 2.0 / np.maximum(np.abs(aside), 1e-9))
    return ranges
