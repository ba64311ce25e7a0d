"""Compiling the inner loops before they are needed: the first scan then takes no longer than the next."""

from __future__ import annotations

import math

import numpy as np

from coursekit.geometry.plane import Pose2D
from coursekit.slam.localizer import Localizer
from coursekit.slam.scan import Laser, Scan
from coursekit.slam.slam import Slam


def warm() -> None:
    """Run a tiny session once; about 20 s on the very first time on a machine, then a fraction of a second."""
    slam, laser = Slam(), Laser(-math.pi, math.radians(4))
    angles = laser.angles(90)
    walls = 2.0 / np.maximum(np.abs(np.cos(angles)), np.abs(np.sin(angles)))
    for number in range(2):
        slam.add_ranges(float(number), walls, laser, Pose2D(0.4 * number, 0.0, 0.0))
    slam.map()
    slam.finish()
    localizer = Localizer.from_keyframes(slam.keyframes, slam.graph.poses, slam.params)
    localizer.find(Scan.from_ranges(walls, laser, slam.params), Pose2D(), 0.3, 0.1)
