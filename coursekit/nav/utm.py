"""UTM on WGS 84: the metric plane for a zone of the Earth that maps and navsat_transform_node use."""

from __future__ import annotations

import math
from dataclasses import dataclass

_AXIS, _FLATTENING, _SCALE, _EAST, _SOUTH = 6_378_137.0, 1 / 298.257223563, 0.9996, 500_000.0, 10_000_000.0
_N = _FLATTENING / (2 - _FLATTENING)
_RADIUS = _SCALE * _AXIS / (1 + _N) * (1 + _N**2 / 4 + _N**4 / 64)
_OUT = (_N / 2 - 2 * _N**2 / 3 + 5 * _N**3 / 16, 13 * _N**2 / 48 - 3 * _N**3 / 5, 61 * _N**3 / 240)
_BACK = (_N / 2 - 2 * _N**2 / 3 + 37 * _N**3 / 96, _N**2 / 48 + _N**3 / 15, 17 * _N**3 / 480)
_LATITUDE = (2 * _N - 2 * _N**2 / 3 - 2 * _N**3, 7 * _N**2 / 3 - 8 * _N**3 / 5, 56 * _N**3 / 15)
"""Krueger's series in the third flattening: to the plane, back, and to the latitude; exact to millimetres in a zone."""
_BANDS = "CDEFGHJKLMNPQRSTUVWX"


@dataclass(frozen=True)
class Utm:
    """One zone: 1 to 60, on the northern or the southern hemisphere.

    >>> zone = Utm.at(43.642566, -79.387139)
    >>> [round(one) for one in zone.plane(43.642566, -79.387139)]
    [630084, 4833438]
    """

    zone: int
    north: bool = True

    @classmethod
    def at(cls, latitude: float, longitude: float) -> Utm:
        """Return the zone of a position, including the wide ones of Norway and Svalbard.

        >>> Utm.at(48.1, 11.6), Utm.at(60.4, 5.3)  # Munich; Bergen, in the wide zone of Norway's coast
        (Utm(zone=32, north=True), Utm(zone=32, north=True))
        """
        turned = (longitude + 180.0) % 360.0 - 180.0
        zone = min(60, int((turned + 180.0) // 6) + 1)
        if 56.0 <= latitude < 64.0 and 3.0 <= turned < 12.0:
            zone = 32
        elif 72.0 <= latitude < 84.0 and 0.0 <= turned < 42.0:
            zone = 31 + 2 * int((turned + 3.0) // 12)
        return cls(zone, latitude >= 0.0)

    @classmethod
    def named(cls, name: str) -> Utm:
        """Return the zone with a name such as 17T or 56H; ValueError for an invalid name.

        >>> Utm.named("56H")  # Sydney
        Utm(zone=56, north=False)
        """
        digits, band = name[:-1], name[-1:].upper()
        if not digits.isdecimal() or not 1 <= int(digits) <= 60 or band not in _BANDS:
            raise ValueError(f"'{name}' is no UTM zone: give for example 17T")
        return cls(int(digits), band >= "N")

    def _from_middle(self, longitude: float) -> float:
        return math.radians((longitude - (6 * self.zone - 183) + 180.0) % 360.0 - 180.0)

    def plane(self, latitude: float, longitude: float) -> tuple[float, float]:
        """Convert latitude and longitude [degrees] to east and north [m]."""
        away, sine, root = self._from_middle(longitude), math.sin(math.radians(latitude)), 2 * math.sqrt(_N) / (1 + _N)
        tangent = math.sinh(math.atanh(sine) - root * math.atanh(root * sine))
        up, across = math.atan2(tangent, math.cos(away)), math.asinh(math.sin(away) / math.hypot(tangent, math.cos(away)))
        north, east = up, across
        for j, part in enumerate(_OUT, 1):
            north += part * math.sin(2 * j * up) * math.cosh(2 * j * across)
            east += part * math.cos(2 * j * up) * math.sinh(2 * j * across)
        return _EAST + _RADIUS * east, (0.0 if self.north else _SOUTH) + _RADIUS * north

    def place(self, east: float, north: float) -> tuple[float, float]:
        """Convert east and north [m] to latitude and longitude [degrees].

        >>> [round(one, 6) for one in Utm.named("17T").place(630084.3, 4833438.5)]  # Toronto's tower
        [43.642566, -79.387139]
        """
        up, across = (north - (0.0 if self.north else _SOUTH)) / _RADIUS, (east - _EAST) / _RADIUS
        high, wide = up, across
        for j, part in enumerate(_BACK, 1):
            high -= part * math.sin(2 * j * up) * math.cosh(2 * j * across)
            wide -= part * math.cos(2 * j * up) * math.sinh(2 * j * across)
        ball = math.asin(math.sin(high) / math.cosh(wide))
        latitude = ball + sum(part * math.sin(2 * j * ball) for j, part in enumerate(_LATITUDE, 1))
        longitude = math.degrees(math.atan2(math.sinh(wide), math.cos(high))) + 6 * self.zone - 183
        return math.degrees(latitude), (longitude + 180.0) % 360.0 - 180.0

    def convergence(self, latitude: float, longitude: float) -> float:
        """Return the angle from true north to the plane's north, clockwise [rad].

        >>> zone = Utm.at(48.0, 11.0)  # its middle is at 9 degrees
        >>> [round(math.degrees(zone.convergence(48.0, longitude)), 3) for longitude in (9.0, 11.0)]
        [0.0, 1.487]
        """
        return math.atan(math.tan(self._from_middle(longitude)) * math.sin(math.radians(latitude)))


__all__ = ["Utm"]
