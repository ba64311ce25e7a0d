"""Conversion between the Earth and a robot's world: a plane in metres, and its pose in that world."""

from __future__ import annotations

import math
from dataclasses import dataclass

from coursekit.geometry.pose import Pose, Vector, compose, inverse
from coursekit.nav.utm import Utm
from coursekit.sim.spherical_coordinates import SphericalCoordinates

Fix = tuple[float, float, float]
"""Latitude and longitude [degrees] and altitude [m]."""


@dataclass
class Plane:
    """A UTM zone, or the tangent plane at a position on the Earth; `frame` is its name in tf."""

    of: Utm | SphericalCoordinates

    @property
    def frame(self) -> str:
        """The plane's name in tf."""
        return "utm" if isinstance(self.of, Utm) else "local_enu"

    def at(self, fix: Fix) -> Vector:
        """East, north and up [m] of a position on the Earth."""
        latitude, longitude, altitude = fix
        if isinstance(self.of, Utm):
            return (*self.of.plane(latitude, longitude), altitude)
        return self.of.place(latitude, longitude, altitude)

    def fix(self, point: Vector) -> Fix:
        """The position on the Earth of a point."""
        if isinstance(self.of, Utm):
            return (*self.of.place(point[0], point[1]), point[2])
        return self.of.fix(*point)

    def convergence(self, fix: Fix) -> float:
        """The angle from true north to the plane's north at a position, clockwise [rad]."""
        return self.of.convergence(*fix[:2]) if isinstance(self.of, Utm) else 0.0


@dataclass
class Bridge:
    """The plane's pose in the world: `pose` transforms its coordinates to those of the world."""

    plane: Plane
    pose: Pose

    def to_world(self, fix: Fix) -> Vector:
        """Convert a position on the Earth to a point of the world [m]."""
        return compose(self.pose, (*self.plane.at(fix), 0.0, 0.0, 0.0, 1.0))[:3]

    def to_earth(self, point: Vector) -> Fix:
        """Convert a point of the world [m] to a position on the Earth."""
        return self.plane.fix(compose(inverse(self.pose), (*point, 0.0, 0.0, 0.0, 1.0))[:3])


def plane_at(fix: Fix, *, local: bool, zone: str = "") -> Plane:
    """The plane at a position: its tangent plane, its UTM zone, or the UTM zone of that name."""
    if local:
        return Plane(SphericalCoordinates(*fix))
    return Plane(Utm.named(zone) if zone else Utm.at(*fix[:2]))


def is_place(fix: Fix) -> bool:
    """Whether this is a valid position on the Earth.

    >>> is_place((19.0, -99.0, 2240.0)), is_place((math.nan, 0.0, 0.0))
    (True, False)
    """
    return all(map(math.isfinite, fix)) and abs(fix[0]) <= 90.0


__all__ = ["Bridge", "Fix", "Plane", "is_place", "plane_at"]
