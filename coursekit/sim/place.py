"""Positions and headings in the plane."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def wrap(angle: float) -> float:
    """The same angle in [-pi, pi).

    >>> round(wrap(3 * math.pi / 2), 4)
    -1.5708
    """
    return (angle + math.pi) % (2 * math.pi) - math.pi


class Place(NamedTuple):
    """A position [m] and heading [rad]. In ROS 2: geometry_msgs/Pose2D.

    >>> Place(1.0, 2.0, math.pi / 2) @ Place(1.0, 0.0, 0.0) == Place(1.0, 3.0, math.pi / 2)
    True
    """

    x: float = 0.0
    y: float = 0.0
    theta: float = 0.0

    def __matmul__(self, other: Place) -> Place:
        """This place, then the motion `other` in its frame."""
        c, s = math.cos(self.theta), math.sin(self.theta)
        x, y = self.x + c * other.x - s * other.y, self.y + s * other.x + c * other.y
        return Place(x, y, wrap(self.theta + other.theta))

    def inverse(self) -> Place:
        """The motion that undoes this one."""
        c, s = math.cos(self.theta), math.sin(self.theta)
        return Place(-c * self.x - s * self.y, s * self.x - c * self.y, wrap(-self.theta))

    def move(self, points: Array) -> Array:
        """Points (n, 2) of this place's frame, in the frame that it is given in."""
        c, s = math.cos(self.theta), math.sin(self.theta)
        return np.asarray(points, float) @ np.array([[c, s], [-s, c]]) + (self.x, self.y)


ORIGIN = Place()

__all__ = ["ORIGIN", "Array", "Place", "wrap"]
