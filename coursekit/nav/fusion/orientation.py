"""The orientation of a body from its gyroscope, corrected by gravity and by a magnetometer."""

from __future__ import annotations

import math
from collections.abc import Callable

from coursekit.geometry.pose import Quaternion, Vector, multiply, rotate
from coursekit.geometry.rotation import quaternion_of, rpy_of

NORTHS = {"enu": (math.pi / 2, 1.0), "nwu": (0.0, 1.0), "ned": (0.0, -1.0)}
"""The world conventions: the angle of north [rad], and the direction of gravity's reaction along z."""
Correction = Callable[[float, float], float]
"""Returns the correction angle in a step of dt seconds for an error angle [rad]."""


def steadily(gain: float) -> Correction:
    """Madgwick's correction: the error shrinks at a constant rate, `gain` in his equations, however large it is."""
    return lambda error, dt: min(2.0 * gain * dt, error)


def by_share(gain: float) -> Correction:
    """A complementary filter's correction: each step removes a share of the error."""
    return lambda error, dt: gain * error


class Orientation:
    """The rotation from the body's frame to the world's, as a quaternion.

    >>> held = Orientation(steadily(0.1))
    >>> held.step((0.0, 0.0, 0.5), (0.0, 0.0, 9.8), None, 0.1) is held.q
    True
    >>> for _ in range(20):
    ...     q = held.step((0.0, 0.0, 0.5), (0.0, 0.0, 9.8), None, 0.1)
    >>> [round(one, 3) for one in rpy_of(q)]
    [0.0, 0.0, 1.0]
    """

    def __init__(self, correct: Correction, world: str = "enu", aim: Correction | None = None) -> None:
        """`aim` corrects the heading, if it needs another correction."""
        self._correct, self._aimed, (self._north, self._up) = correct, aim or correct, NORTHS[world]
        self.q: Quaternion | None = None

    def step(self, turning: Vector, pushed: Vector, north: Vector | None, dt: float) -> Quaternion:
        """Process measurements in the body's frame: angular velocity [rad/s], acceleration [m/s^2], the magnetic field."""
        if self.q is None:
            self.q = self._first(pushed, north)
            return self.q
        self.q = _unit(multiply(self.q, _turn(turning, _size(turning) * dt)))
        self._level(pushed, dt)
        if north is not None:
            self._aim(north, dt)
        return self.q

    def _first(self, pushed: Vector, north: Vector | None) -> Quaternion:
        x, y, z = (part * self._up for part in pushed)
        q = quaternion_of((math.atan2(y, z), math.atan2(-x, math.hypot(y, z)), 0.0))
        return q if north is None else multiply(_turn((0.0, 0.0, 1.0), self._off(q, north)), q)

    def _level(self, pushed: Vector, dt: float) -> None:
        """Rotate so that the measured vertical approaches the world's."""
        assert self.q is not None
        x, y, z = (part * self._up for part in rotate(self.q, pushed))
        if not _size((x, y, z)):
            return
        error = math.atan2(math.hypot(x, y), z)
        axis = (y, -x, 0.0) if x or y else (1.0, 0.0, 0.0)
        self.q = _unit(multiply(_turn(axis, self._correct(error, dt)), self.q))

    def _aim(self, north: Vector, dt: float) -> None:
        """Rotate about the world's z so that the magnetometer's north approaches the world's."""
        assert self.q is not None
        error = self._off(self.q, north)
        back = math.copysign(self._aimed(abs(error), dt), error)
        self.q = _unit(multiply(_turn((0.0, 0.0, 1.0), back), self.q))

    def _off(self, q: Quaternion, north: Vector) -> float:
        x, y, _ = rotate(q, north)
        return math.remainder(self._north - math.atan2(y, x), 2 * math.pi)


def _size(v: Vector) -> float:
    return math.sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2)


def _turn(axis: Vector, angle: float) -> Quaternion:
    size = _size(axis) or 1.0
    s = math.sin(angle / 2) / size
    return axis[0] * s, axis[1] * s, axis[2] * s, math.cos(angle / 2)


def _unit(q: Quaternion) -> Quaternion:
    size = math.sqrt(sum(part * part for part in q))
    return q[0] / size, q[1] / size, q[2] / size, q[3] / size


__all__ = ["NORTHS", "Orientation", "by_share", "rpy_of", "steadily"]
