"""A virtual trackball on the screen that the mouse rotates."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from .quaternions import quaternion_from_matrix, quaternion_matrix, quaternion_multiply, quaternion_slerp
from .vectors import EPS, Array, Matrix, Vector, unit_vector, vector_norm


class Arcball:
    """A virtual trackball; `initial` is a quaternion or a 4x4 rotation.

    >>> ball = Arcball()
    >>> ball.place([320, 320], 320)
    >>> ball.down([500, 250]); ball.drag([475, 275])
    >>> round(float(ball.matrix().sum()), 6)
    3.905835
    """

    def __init__(self, initial: Vector | Matrix | None = None) -> None:
        self._axis: Any = None
        self._axes: list[Array] | None = None
        self._radius = 1.0
        self._center = [0.0, 0.0]
        self._vdown = np.array((0.0, 0.0, 1.0))
        self._constrain = False
        given = np.array((0, 0, 0, 1) if initial is None else initial, dtype=np.float64)
        if given.shape == (4, 4):
            self._qdown: Any = quaternion_from_matrix(given)
        elif given.shape == (4,):
            self._qdown = given / vector_norm(given)
        else:
            raise ValueError("initial not a quaternion or matrix.")
        self._qnow = self._qpre = self._qdown

    def place(self, center: Vector, radius: float) -> None:
        """Set the ball's position and radius in the window."""
        self._radius = float(radius)
        self._center = [center[0], center[1]]

    def setaxes(self, *axes: Vector) -> None:
        """Set the axes of constrained rotation; without axes, any axis is allowed."""
        self._axes = [unit_vector(axis) for axis in axes] or None

    def setconstrain(self, constrain: bool) -> None:
        """Constrain the rotation to the axes, or allow any rotation."""
        self._constrain = constrain is True

    def getconstrain(self) -> bool:
        """Whether the rotation is constrained to the axes."""
        return self._constrain

    def down(self, point: Vector) -> None:
        """Start a drag at a point."""
        self._vdown = arcball_map_to_sphere(point, self._center, self._radius)
        self._qdown = self._qpre = self._qnow
        self._axis = None
        if self._constrain and self._axes is not None:
            self._axis = arcball_nearest_axis(self._vdown, self._axes)
            self._vdown = arcball_constrain_to_axis(self._vdown, self._axis)

    def drag(self, point: Vector) -> None:
        """Rotate the ball for a mouse movement to a point."""
        now = arcball_map_to_sphere(point, self._center, self._radius)
        if self._axis is not None:
            now = arcball_constrain_to_axis(now, self._axis)
        self._qpre = self._qnow
        turn = np.cross(self._vdown, now)
        if turn @ turn < EPS:
            self._qnow = self._qdown
        else:
            self._qnow = quaternion_multiply((*turn, float(self._vdown @ now)), self._qdown)

    def next(self, acceleration: float = 0.0) -> None:
        """Continue the rotation of the last drag."""
        following = quaternion_slerp(self._qpre, self._qnow, 2.0 + acceleration, 0)
        self._qpre, self._qnow = self._qnow, following

    def matrix(self) -> Array:
        """The current 4x4 rotation."""
        return quaternion_matrix(self._qnow)


def arcball_map_to_sphere(point: Vector, center: Vector, radius: float) -> Array:
    """The point of the unit sphere under a point of the window."""
    x, y = (point[0] - center[0]) / radius, (center[1] - point[1]) / radius
    outside = x * x + y * y
    if outside > 1.0:
        return np.array((x, y, 0.0)) / math.sqrt(outside)
    return np.array((x, y, math.sqrt(1.0 - outside)))


def arcball_constrain_to_axis(point: Vector, axis: Vector) -> Array:
    """The nearest point of the sphere that is perpendicular to the axis."""
    a = np.asarray(axis, dtype=np.float64)
    v = np.asarray(point, dtype=np.float64)
    v = v - a * (a @ v)
    length = vector_norm(v)
    if length > EPS:
        result: Array = v / (-length if v[2] < 0.0 else length)
        return result
    return np.array((1.0, 0.0, 0.0)) if a[2] == 1.0 else unit_vector((-a[1], a[0], 0.0))


def arcball_nearest_axis(point: Vector, axes: Iterable[Any]) -> Any:
    """The axis whose great circle passes nearest to the point."""
    place = np.asarray(point, dtype=np.float64)
    return max(axes, key=lambda axis: float(arcball_constrain_to_axis(place, axis) @ place), default=None)
