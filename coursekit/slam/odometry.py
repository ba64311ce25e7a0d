"""Online calibration of wheel odometry: its scale, and its pull to one side."""

from __future__ import annotations

import math

import numpy as np

from coursekit.geometry.plane import Pose2D

MEMORY = 10.0
"""The distance over which older experience is forgotten [m]; a radian of rotation counts as a metre."""
RIDGE = 0.2
"""Regularization: the amount of motion [m², rad²] at which the estimate outweighs the assumption of perfect odometry."""
MOST = 2.0
"""Limits: scales between 1 / MOST and MOST, pulls up to 1 rad/m."""


class Calibration:
    """Corrects odometry motions with factors learnt from earlier matches.

    >>> wheels = Calibration()
    >>> for _ in range(500):
    ...     wheels.learn(Pose2D(0.12, 0.0, 0.0), Pose2D(0.1, 0.0, 0.01))
    >>> right = wheels.correct(Pose2D(0.12, 0.0, 0.0))
    >>> round(right.x, 2), round(right.theta, 3)
    (0.1, 0.009)
    """

    def __init__(self) -> None:
        self._way = np.zeros(2)
        """Sums of odometry times truth and of odometry squared."""
        self._turn, self._square = np.zeros(2), np.zeros((2, 2))
        """Normal equations of: the true rotation = scale * rotation + pull * distance."""
        self.scale, self.turn_scale, self.pull = 1.0, 1.0, 0.0

    def correct(self, motion: Pose2D) -> Pose2D:
        """Return the corrected motion."""
        turn = self.turn_scale * motion.theta + self.pull * motion.x
        return Pose2D(self.scale * motion.x, self.scale * motion.y, turn)

    def learn(self, motion: Pose2D, found: Pose2D) -> None:
        """Learn from an odometry motion and the motion found by matching."""
        way = math.hypot(motion.x, motion.y)
        keep = math.exp(-(way + abs(motion.theta)) / MEMORY)
        along = motion.x * found.x + motion.y * found.y
        self._way = keep * self._way + np.array([along, way * way])
        told = np.array([motion.theta, motion.x])
        self._turn, self._square = keep * self._turn + told * found.theta, keep * self._square + np.outer(told, told)
        self._solve()

    def _solve(self) -> None:
        """Solve by least squares, regularized towards scale 1 and pull 0."""
        scale = (self._way[0] + RIDGE) / (self._way[1] + RIDGE)
        turn, pull = np.linalg.solve(self._square + RIDGE * np.eye(2), self._turn + np.array([RIDGE, 0.0]))
        self.scale = min(max(float(scale), 1 / MOST), MOST)
        self.turn_scale = min(max(float(turn), 1 / MOST), MOST)
        self.pull = min(max(float(pull), -1.0), 1.0)
