"""A LiDAR: its beams, range and errors."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from coursekit.geometry.plane import ORIGIN, Array, Pose2D

from .errors import WorldError
from .rays import cast, directions
from .solids import Cut

MOST_BEAMS = 100_000


@dataclass(frozen=True)
class Lidar:
    """A planar LiDAR. Beam k points at `angle_min + k * step`; distances in metres, `rate` in scans per second.

    `noise` is the standard deviation of Gaussian noise around the true distance plus `bias`; `dropouts` is the share of
    beams without a return; `resolution` is the rounding step of distances, 0 for none.

    >>> Lidar(beams=4, angle_min=0.0, angle_max=3 * math.pi / 2).step == math.pi / 2
    True
    """

    beams: int = 360
    angle_min: float = 0.0
    angle_max: float = 2 * math.pi * 359 / 360
    range_min: float = 0.12
    range_max: float = 10.0
    rate: float = 10.0
    noise: float = 0.0
    bias: float = 0.0
    dropouts: float = 0.0
    resolution: float = 0.0
    mount: Pose2D = ORIGIN
    """Its pose on the robot, seen from above."""
    height: float = 0.2
    """Height of its plane above the floor."""
    upside_down: bool = False
    """Mounted upside down: it rotates clockwise as seen from above."""
    _beams: Array = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        _check(self)
        object.__setattr__(self, "_beams", directions(*self._ascending(), self.beams))

    @property
    def step(self) -> float:
        """The angle from one beam to the next; negative for a clockwise rotation."""
        return (self.angle_max - self.angle_min) / (self.beams - 1) if self.beams > 1 else 0.0

    def _ascending(self) -> tuple[float, float]:
        """Return the first angle and the step of the simulated sweep, counter-clockwise."""
        low = min(self.angle_min, self.angle_max)
        if self.upside_down:
            low = -max(self.angle_min, self.angle_max)
        return low, abs(self.step) or 1.0

    def bearings(self) -> Array:
        """Return the angles (beams) of the distances from `look`, counter-clockwise from its mount's x [rad]."""
        low, step = self._ascending()
        return np.asarray(low + step * np.arange(self.beams), np.float64)

    def look(self, cut: Cut, place: Pose2D, ranges: Array | None = None) -> Array:
        """Return true distances (beams) from `place` to a cut; inf where there is nothing.

        An edge that comes nearer than `range_max` is cast in full length: `measure` drops what is too far.
        `ranges` of another cut are shortened, so static and moving objects can be cast in turn.

        >>> from coursekit.sim.solids import Disc
        >>> lidar = Lidar(beams=4, angle_min=0.0, angle_max=3 * math.pi / 2)
        >>> lidar.look(Disc(3.0, 0.0, 0.5).cut(0.2), Pose2D(1.0, 0.0, 0.0)).tolist()
        [1.5, inf, inf, inf]
        """
        if ranges is None:
            ranges = np.full(self.beams, np.inf)
        cast(ranges, self._beams, *self._ascending(), *place, cut.edges, cut.circles, self.range_max)
        return ranges

    def measure(self, ranges: Array, chance: np.random.Generator) -> Array:
        """Return the measured ranges (beams) [m], noisy and in the LiDAR's order.

        Nothing in range is inf, and what is nearer than `range_min` is -inf (REP 117).

        >>> lidar = Lidar(beams=3, range_min=0.2, range_max=8.0, resolution=0.5)
        >>> lidar.measure(np.array([0.1, 1.7, 9.0]), np.random.default_rng(0)).tolist()
        [-inf, 1.5, inf]
        """
        if (self.step < 0) != self.upside_down:
            ranges = ranges[::-1]
        seen = ranges.copy()
        if self.noise or self.bias:
            seen += self.bias + self.noise * chance.standard_normal(self.beams)
        if self.resolution:
            seen = np.round(seen / self.resolution) * self.resolution
        if self.dropouts:
            seen[chance.random(self.beams) < self.dropouts] = np.inf
        seen[ranges > self.range_max] = np.inf
        seen[seen > self.range_max] = np.inf
        seen[seen < self.range_min] = -np.inf
        return seen


def _check(lidar: Lidar) -> None:
    numbers = (lidar.angle_min, lidar.angle_max, lidar.range_min, lidar.range_max, lidar.rate, lidar.noise, lidar.bias)
    faults = {
        "its numbers must be finite": not all(math.isfinite(number) for number in numbers),
        f"it has {lidar.beams} beams; it needs 1 to {MOST_BEAMS}": not 1 <= lidar.beams <= MOST_BEAMS,
        "it must see less than, or just, a full turn": abs(lidar.angle_max - lidar.angle_min) > 2 * math.pi + 1e-3,
        "range_max must be more than range_min, and range_min not below 0": not 0 <= lidar.range_min < lidar.range_max,
        "noise must not be below 0, nor dropouts beyond 0 to 1": lidar.noise < 0 or not 0 <= lidar.dropouts <= 1,
        "its rate must be more than 0": not lidar.rate > 0,
        "several beams cannot have the same angle": lidar.beams > 1 and lidar.angle_min == lidar.angle_max,
    }
    for what, wrong in faults.items():
        if wrong:
            raise WorldError(what, element="LiDAR", cure="Change the numbers of the ray sensor.")


__all__ = ["Lidar"]
