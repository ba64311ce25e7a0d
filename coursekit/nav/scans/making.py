"""Ranges of a planar scan from points and from depth images."""

from __future__ import annotations

import math
from array import array
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Fan:
    """The beams of a scan [rad], and its limits of distance and height [m]."""

    angle_min: float = -math.pi
    angle_max: float = math.pi
    angle_increment: float = math.pi / 180
    range_min: float = 0.0
    range_max: float = math.inf
    min_height: float = -math.inf
    max_height: float = math.inf

    @property
    def beams(self) -> int:
        """Return the number of beams."""
        return max(math.ceil((self.angle_max - self.angle_min) / self.angle_increment - 1e-9), 0)


def of_points(points: Array, fan: Fan, nothing: float = math.inf) -> Array:
    """Return the distance of the nearest point (n, 3) in each beam; `nothing` where there is none.

    >>> of_points(np.array([[2.0, 0, 0], [1.0, 0, 0], [0, 0, 9.0]]), Fan(-1.0, 1.0, 1.0, 0.1)).tolist()
    [inf, 1.0]
    """
    ranges = np.full(fan.beams, nothing)
    distance, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
    high = points[:, 2]
    counted = (high >= fan.min_height) & (high <= fan.max_height) & (distance >= fan.range_min) & (distance <= fan.range_max)
    counted &= (angle >= fan.angle_min) & (angle <= fan.angle_max)
    beam = ((angle[counted] - fan.angle_min) / fan.angle_increment).astype(int)
    inside = beam < fan.beams
    np.minimum.at(ranges, beam[inside], distance[counted][inside])
    return ranges


def angles_of_image(width: int, fx: float, cx: float) -> tuple[float, float, float]:
    """Return the smallest and greatest angle of an image's columns, and the step between beams, left positive [rad]."""
    greatest, smallest = math.atan2(cx, fx), math.atan2(cx - (width - 1), fx)
    return smallest, greatest, (greatest - smallest) / (width - 1)


def of_depth(depth: Array, fx: float, cx: float, rows: int, middle: float, limits: tuple[float, float]) -> Array:
    """Return ranges from the middle rows of a depth image [m]: the nearest in each beam, NaN without one within limits."""
    height, width = depth.shape
    first = min(max(int(middle - rows / 2), 0), max(height - rows, 0))
    strip = depth[first : first + rows]
    smallest, _, step = angles_of_image(width, fx, cx)
    slope = (np.arange(width) - cx) / fx
    beam = np.clip(((-np.arctan(slope) - smallest) / step + 1e-6).astype(int), 0, width - 1)
    distance = strip * np.hypot(1.0, slope)
    distance = np.where((distance >= limits[0]) & (distance <= limits[1]), distance, np.inf).min(axis=0)
    ranges = np.full(width, np.inf)
    np.minimum.at(ranges, beam, distance)
    return np.where(np.isfinite(ranges), ranges, np.nan)


def points_of(ranges: Array, angle_min: float, angle_increment: float) -> Array:
    """Return the end points of beams in the scan's own frame, (n, 3) [m]."""
    angle = angle_min + np.arange(len(ranges)) * angle_increment
    return np.column_stack([ranges * np.cos(angle), ranges * np.sin(angle), np.zeros(len(ranges))])


def floats(values: Array) -> array[float]:
    """Convert to the array type of messages.

    >>> floats(np.array([1.0, 2.0]))
    array('f', [1.0, 2.0])
    """
    return array("f", values.astype(np.float32).tobytes())
