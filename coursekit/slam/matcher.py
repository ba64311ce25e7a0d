"""Correlative scan matching: the best pose of a whole window, never just a local optimum (after Olson, ICRA 2009).

It works in two levels, best first: the coarse field gives an upper bound for blocks of 4 x 4 cells; a block is searched
only while its bound beats the best pose found.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from coursekit.geometry.plane import Array, Pose2D
from coursekit.slam.submap import Submap


@njit(cache=True)
def _cells(points, x, y, angle, ox, oy, cell, rows, columns):  # type: ignore[no-untyped-def]
    """Compute the cell of each point, seen from a pose; points far outside stay far outside."""
    c, s = math.cos(angle), math.sin(angle)
    for k in range(len(points)):
        px, py = points[k, 0], points[k, 1]
        columns[k] = math.floor((x + c * px - s * py - ox) / cell)
        rows[k] = math.floor((y + s * px + c * py - oy) / cell)


@njit(cache=True)
def _patch_sums(field, tops, lefts, down, right, side, sums):  # type: ignore[no-untyped-def]
    """Sum the field at the shifted cells, for each shift (down..down+side-1, right..right+side-1)."""
    height, width = field.shape
    sums[:] = 0
    for k in range(len(tops)):
        top, left = tops[k] + down, lefts[k] + right
        if top >= 0 and left >= 0 and top + side <= height and left + side <= width:
            for i in range(side):
                for j in range(side):
                    sums[i * side + j] += field[top + i, left + j]
            continue
        for i in range(max(-top, 0), min(side, height - top)):
            for j in range(max(-left, 0), min(side, width - left)):
                sums[i * side + j] += field[top + i, left + j]


@njit(cache=True)
def correlate(  # type: ignore[no-untyped-def]
    points, likelihood, coarse, ox, oy, cell, x, y, theta, reach, angles, angle_step, per_cell, per_step, most
):
    """Return the best (x, y, theta, mean likelihood 0..1) within ±reach cells and ±angles steps of a pose.

    Distance from the pose costs `per_cell` and `per_step` times its square, at most `most`.
    """
    count, blocks = len(points), (2 * reach + 4) // 4
    rows, columns = np.empty((2 * angles + 1, count), np.int32), np.empty((2 * angles + 1, count), np.int32)
    bounds, sums = np.empty((2 * angles + 1) * blocks * blocks), np.empty(blocks * blocks, np.int32)
    fine = np.empty(16, np.int32)
    full = 255.0 * count
    for a in range(2 * angles + 1):
        _cells(points, x, y, theta + (a - angles) * angle_step, ox, oy, cell, rows[a], columns[a])
        turn = min(per_step * (a - angles) ** 2, most)
        rows[a] -= reach
        columns[a] -= reach
        _patch_sums(coarse, rows[a] >> 2, columns[a] >> 2, 0, 0, blocks, sums)
        for block in range(blocks * blocks):
            bounds[a * blocks * blocks + block] = sums[block] / full - turn
    best, best_a, best_i, best_j, raw = -1e9, angles, 0, 0, 0.0
    for index in np.argsort(-bounds, kind="mergesort"):
        if bounds[index] <= best:
            break
        a, rest = index // (blocks * blocks), index % (blocks * blocks)
        turn = per_step * (a - angles) ** 2
        top, left = 4 * (rest // blocks), 4 * (rest % blocks)
        _patch_sums(likelihood, rows[a], columns[a], top, left, 4, fine)
        for spot in range(16):
            i, j = top + spot // 4 - reach, left + spot % 4 - reach
            if i > reach or j > reach:
                continue
            likely = fine[spot] / full
            score = likely - min(turn + per_cell * (i * i + j * j), most)
            if score > best:
                best, best_a, best_i, best_j, raw = score, a, i, j, likely
    return x + best_j * cell, y + best_i * cell, theta + (best_a - angles) * angle_step, raw


def sample(points: Array, limit: int) -> Array:
    """Return at most `limit` of the points, evenly spread.

    >>> sample(np.arange(10.0).reshape(5, 2), 3)[:, 0].tolist()
    [0.0, 4.0, 8.0]
    """
    return points if len(points) <= limit else np.ascontiguousarray(points[:: -(-len(points) // limit)])


def match(
    points: Array, submap: Submap, guess: Pose2D, distance: float, angle: float, sigmas: tuple[float, float]
) -> tuple[Pose2D, float]:
    """Return the best pose within ±distance [m] and ±angle [rad] of the guess, to a cell and angle step, and its score.

    `sigmas` are the standard deviations of the guess [m], [rad]; it decides where the walls leave the pose open.

    >>> from coursekit.slam.parameters import SlamParameters
    >>> from coursekit.slam.scan import Scan
    >>> corner = np.array([[2.0, y / 20] for y in range(-20, 20)] + [[x / 20, 1.0] for x in range(-20, 40)])
    >>> submap = Submap(SlamParameters())
    >>> submap.insert(Scan.from_points(corner, submap.params), Pose2D())
    >>> pose, score = match(corner, submap, Pose2D(0.1, -0.1, 0.05), 0.3, 0.15, (0.5, 0.5))  # 14 cm off
    >>> pose.distance(Pose2D()) < 0.05, score > 0.8
    (True, True)
    """
    p = submap.params
    if not len(points) or not submap.nearest.size:
        return guess, 0.0
    reach, steps = max(1, round(distance / p.cell)), max(1, round(angle / p.angle_step))
    x, y, theta, score = correlate(
        sample(points, 120), submap.likelihood, submap.coarse, submap.origin[0], submap.origin[1], p.cell,
        guess.x, guess.y, guess.theta, reach, steps, p.angle_step, p.guess_weight * (p.cell / sigmas[0]) ** 2,
        p.guess_weight * (p.angle_step / sigmas[1]) ** 2, p.guess_limit,
    )  # fmt: skip
    return Pose2D.of((x, y, theta)), float(score)
