"""One laser scan: its valid ranges, their hits, and the normals of the walls there."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from coursekit.geometry.plane import Array, Pose2D
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan_kernels import fill_walls, normals_of, thin, usual_gap

HERE = Pose2D()
"""The laser is at the centre of the robot, and faces forward."""


@dataclass(frozen=True)
class Laser:
    """The sensor's properties. In ROS 2: the fields of sensor_msgs/LaserScan and the transform base → laser.

    >>> Laser(angle_min=-1.0, angle_increment=0.5, range_max=10.0).angles(5)
    array([-1. , -0.5,  0. ,  0.5,  1. ])
    """

    angle_min: float
    angle_increment: float
    range_min: float = 0.0
    range_max: float = math.inf
    """Ranges from here on mean no return."""
    offset: Pose2D = HERE
    """The laser's pose on the robot."""
    flipped: bool = False
    """Mounted upside down: the beams rotate in the opposite direction."""

    def angles(self, count: int) -> Array:
        """Return the direction of each beam in the laser's frame [rad]."""
        angles: Array = self.angle_min + self.angle_increment * np.arange(count, dtype=np.float64)
        return -angles if self.flipped else angles

    @classmethod
    def half_circle(cls, count: int, range_max: float = math.inf, offset: Pose2D = HERE) -> Laser:
        """The 180° lasers of old logs: even counts from -90° on without the last end; odd counts with both ends.

        >>> np.degrees(Laser.half_circle(180).angles(180)[[0, -1]]).round(6).tolist()
        [-90.0, 89.0]
        >>> np.degrees(Laser.half_circle(181).angles(181)[[0, -1]]).round(6).tolist()
        [-90.0, 90.0]
        """
        steps = count - 1 if count % 2 else count
        return cls(-math.pi / 2, math.pi / max(steps, 1), range_max=range_max, offset=offset)


@lru_cache(maxsize=16)
def _directions(laser: Laser, count: int) -> Array:
    """Unit vectors (count, 2) along the beams, in the robot's frame."""
    angles = laser.angles(count) + laser.offset.theta
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


@dataclass(frozen=True, eq=False)
class Scan:
    """The points of a scan in the robot's frame, sorted by their bearing from the laser."""

    stamp: float
    origin: Pose2D
    """The laser's pose on the robot."""
    hits: Array
    """(n, 2) end points of beams [m]."""
    misses: Array
    """(m, 2) points up to which beams without return have cleared [m]."""
    points: Array
    """(k, 2) hits for matching: within range, and thinned where they are dense."""
    normals: Array
    """(k, 2) unit normals of the wall at each point; zero where there is no clear wall."""
    filled: Array
    """(f, 2) points between those of `points` on the same wall: with few beams, walls are still drawn without gaps."""
    filled_normals: Array

    @cached_property
    def polar(self) -> tuple[Array, Array]:
        """Bearing [rad] and distance [m] of each hit from the laser, in order of bearing.

        >>> bearings, distances = Scan.from_points(np.array([[0.0, 2.0], [3.0, 0.0]]), SlamParameters()).polar
        >>> bearings.round(3).tolist(), distances.tolist()
        ([0.0, 1.571], [3.0, 2.0])
        """
        x, y = (self.hits - np.array([self.origin.x, self.origin.y])).T
        return np.arctan2(y, x), np.hypot(x, y)

    @classmethod
    def from_ranges(
        cls, ranges: Sequence[float] | np.ndarray, laser: Laser, params: SlamParameters, stamp: float = 0.0
    ) -> Scan:
        """Build from ranges [m]; NaN, negative, zero and too small ones are dropped, the maximum and inf mean no return.

        >>> scan = Scan.from_ranges([1.0, float("nan"), 0.0, float("inf"), 2.0], Laser(0.0, 0.1), SlamParameters())
        >>> len(scan.hits)
        2
        """
        values = np.asarray(ranges, dtype=np.float64).reshape(-1)
        with np.errstate(invalid="ignore"):
            good = (
                (values > max(laser.range_min, params.range_min))
                & (values < laser.range_max)
                & np.isfinite(values)
            )
            nothing = (values >= laser.range_max) | np.isposinf(values)
        centre = np.array([laser.offset.x, laser.offset.y])
        directions = _directions(laser, len(values))
        hits = centre + directions[good] * values[good, None]
        clear = min(params.clear_no_return, laser.range_max)
        misses = centre + directions[nothing] * clear if clear > 0 else np.zeros((0, 2))
        return cls.from_points(hits, params, origin=laser.offset, stamp=stamp, misses=misses)

    @classmethod
    def from_points(
        cls,
        points: Array,
        params: SlamParameters,
        *,
        origin: Pose2D = HERE,
        stamp: float = 0.0,
        misses: Array | None = None,
    ) -> Scan:
        """Build from points (n, 2) in the robot's frame [m], in any order.

        >>> scan = Scan.from_points(np.array([[2.0, 1.0], [2.0, -1.0], [2.0, 0.0]]), SlamParameters())
        >>> scan.hits[:, 1].tolist()  # by bearing, clockwise ones first
        [-1.0, 0.0, 1.0]
        """
        hits = np.asarray(points, dtype=np.float64).reshape(-1, 2)
        hits = hits[np.isfinite(hits).all(axis=1)]
        relative = hits - np.array([origin.x, origin.y])
        bearings = np.arctan2(relative[:, 1], relative[:, 0])
        order = np.argsort(bearings, kind="stable")
        hits, bearings = np.ascontiguousarray(hits[order]), bearings[order]
        distances = np.hypot(relative[order, 0], relative[order, 1])
        spacing = usual_gap(bearings)
        slope = max(0.02, min(2.5 * spacing, 0.5))  # two neighbours on either side of a wall across the beams
        normals = normals_of(hits, distances, params.normal_reach, slope)
        normals[np.einsum("ij,ij->i", normals, relative[order]) > 0] *= -1  # towards the laser
        near = distances < params.match_range
        keep = thin(hits, near, params.point_spacing)
        filled, directions = fill_walls(hits[keep], normals[keep], params.point_spacing, params.fill_widest)
        none = np.zeros((0, 2)) if misses is None else misses
        return cls(stamp, origin, hits, none, hits[keep], normals[keep], filled, directions)
