"""Odometry that drifts: from the wheels' rotation, with slip, bias and noise; seeded, so it is repeatable."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coursekit.geometry.plane import Pose2D


@dataclass(frozen=True)
class Drift:
    """The errors of an odometer. With all zeros it is as exact as the wheels' grip.

    `slip` is the share of rotation lost by the wheels (rotation is over-estimated by it). `bias` is the error of the wheels'
    size (distance is over-estimated by it). `curl` is the undetected rotation per metre [rad/m]. `way_noise` [m per root of
    m], `turn_noise` [rad per root of rad] and `way_turn_noise` [rad per root of m] are Gaussian noise that grows with the
    distance.
    """

    slip: float = 0.0
    bias: float = 0.0
    curl: float = 0.0
    way_noise: float = 0.0
    turn_noise: float = 0.0
    way_turn_noise: float = 0.0

    @classmethod
    def usual(cls, size: float = 1.0) -> Drift:
        """Return the errors of a small robot on a smooth floor, times `size`.

        >>> Drift.usual(0.0) == Drift()
        True
        """
        return cls(0.02 * size, 0.01 * size, 0.004 * size, 0.01 * size, 0.02 * size, 0.01 * size)


class Odometer:
    """Integrates the wheels' rotation.

    >>> odometer = Odometer(Drift(bias=0.02), seed=0)
    >>> odometer.roll((1.0, 0.0, 0.0), 0.5)  # half a metre, over-estimated by 2 %
    >>> odometer.place
    Pose2D(x=0.51, y=0.0, theta=0.0)
    """

    def __init__(self, drift: Drift, seed: int) -> None:
        self.drift, self._seed = drift, seed
        self.restart()

    def restart(self) -> None:
        """Restart at the origin, with the same random seed."""
        self._chance = np.random.default_rng(self._seed)
        self._place = (0.0, 0.0, 0.0)
        self._sum = [0.0, 0.0]

    def roll(self, wheels: tuple[float, float, float], dt: float) -> None:
        """Integrate wheel velocities over `dt` seconds: forward, to the left [m/s], and angular [rad/s]."""
        forward, left, turn = wheels
        if not (forward or left or turn):
            return
        x, y, theta = self._place
        drift = self.drift
        way = math.hypot(forward, left) * dt
        share = 1.0 + drift.bias
        spin = turn * dt * (1.0 + drift.slip) + drift.curl * way
        middle = theta + spin / 2
        c, s = math.cos(middle), math.sin(middle)
        x += (c * forward - s * left) * share * dt
        y += (s * forward + c * left) * share * dt
        self._place = (x, y, theta + spin)
        self._sum[0] += way
        self._sum[1] += abs(turn) * dt
        if self._sum[0] > 0.05 or self._sum[1] > 0.1:
            self._shake()

    def _shake(self) -> None:
        """Apply the noise for the distance since the last call."""
        way, turned = self._sum
        self._sum = [0.0, 0.0]
        drift = self.drift
        if not (drift.way_noise or drift.turn_noise or drift.way_turn_noise):
            return
        along, spin = map(float, self._chance.standard_normal(2))  # messages need Python floats
        spread = math.sqrt(drift.turn_noise**2 * turned + drift.way_turn_noise**2 * way)
        x, y, theta = self._place
        along *= drift.way_noise * math.sqrt(way)
        self._place = (x + math.cos(theta) * along, y + math.sin(theta) * along, theta + spin * spread)

    @property
    def place(self) -> Pose2D:
        """The estimated pose of the robot, relative to its start."""
        return Pose2D(*self._place)


EXACT = Drift()
__all__ = ["EXACT", "Drift", "Odometer"]
