"""Positions and headings in the plane, SE(2): one at a time as `Pose2D`, many at a time as arrays of shape (n, 3)."""

from __future__ import annotations

import math
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Angle = TypeVar("Angle", float, Array)


def wrap(angle: Angle) -> Angle:
    """The same angle, or array of angles, in [-pi, pi) [rad].

    >>> round(wrap(3 * math.pi / 2), 4), wrap(np.array([0.0, 2 * np.pi + 0.5])).round(4).tolist()
    (-1.5708, [0.0, 0.5])
    """
    return (angle + math.pi) % (2 * math.pi) - math.pi


class Pose2D(NamedTuple):
    """A position [m] and heading [rad]; also the motion from one pose to another. In ROS 2: geometry_msgs/Pose2D.

    >>> Pose2D(1.0, 2.0, math.pi / 2) @ Pose2D(1.0, 0.0, 0.0) == Pose2D(1.0, 3.0, math.pi / 2)
    True
    """

    x: float = 0.0
    y: float = 0.0
    theta: float = 0.0

    def __matmul__(self, other: Pose2D) -> Pose2D:
        """This pose followed by the motion `other` in its frame."""
        c, s = math.cos(self.theta), math.sin(self.theta)
        return Pose2D(
            self.x + c * other.x - s * other.y,
            self.y + s * other.x + c * other.y,
            wrap(self.theta + other.theta),
        )

    def inverse(self) -> Pose2D:
        """The inverse motion.

        >>> pose = Pose2D(1.0, 2.0, 0.5)
        >>> bool(np.allclose(pose @ pose.inverse(), 0))
        True
        """
        c, s = math.cos(self.theta), math.sin(self.theta)
        return Pose2D(-c * self.x - s * self.y, s * self.x - c * self.y, wrap(-self.theta))

    def to(self, other: Pose2D) -> Pose2D:
        """The motion from this pose to `other`: `self @ self.to(other) == other`.

        >>> Pose2D(1.0, 1.0, 0.0).to(Pose2D(3.0, 0.0, 0.5))
        Pose2D(x=2.0, y=-1.0, theta=0.5)
        """
        return self.inverse() @ other

    def distance(self, other: Pose2D) -> float:
        """Straight-line distance between the positions [m].

        >>> Pose2D(1.0, 1.0, 0.5).distance(Pose2D(4.0, 5.0, -2.0))
        5.0
        """
        return math.hypot(other.x - self.x, other.y - self.y)

    def transform(self, points: Array) -> Array:
        """Transform points (n, 2) [m] from this pose's frame to the frame in which the pose is given.

        >>> Pose2D(1.0, 2.0, math.pi / 2).transform([[3.0, 0.0]]).round(6).tolist()  # 3 m ahead, looking along y
        [[1.0, 5.0]]
        """
        return np.asarray(points, float) @ rotation(self.theta).T + np.array([self.x, self.y])

    @classmethod
    def of(cls, values: Any) -> Pose2D:
        """Build a pose from any three numbers: x, y [m] and the heading [rad], which is wrapped.

        Raises ValueError for more or fewer than three.

        >>> Pose2D.of(np.array([1.0, 2.0, 2 * math.pi]))
        Pose2D(x=1.0, y=2.0, theta=0.0)
        """
        x, y, theta = values
        return cls(float(x), float(y), wrap(float(theta)))


def rotation(theta: float) -> Array:
    """The 2 x 2 rotation matrix.

    >>> rotation(math.pi / 2).round(6).tolist()
    [[0.0, -1.0], [1.0, 0.0]]
    """
    c, s = math.cos(theta), math.sin(theta)
    return np.array([[c, -s], [s, c]])


def compose(first: Array, second: Array) -> Array:
    """`first @ second`, row by row, for shapes (n, 3); either may be (3,).

    >>> ahead, left = np.array([2.0, 0.0, 0.0]), np.array([1.0, 0.0, math.pi / 2])
    >>> compose(left, ahead).round(3).tolist()
    [1.0, 2.0, 1.571]
    """
    first, second = np.asarray(first, float), np.asarray(second, float)
    c, s = np.cos(first[..., 2]), np.sin(first[..., 2])
    x = first[..., 0] + c * second[..., 0] - s * second[..., 1]
    y = first[..., 1] + s * second[..., 0] + c * second[..., 1]
    return np.stack([x, y, wrap(first[..., 2] + second[..., 2])], axis=-1)


def between(first: Array, second: Array) -> Array:
    """`first.to(second)`, row by row.

    >>> between(np.array([[1.0, 1.0, np.pi / 2]]), np.array([[1.0, 3.0, np.pi / 2]])).round(6) + 0.0
    array([[2., 0., 0.]])
    """
    first, second = np.asarray(first, float), np.asarray(second, float)
    c, s = np.cos(first[..., 2]), np.sin(first[..., 2])
    dx, dy = second[..., 0] - first[..., 0], second[..., 1] - first[..., 1]
    return np.stack([c * dx + s * dy, c * dy - s * dx, wrap(second[..., 2] - first[..., 2])], axis=-1)


ORIGIN = Pose2D()
