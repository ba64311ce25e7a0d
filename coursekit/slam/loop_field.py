"""Finding a scan in a submap from a very rough guess: branch and bound over ever coarser fields (Hess et al. 2016)."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from coursekit.geometry.plane import Array, Pose2D

LEVELS = 7
"""Number of fields; the coarsest one takes the maximum over 64 x 64 cells."""
RIVALS = (0.5, 2.0)
"""Distances at which a pose is a rival: far enough to be another one, near enough to be confused by drift [m]."""


@njit(cache=True)
def _paint(points, field, ox, oy, cell, sigma):  # type: ignore[no-untyped-def]
    """Paint the likelihood around each point, 0 to 255."""
    steps = int(2.5 * sigma / cell) + 1
    for k in range(len(points)):
        row, column = int((points[k, 1] - oy) / cell), int((points[k, 0] - ox) / cell)
        for i in range(max(row - steps, 0), min(row + steps + 1, field.shape[0])):
            for j in range(max(column - steps, 0), min(column + steps + 1, field.shape[1])):
                dx, dy = ox + (j + 0.5) * cell - points[k, 0], oy + (i + 0.5) * cell - points[k, 1]
                value = int(255.0 * math.exp(-0.5 * (dx * dx + dy * dy) / (sigma * sigma)))
                if value > field[i, j]:
                    field[i, j] = value


@njit(cache=True)
def _coarser(fine, step):  # type: ignore[no-untyped-def]
    """Return the maximum of each cell and the ones `step` above, to the right, and both."""
    height, width = fine.shape
    out = fine.copy()
    for i in range(height):
        for j in range(width):
            best = fine[i, j]
            if j + step < width:
                best = max(best, fine[i, j + step])
            if i + step < height:
                best = max(best, fine[i + step, j])
                if j + step < width:
                    best = max(best, fine[i + step, j + step])
            out[i, j] = best
    return out


@njit(cache=True)
def _sum(field, rows, columns, di, dj):  # type: ignore[no-untyped-def]
    """Sum of a field at shifted cells."""
    total = 0
    height, width = field.shape
    for k in range(len(rows)):
        i, j = rows[k] + di, columns[k] + dj
        if 0 <= i < height and 0 <= j < width:
            total += field[i, j]
    return total


@njit(cache=True)
def _four_sums(field, rows, columns, i, j, half, sums):  # type: ignore[no-untyped-def]
    """`_sum` at a shift, `half` right of it, above it, and both: four look-ups that the processor executes in parallel."""
    height, width = field.shape
    here = right = above = both = 0
    for k in range(len(rows)):
        y, x = rows[k] + i, columns[k] + j
        if 0 <= y < height - half and 0 <= x < width - half:
            here += field[y, x]
            right += field[y, x + half]
            above += field[y + half, x]
            both += field[y + half, x + half]
            continue
        low, high = 0 <= y < height, 0 <= y + half < height
        left, far = 0 <= x < width, 0 <= x + half < width
        if low and left:
            here += field[y, x]
        if low and far:
            right += field[y, x + half]
        if high and left:
            above += field[y + half, x]
        if high and far:
            both += field[y + half, x + half]
    sums[0], sums[1], sums[2], sums[3] = here, right, above, both


@njit(cache=True)
def search(points, fields, ox, oy, cell, x, y, theta, reach, angles, angle_step, least):  # type: ignore[no-untyped-def]
    """Return the best (x, y, theta, score) within ±reach cells and ±angles steps; a score up to `least` means none."""
    count, top = len(points), len(fields) - 1
    side = 1 << top
    blocks = (2 * reach + side) // side
    turns = 2 * angles + 1
    rows, columns = np.empty((turns, count), np.int32), np.empty((turns, count), np.int32)
    bounds = np.empty(turns * blocks * blocks, np.int64)
    for a in range(turns):
        c, s = math.cos(theta + (a - angles) * angle_step), math.sin(theta + (a - angles) * angle_step)
        for k in range(count):
            columns[a, k] = math.floor((x + c * points[k, 0] - s * points[k, 1] - ox) / cell)
            rows[a, k] = math.floor((y + s * points[k, 0] + c * points[k, 1] - oy) / cell)
        for i in range(blocks):
            for j in range(blocks):
                bounds[(a * blocks + i) * blocks + j] = _sum(
                    fields[top], rows[a], columns[a], i * side - reach, j * side - reach
                )
    best, best_a, best_i, best_j = int(least * 255 * count), -1, 0, 0
    stack, sums = np.empty((4 * (top + 2), 4), np.int64), np.empty(4, np.int64)
    for index in np.argsort(-bounds, kind="mergesort"):
        if bounds[index] <= best:
            break
        a, rest = index // (blocks * blocks), index % (blocks * blocks)
        stack[0] = np.array(
            [top, (rest // blocks) * side - reach, (rest % blocks) * side - reach, bounds[index]]
        )
        depth = 1
        while depth:
            depth -= 1
            level, i, j, bound = stack[depth]
            if bound <= best:
                continue
            if level == 0:
                if i <= reach and j <= reach:
                    best, best_a, best_i, best_j = bound, a, i, j
                continue
            half = 1 << (level - 1)
            begin = depth
            _four_sums(fields[level - 1], rows[a], columns[a], i, j, half, sums)
            for quarter in range(4):
                value = sums[quarter]
                if value <= best:
                    continue
                at = depth
                while at > begin and stack[at - 1, 3] > value:  # the best of the four is expanded first
                    stack[at] = stack[at - 1]
                    at -= 1
                stack[at, 0], stack[at, 3] = level - 1, value
                stack[at, 1], stack[at, 2] = i + half * (quarter // 2), j + half * (quarter % 2)
                depth += 1
    if best_a < 0:
        return x, y, theta, 0.0
    return (
        x + best_j * cell,
        y + best_i * cell,
        theta + (best_a - angles) * angle_step,
        best / (255.0 * count),
    )


@njit(cache=True)
def best_between(points, field, ox, oy, cell, x, y, theta, near, far):  # type: ignore[no-untyped-def]
    """Return the best score of shifts from `near` to `far` cells."""
    count, best = len(points), 0
    rows, columns = np.empty(count, np.int32), np.empty(count, np.int32)
    c, s = math.cos(theta), math.sin(theta)
    for k in range(count):
        columns[k] = math.floor((x + c * points[k, 0] - s * points[k, 1] - ox) / cell)
        rows[k] = math.floor((y + s * points[k, 0] + c * points[k, 1] - oy) / cell)
    for i in range(-far, far + 1):
        for j in range(-far, far + 1):
            if near * near <= i * i + j * j <= far * far:
                best = max(best, _sum(field, rows, columns, i, j))
    return best / (255.0 * max(count, 1))


class LoopField:
    """The fields of one submap's points (n, 2).

    >>> wall = np.array([[x / 20, 1.0] for x in range(60)] + [[0.0, y / 20] for y in range(20)])
    >>> found, score = LoopField(wall, 0.1).find(wall, Pose2D(0.7, -0.6, 0.3), 1.0, 0.5, 0.05, 0.3)
    >>> found.distance(Pose2D()) < 0.15, score > 0.8
    (True, True)
    """

    def __init__(self, points: Array, cell: float) -> None:
        self.cell = cell
        border = (1 << (LEVELS - 1)) * cell
        self.origin = points.min(axis=0) - border - 4 * cell
        size = np.ceil((points.max(axis=0) + 4 * cell - self.origin) / cell).astype(int)
        field = np.zeros((size[1], size[0]), dtype=np.uint8)
        _paint(np.ascontiguousarray(points), field, self.origin[0], self.origin[1], cell, cell)
        fields = [field]
        for level in range(1, LEVELS):
            fields.append(_coarser(fields[-1], 1 << (level - 1)))
        self._fields = tuple(fields)

    def find(
        self, points: Array, guess: Pose2D, distance: float, angle: float, angle_step: float, least: float
    ) -> tuple[Pose2D, float]:
        """Return the points' best pose within ±distance [m] and ±angle [rad] of the guess; score 0 if none beats `least`."""
        if not len(points):
            return guess, 0.0
        reach, steps = math.ceil(distance / self.cell), math.ceil(min(angle, math.pi) / angle_step)
        x, y, theta, score = search(
            points, self._fields, self.origin[0], self.origin[1], self.cell, guess.x, guess.y, guess.theta,
            reach, steps, angle_step, least,
        )  # fmt: skip
        return Pose2D.of((x, y, theta)), float(score)

    def rival(self, points: Array, pose: Pose2D) -> float:
        """Return the best score 0.5 to 2 m away from a pose, relative to the score at the pose itself."""
        arguments = (points, self._fields[0], self.origin[0], self.origin[1], self.cell, pose.x, pose.y, pose.theta)
        near, far = (math.ceil(way / self.cell) for way in RIVALS)
        return float(best_between(*arguments, near, far) / max(best_between(*arguments, 0, 1), 1e-9))
