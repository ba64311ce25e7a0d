"""The outline of a robot, seen from above."""

from __future__ import annotations

import ast
import math

import numpy as np

CORNERS_OF_A_DISC = 16


class Footprint:
    """A polygon (n, 2) about the robot's centre [m]; `inscribed` and `circumscribed` are its radii.

    >>> box = Footprint.parse("[[0.2, 0.1], [0.2, -0.1], [-0.2, -0.1], [-0.2, 0.1]]")
    >>> box.inscribed, round(box.circumscribed, 3), box.round
    (0.1, 0.224, False)
    >>> Footprint.disc(0.22).inscribed
    0.22
    """

    def __init__(self, corners: np.ndarray, *, radius: float | None = None) -> None:
        self.corners = np.asarray(corners, dtype=float)
        self.round = radius is not None
        self.inscribed = radius if radius is not None else _nearest(self.corners)
        self.circumscribed = radius if radius is not None else float(np.hypot(*self.corners.T).max())

    @classmethod
    def disc(cls, radius: float) -> Footprint:
        """Return the footprint of a round robot; ValueError unless the radius is from 0 to 100 m.

        >>> Footprint.disc(22.0 * 10)
        Traceback (most recent call last):
        ValueError: robot_radius is 220.0: give metres, for example 0.22
        """
        if not 0 < radius < 100:
            raise ValueError(f"robot_radius is {radius}: give metres, for example 0.22")
        angles = np.arange(CORNERS_OF_A_DISC) * 2 * math.pi / CORNERS_OF_A_DISC
        return cls(radius * np.column_stack([np.cos(angles), np.sin(angles)]), radius=radius)

    @classmethod
    def parse(cls, text: str) -> Footprint:
        """Parse the corners in a parameter file; ValueError when they do not form an outline around the centre."""
        fault = f"footprint {text!r}: write at least three corners, for example '[[0.2, 0.1], [0.2, -0.1], [-0.2, 0.0]]'"
        try:
            corners = np.array(ast.literal_eval(text), dtype=float)
        except (ValueError, SyntaxError, TypeError, MemoryError, RecursionError):
            raise ValueError(fault) from None
        if corners.ndim != 2 or corners.shape[1] != 2 or len(corners) < 3 or not np.isfinite(corners).all():
            raise ValueError(fault)
        return cls(corners)

    def padded(self, padding: float) -> Footprint:
        """Move each corner outwards by `padding` [m] along both axes, as nav2 does.

        >>> Footprint.parse("[[0.2, 0.1], [0.2, -0.1], [-0.2, 0.0]]").padded(0.01).corners.round(2).tolist()
        [[0.21, 0.11], [0.21, -0.11], [-0.21, 0.0]]
        """
        if self.round:
            return Footprint.disc(self.inscribed + padding)
        return Footprint(self.corners + np.sign(self.corners) * padding)

    def at(self, x: float, y: float, yaw: float) -> np.ndarray:
        """Return the corners (n, 2) for the robot at a pose [m, rad].

        >>> Footprint.parse("[[0.2, 0.1], [0.2, -0.1], [-0.2, 0.0]]").at(1.0, 2.0, math.pi / 2).round(3).tolist()
        [[0.9, 2.2], [1.1, 2.2], [1.0, 1.8]]
        """
        c, s = math.cos(yaw), math.sin(yaw)
        return self.corners @ np.array([[c, s], [-s, c]]) + (x, y)

    def outline(self, step: float) -> np.ndarray:
        """Return points (m, 2) on the edges, at most `step` metres apart.

        A round robot has none: for it the centre suffices.

        >>> triangle = Footprint.parse("[[0.2, 0.2], [0.2, -0.2], [-0.2, 0.0]]")
        >>> len(triangle.outline(0.1)), len(Footprint.disc(0.22).outline(0.1))
        (14, 0)
        """
        if self.round:
            return np.zeros((0, 2))
        points = []
        for a, b in zip(np.roll(self.corners, 1, axis=0), self.corners, strict=True):
            count = max(math.ceil(float(np.hypot(*(b - a))) / step), 1)
            points += [a + (b - a) * k / count for k in range(count)]
        return np.array(points)


def _nearest(corners: np.ndarray) -> float:
    """Return the distance from the centre to the nearest edge."""
    before, edge = np.roll(corners, 1, axis=0), corners - np.roll(corners, 1, axis=0)
    along = np.clip(-(before * edge).sum(axis=1) / np.maximum((edge**2).sum(axis=1), 1e-12), 0, 1)
    return float(np.hypot(*(before + along[:, None] * edge).T).min())
