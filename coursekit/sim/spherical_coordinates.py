"""The location of a world on the Earth: latitude, longitude and altitude (WGS 84), and the air pressure."""

from __future__ import annotations

import math
from dataclasses import dataclass

_AXIS, _FLATTENING = 6_378_137.0, 1 / 298.257223563
"""The ellipsoid of WGS 84: semi-major axis [m] and flattening."""
_SQUARED = _FLATTENING * (2 - _FLATTENING)


@dataclass(frozen=True)
class SphericalCoordinates:
    """The origin of a world: latitude, longitude and the heading of its x axis from east in degrees, elevation in metres.

    >>> latitude, longitude, altitude = SphericalCoordinates(48.0, 11.0, 500.0).fix(0.0, 0.0)
    >>> round(latitude, 9), round(longitude, 9), round(altitude, 6)
    (48.0, 11.0, 500.0)
    """

    latitude: float = 0.0
    longitude: float = 0.0
    elevation: float = 0.0
    heading: float = 0.0

    def fix(self, x: float, y: float, z: float = 0.0) -> tuple[float, float, float]:
        """Convert a position in the world [m] to latitude and longitude [degrees] and altitude [m].

        >>> latitude, longitude, _ = SphericalCoordinates(48.0, 11.0).fix(0.0, 1000.0)
        >>> round(latitude, 5), round(longitude, 5)
        (48.00899, 11.0)
        """
        turn, lat, lon = map(math.radians, (self.heading, self.latitude, self.longitude))
        east, north = x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)
        out, up = _north(lat, self.elevation)
        out, up = out + z * math.cos(lat) - north * math.sin(lat), up + z * math.sin(lat) + north * math.cos(lat)
        away = math.hypot(out, east)
        latitude, altitude = _geodetic(away, up)
        return math.degrees(latitude), math.degrees(lon + math.atan2(east, out)), altitude

    def place(self, latitude: float, longitude: float, altitude: float = 0.0) -> tuple[float, float, float]:
        """Convert latitude, longitude [degrees] and altitude [m] to a position in the world [m], the inverse of `fix`.

        >>> munich = SphericalCoordinates(48.0, 11.0)
        >>> [round(one, 1) + 0.0 for one in munich.place(48.001, 11.0)]  # a thousandth of a degree is 111 m
        [0.0, 111.2, 0.0]
        """
        turn, lat, swing = map(math.radians, (self.heading, self.latitude, longitude - self.longitude))
        away, height = _north(math.radians(latitude), altitude)
        here, level = _north(lat, self.elevation)
        out, east, up = away * math.cos(swing) - here, away * math.sin(swing), height - level
        north, z = up * math.cos(lat) - out * math.sin(lat), out * math.cos(lat) + up * math.sin(lat)
        return east * math.cos(turn) + north * math.sin(turn), north * math.cos(turn) - east * math.sin(turn), z


def _north(latitude: float, altitude: float) -> tuple[float, float]:
    """Return the distance from the Earth's axis, and the height above the equator's plane [m]."""
    normal = _AXIS / math.sqrt(1 - _SQUARED * math.sin(latitude) ** 2)
    return (normal + altitude) * math.cos(latitude), (normal * (1 - _SQUARED) + altitude) * math.sin(latitude)


def _geodetic(away: float, up: float) -> tuple[float, float]:
    """Return latitude [rad] and altitude [m] of a point at this distance from the axis and above the equator's plane."""
    latitude = math.atan2(up, away * (1 - _SQUARED))
    for _ in range(5):  # each step gains three digits
        normal = _AXIS / math.sqrt(1 - _SQUARED * math.sin(latitude) ** 2)
        latitude = math.atan2(up + _SQUARED * normal * math.sin(latitude), away)
    here, there = _north(latitude, 0.0)
    return latitude, (away - here) * math.cos(latitude) + (up - there) * math.sin(latitude)


def pressure(altitude: float) -> float:
    """Return the air pressure [Pa] at an altitude [m] of the standard atmosphere, up to 11 km.

    >>> pressure(0.0), round(pressure(1000.0))
    (101325.0, 89874)
    """
    return 101_325.0 * max(0.0, 1 - 0.0065 * altitude / 288.15) ** 5.2561


__all__ = ["SphericalCoordinates", "pressure"]
