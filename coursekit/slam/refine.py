"""Gauss-Newton refinement of a match: the pose that aligns the points with the walls, its certainty, and its degeneracy."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numba import njit

from coursekit.geometry.plane import Array, Pose2D, rotation
from coursekit.slam.submap import Submap


@dataclass(frozen=True)
class Refined:
    """The result of a refinement."""

    pose: Pose2D
    information: Array
    """(3, 3) inverse covariance in the pose's own frame [1/m², 1/rad²], without the prior."""
    inliers: float
    """Part of the points that are on a wall."""
    spread: float
    """Weighted root mean square distance of the inliers to their walls [m]."""

    @property
    def degeneracy(self) -> float:
        """How poorly the walls constrain the worst direction: 0 if as well as the best, towards 1 in a bare corridor.

        >>> Refined(Pose2D(), np.diag([100.0, 100.0, 50.0]), 1.0, 0.01).degeneracy  # a corner
        0.0
        >>> round(Refined(Pose2D(), np.diag([0.01, 100.0, 50.0]), 1.0, 0.01).degeneracy, 2)  # a corridor along x
        0.99
        """
        (a, b), (_, d) = self.information[:2, :2].tolist()
        middle, root = 0.5 * (a + d), math.hypot(0.5 * (a - d), b)
        return 1.0 - math.sqrt(max(middle - root, 0.0) / (middle + root)) if middle + root > 0 else 1.0


    @property
    def covariance(self) -> Array:
        """(3, 3) in the pose's own frame [m², rad²]; ten beams count as one, for they share errors; 1 m if unconstrained.

        >>> Refined(Pose2D(), np.zeros((3, 3)), 0.0, 0.0).covariance.diagonal().tolist()
        [1.0, 1.0, 1.0]
        """
        return np.asarray(np.linalg.inv(0.1 * self.information + np.eye(3)), dtype=np.float64)


@njit(cache=True)
def _accumulate(points, xyt, walls, normals, weights, nearest, ox, oy, cell, gate, sigma, h, b):  # type: ignore[no-untyped-def]
    """Sum the normal equations in the pose's own frame; return inliers and the weighted sums of squares and weights."""
    c, s = math.cos(xyt[2]), math.sin(xyt[2])
    height, width = nearest.shape
    inliers, squares, total = 0, 0.0, 0.0
    for k in range(len(points)):
        px, py = points[k, 0], points[k, 1]
        wx, wy = xyt[0] + c * px - s * py, xyt[1] + s * px + c * py
        i, j = math.floor((wy - oy) / cell), math.floor((wx - ox) / cell)
        if i < 0 or j < 0 or i >= height or j >= width or nearest[i, j] < 0:
            continue
        q = nearest[i, j]
        dx, dy = wx - walls[q, 0], wy - walls[q, 1]
        nx, ny = normals[q, 0], normals[q, 1]
        across = nx * dx + ny * dy
        if dx * dx + dy * dy > gate * gate:
            continue
        plain = nx == 0.0 and ny == 0.0
        r2 = dx * dx + dy * dy if plain else across * across
        kernel = 1.0 / (1.0 + r2 / (4.0 * sigma * sigma))
        trust = kernel * weights[q] / (weights[q] + 1.0) / (sigma * sigma)
        if abs(r2) < 9.0 * sigma * sigma:
            inliers += 1
        squares += kernel * r2
        total += kernel
        for turn in range(2 if plain else 1):  # a post constrains both directions, a wall only one
            if plain:
                ux, uy, w = (1.0, 0.0, 0.25 * trust) if turn == 0 else (0.0, 1.0, 0.25 * trust)
            else:
                ux, uy, w = nx, ny, trust
            r = ux * dx + uy * dy
            j0, j1 = ux * c + uy * s, -ux * s + uy * c
            j2 = -j0 * py + j1 * px
            h[0, 0] += w * j0 * j0
            h[0, 1] += w * j0 * j1
            h[0, 2] += w * j0 * j2
            h[1, 1] += w * j1 * j1
            h[1, 2] += w * j1 * j2
            h[2, 2] += w * j2 * j2
            b[0] += w * j0 * r
            b[1] += w * j1 * r
            b[2] += w * j2 * r
    h[1, 0], h[2, 0], h[2, 1] = h[0, 1], h[0, 2], h[1, 2]
    return inliers, squares, total


@njit(cache=True)
def _solve3(h, b):  # type: ignore[no-untyped-def]
    """h⁻¹ b for a symmetric 3 x 3 matrix, by Cramer's rule."""
    c0 = h[1, 1] * h[2, 2] - h[1, 2] * h[2, 1]
    c1 = h[1, 2] * h[2, 0] - h[1, 0] * h[2, 2]
    c2 = h[1, 0] * h[2, 1] - h[1, 1] * h[2, 0]
    d = h[0, 0] * c0 + h[0, 1] * c1 + h[0, 2] * c2
    x = (
        b[0] * c0 + h[0, 1] * (b[2] * h[1, 2] - b[1] * h[2, 2]) + h[0, 2] * (b[1] * h[2, 1] - b[2] * h[1, 1])
    ) / d
    y = (
        h[0, 0] * (b[1] * h[2, 2] - b[2] * h[1, 2]) + b[0] * c1 + h[0, 2] * (b[2] * h[1, 0] - b[1] * h[2, 0])
    ) / d
    z = (
        h[0, 0] * (b[2] * h[1, 1] - b[1] * h[2, 1]) + h[0, 1] * (b[1] * h[2, 0] - b[2] * h[1, 0]) + b[0] * c2
    ) / d
    return x, y, z


@njit(cache=True)
def gauss_newton(
    points,
    start,
    walls,
    normals,
    weights,
    nearest,
    ox,
    oy,
    cell,
    gate,
    sigma,
    prior,
    precision,
    rounds,
    h,
):  # type: ignore[no-untyped-def]
    """Return the pose after the rounds, inliers and weighted rms; `h` receives the information without the prior."""
    pose, b = start.copy(), np.zeros(3)
    damp = np.zeros((3, 3))
    inliers, squares, total = 0, 0.0, 0.0
    for turn in range(rounds):
        h[:], b[:] = 0.0, 0.0
        reach = max(gate * 0.7**turn, 4.0 * sigma)
        inliers, squares, total = _accumulate(
            points, pose, walls, normals, weights, nearest, ox, oy, cell, reach, sigma, h, b
        )
        c, s = math.cos(pose[2]), math.sin(pose[2])
        ex, ey = pose[0] - prior[0], pose[1] - prior[1]
        et = (pose[2] - prior[2] + math.pi) % (2 * math.pi) - math.pi
        e0, e1 = c * ex + s * ey, -s * ex + c * ey
        for i in range(3):
            for j in range(3):
                damp[i, j] = h[i, j] + precision[i, j]
            b[i] += precision[i, 0] * e0 + precision[i, 1] * e1 + precision[i, 2] * et
            damp[i, i] += 1e-6 + 1e-9 * h[i, i]
        d0, d1, d2 = _solve3(damp, b)
        pose[0] -= c * d0 - s * d1
        pose[1] -= s * d0 + c * d1
        pose[2] -= d2
        if d0 * d0 + d1 * d1 < 1e-8 and abs(d2) < 1e-5 and turn >= 2:
            break
    return pose, inliers, math.sqrt(squares / total) if total > 0 else 0.0


def refine(
    points: Array,
    submap: Submap,
    guess: Pose2D,
    prior: Pose2D,
    precision: Array,
    gate: float = 0.3,
    rounds: int = 10,
) -> Refined:
    """Refine a guess against a submap; `prior` with its (3, 3) precision decides where the walls leave the pose open.

    >>> from coursekit.slam.parameters import SlamParameters
    >>> from coursekit.slam.scan import Scan
    >>> corner = np.array([[2.0, y / 20] for y in range(-20, 20)] + [[x / 20, 1.0] for x in range(-20, 40)])
    >>> submap = Submap(SlamParameters())
    >>> submap.insert(Scan.from_points(corner, submap.params), Pose2D())
    >>> guess = Pose2D(0.03, -0.03, 0.02)
    >>> refined = refine(corner, submap, guess, guess, precision_of(1.0, 1.0, 1.0))
    >>> refined.pose.distance(Pose2D()) < 0.002, refined.inliers > 0.9
    (True, True)
    """
    information = np.zeros((3, 3))
    if not len(points) or not submap.nearest.size:
        return Refined(guess, information, 0.0, 0.0)
    pose, inliers, spread = gauss_newton(
        points, np.array(guess), submap.points, submap.normals, submap.weights, submap.nearest, submap.origin[0],
        submap.origin[1], submap.params.cell, gate, submap.params.range_sigma, np.array(prior),
        np.asarray(precision, float), rounds, information,
    )  # fmt: skip
    return Refined(Pose2D.of(pose), information, inliers / len(points), spread)


def precision_of(sigma_forward: float, sigma_side: float, sigma_angle: float, heading: float = 0.0) -> Array:
    """Return the inverse covariance (3, 3) for standard deviations, the first two along and across `heading`.

    >>> precision_of(0.5, 0.1, 0.1).round(3).diagonal().tolist()
    [4.0, 100.0, 100.0]
    """
    turn = np.eye(3)
    turn[:2, :2] = rotation(heading)
    return turn @ np.diag([sigma_forward**-2, sigma_side**-2, sigma_angle**-2]) @ turn.T
