"""The motion model of the particles, with its noise."""

from __future__ import annotations

import math

import numpy as np

from coursekit.geometry.plane import wrap

STRAIGHT = 0.01
"""A shorter distance [m] has no direction of its own."""


def move_differential(
    particles: np.ndarray, before: np.ndarray, after: np.ndarray, alphas: tuple[float, ...], rng: np.random.Generator
) -> np.ndarray:
    """Move particles (n, 3) by the odometry's motion from one pose to another: rotate, drive, rotate (Thrun et al., 5.4).

    alphas: noise of rotation from rotation and from driving, noise of driving from driving and from rotation.

    >>> at = np.zeros((1, 3))
    >>> move_differential(at, np.zeros(3), np.array([1.0, 0.0, 0.0]), (0.0,) * 5, np.random.default_rng(0)).tolist()
    [[1.0, 0.0, 0.0]]
    """
    dx, dy, turn = after[0] - before[0], after[1] - before[1], wrap(after[2] - before[2])
    way = math.hypot(dx, dy)
    first = wrap(math.atan2(dy, dx) - before[2]) if way > STRAIGHT else 0.0
    second = wrap(turn - first)
    # driving backwards is not a rotation by half a circle
    small = [min(abs(wrap(turn)), abs(wrap(turn - math.pi))) for turn in (first, second)]
    a1, a2, a3, a4 = alphas[:4]
    count = len(particles)
    first_turn = first - rng.normal(0, math.sqrt(a1 * small[0] ** 2 + a2 * way**2), count)
    drive = way - rng.normal(0, math.sqrt(a3 * way**2 + a4 * (small[0] ** 2 + small[1] ** 2)), count)
    second_turn = second - rng.normal(0, math.sqrt(a1 * small[1] ** 2 + a2 * way**2), count)
    heading = particles[:, 2] + first_turn
    x, y = particles[:, 0] + drive * np.cos(heading), particles[:, 1] + drive * np.sin(heading)
    return np.column_stack([x, y, wrap(heading + second_turn)])


def move_omni(
    particles: np.ndarray, before: np.ndarray, after: np.ndarray, alphas: tuple[float, ...], rng: np.random.Generator
) -> np.ndarray:
    """The same for robots that drive sideways; alphas[4] is the lateral noise.

    >>> rng, exact = np.random.default_rng(0), (0.0,) * 5
    >>> move_omni(np.array([[1.0, 1.0, math.pi / 2]]), np.zeros(3), np.array([0.0, 0.5, 0.0]), exact, rng).round(3).tolist()
    [[0.5, 1.0, 1.571]]
    """
    dx, dy, turn = after[0] - before[0], after[1] - before[1], wrap(after[2] - before[2])
    way, count = math.hypot(dx, dy), len(particles)
    bearing = particles[:, 2] + wrap(math.atan2(dy, dx) - before[2])
    a1, a2, a3, a4, a5 = alphas
    along = way + rng.normal(0, math.sqrt(a3 * way**2 + a1 * turn**2), count)
    across = rng.normal(0, math.sqrt(a1 * turn**2 + a5 * way**2), count)
    turned = turn + rng.normal(0, math.sqrt(a4 * turn**2 + a2 * way**2), count)
    c, s = np.cos(bearing), np.sin(bearing)
    x, y = particles[:, 0] + along * c + across * s, particles[:, 1] + along * s - across * c
    return np.column_stack([x, y, wrap(particles[:, 2] + turned)])
