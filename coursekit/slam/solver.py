"""Sparse least squares over poses: damped Gauss-Newton over all edges at once, and the chordal initial guess."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix, csc_matrix
from scipy.sparse.linalg import splu

from coursekit.geometry.plane import Array, wrap

SCALE = 9.0
"""Scale of the robust kernel: squared error (in sigmas) at which a doubtful edge's cost is half its limit."""


@dataclass(frozen=True)
class Problem:
    """Edges as arrays: measured motions `z` (m, 3) from `i` to `j` with precisions (m, 3, 3)."""

    i: np.ndarray
    j: np.ndarray
    z: Array
    precision: Array
    robust: np.ndarray


def residuals(problem: Problem, poses: Array) -> Array:
    """Return (m, 3) the difference of each motion from its measurement, in the measurement's frame.

    >>> straight = Problem(np.array([0]), np.array([1]), np.array([[1.0, 0.0, 0.0]]), np.eye(3)[None], np.array([False]))
    >>> residuals(straight, np.array([[0.0, 0.0, 0.0], [1.2, 0.1, 0.0]])).round(3).tolist()
    [[0.2, 0.1, 0.0]]
    """
    a, b, z = poses[problem.i], poses[problem.j], problem.z
    theta = a[:, 2] + z[:, 2]
    c, s = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(a[:, 2]), np.sin(a[:, 2])
    dx = b[:, 0] - a[:, 0] - (ca * z[:, 0] - sa * z[:, 1])
    dy = b[:, 1] - a[:, 1] - (sa * z[:, 0] + ca * z[:, 1])
    return np.stack([c * dx + s * dy, c * dy - s * dx, wrap(b[:, 2] - theta)], axis=1)


def jacobians(problem: Problem, poses: Array) -> tuple[Array, Array]:
    """Return the derivatives (m, 3, 3) of the residuals by the two poses in world coordinates.

    >>> edge = Problem(np.array([0]), np.array([1]), np.array([[1.0, 0.0, 0.0]]), np.eye(3)[None], np.array([False]))
    >>> _, second = jacobians(edge, np.array([[0.0, 0.0, np.pi / 2], [0.0, 1.0, np.pi / 2]]))
    >>> second[0].round(6).tolist()  # the measurement's x is the world's y
    [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    """
    a, b, z = poses[problem.i], poses[problem.j], problem.z
    theta = a[:, 2] + z[:, 2]
    c, s = np.cos(theta), np.sin(theta)
    dx, dy = b[:, 0] - a[:, 0], b[:, 1] - a[:, 1]
    first, second = np.zeros((len(a), 3, 3)), np.zeros((len(a), 3, 3))
    second[:, 0, 0], second[:, 0, 1], second[:, 1, 0], second[:, 1, 1] = c, s, -s, c
    second[:, 2, 2] = 1.0
    first[:, :2, :2] = -second[:, :2, :2]
    first[:, 0, 2], first[:, 1, 2] = -s * dx + c * dy, -c * dx - s * dy
    first[:, 2, 2] = -1.0
    return first, second


def squared_errors(problem: Problem, errors: Array) -> Array:
    """Return (m,) the squared residuals in sigmas (the squared Mahalanobis distances).

    >>> edge = Problem(np.array([0]), np.array([1]), np.zeros((1, 3)), 25 * np.eye(3)[None], np.array([False]))
    >>> squared_errors(edge, np.array([[0.4, 0.0, 0.0]])).round(6).tolist()  # two sigmas of 0.2 m
    [4.0]
    """
    return np.einsum("mi,mij,mj->m", errors, problem.precision, errors)


def trust_of(problem: Problem, errors: Array, scale: float = SCALE) -> Array:
    """Return (m,) the weight of each edge: 1, or less for doubtful edges that disagree (Geman-McClure).

    >>> doubtful = np.array([False, True])
    >>> two = Problem(np.array([0, 0]), np.array([1, 1]), np.zeros((2, 3)), np.tile(np.eye(3), (2, 1, 1)), doubtful)
    >>> trust_of(two, np.full((2, 3), 10.0)).round(3).tolist()  # both are far off, but only the second may be false
    [1.0, 0.001]
    """
    return np.where(problem.robust, (scale / (scale + squared_errors(problem, errors))) ** 2, 1.0)


def cost(problem: Problem, errors: Array, scale: float = SCALE) -> float:
    """Return the sum to be minimized: squared errors, bounded by `scale` for edges that may be false (Geman-McClure).

    >>> far = np.array([[100.0, 0.0, 0.0]])
    >>> for doubtful in (False, True):
    ...     edge = Problem(np.array([0]), np.array([1]), np.zeros((1, 3)), np.eye(3)[None], np.array([doubtful]))
    ...     print(round(cost(edge, far, scale=9.0), 1))
    10000.0
    9.0
    """
    squared = squared_errors(problem, errors)
    return float(np.sum(np.where(problem.robust, scale * squared / (scale + squared), squared)))


class Assembler:
    """The sparse normal matrix of a fixed set of pairs: the position of each block is computed once."""

    def __init__(self, i: np.ndarray, j: np.ndarray, size: int) -> None:
        self.size = size
        corners = [(i, i), (i, j), (j, i), (j, j)]
        rows = np.concatenate([3 * a for a, _ in corners])[:, None, None] + np.arange(3)[:, None]
        columns = np.concatenate([3 * b for _, b in corners])[:, None, None] + np.arange(3)
        shape = (len(rows), 3, 3)
        rows, columns = (np.broadcast_to(part, shape).ravel() for part in (rows, columns))
        keys, self._place = np.unique(columns.astype(np.int64) * (3 * size) + rows, return_inverse=True)
        self._rows = (keys % (3 * size)).astype(np.int32)
        self._starts = np.searchsorted(keys // (3 * size), np.arange(3 * size + 1)).astype(np.int32)
        self._diagonal = np.searchsorted(keys, np.arange(3 * size) * (3 * size + 1))

    def matrix(self, blocks: Array, damping: Array) -> csc_matrix:
        """Assemble (4 m, 3, 3) blocks in the order ii, ij, ji, jj, adding `damping` (3 n) to the diagonal."""
        data = np.bincount(self._place.ravel(), blocks.ravel(), len(self._rows)).astype(np.float64)
        data[self._diagonal] += damping
        return csc_matrix((data, self._rows, self._starts), shape=(3 * self.size, 3 * self.size))


def gradient(i: np.ndarray, j: np.ndarray, gi: Array, gj: Array, size: int) -> Array:
    """Sum (m, 3) parts at both ends into (3 n).

    >>> gradient(np.array([0]), np.array([1]), np.array([[1.0, 2.0, 3.0]]), np.array([[4.0, 5.0, 6.0]]), 2).tolist()
    [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    """
    index = np.concatenate([3 * i, 3 * j])[:, None] + np.arange(3)
    return np.bincount(index.ravel(), np.concatenate([gi, gj]).ravel(), 3 * size).astype(np.float64)


def solve(matrix: csc_matrix, right: Array) -> Array:
    """Return matrix⁻¹ right, for symmetric positive matrices.

    >>> solve(csc_matrix([[4.0, 1.0], [1.0, 3.0]]), np.array([1.0, 2.0])).round(4).tolist()
    [0.0909, 0.6364]
    """
    return splu(
        matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
    ).solve(right)


def _blocks(problem: Problem, poses: Array, weights: Array, errors: Array) -> tuple[Array, Array, Array]:
    """Return the blocks of the normal matrix and the gradients at both ends."""
    a, b = jacobians(problem, poses)
    wa = np.einsum("mki,mkl->mil", a, problem.precision * weights[:, None, None])
    wb = np.einsum("mki,mkl->mil", b, problem.precision * weights[:, None, None])
    blocks = np.concatenate([wa @ a, wa @ b, wb @ a, wb @ b])
    return blocks, np.einsum("mil,ml->mi", wa, errors), np.einsum("mil,ml->mi", wb, errors)


def optimize(problem: Problem, start: Array, rounds: int = 20, slack: float = 0.0) -> tuple[Array, Array]:
    """Return the poses (n, 3) of least cost near the start, with node 0 fixed, and each edge's trust.

    With `slack`, doubtful edges are first trusted up to that squared error, then less and less (graduated non-convexity,
    Yang et al. 2020): a true loop after much drift looks false at first.

    >>> ring = Problem(
    ...     np.arange(4), np.array([1, 2, 3, 0]), np.tile([1.0, 0.0, np.pi / 2], (4, 1)), np.tile(np.eye(3), (4, 1, 1)),
    ...     np.zeros(4, bool),
    ... )
    >>> drifted = np.array([[0.0, 0.0, 0.0], [1.1, 0.1, 1.6], [1.1, 1.1, 3.1], [0.1, 1.2, -1.5]])
    >>> poses, trust = optimize(ring, drifted)  # four steps around a square of 1 m
    >>> np.abs(poses[:, :2].round(3)).tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
    """
    poses, size = start.copy(), len(start)
    if not len(problem.i) or size < 2:
        return poses, np.ones(len(problem.i))
    assembler = Assembler(problem.i, problem.j, size)
    scale = max(SCALE, slack)
    while scale > SCALE:
        poses = _descend(problem, poses, assembler, 2, scale)
        scale = max(SCALE, scale / 8)
    poses = _descend(problem, poses, assembler, rounds, SCALE)
    poses[:, 2] = wrap(poses[:, 2])
    return poses, trust_of(problem, residuals(problem, poses))


def _descend(problem: Problem, poses: Array, assembler: Assembler, rounds: int, scale: float) -> Array:
    """Take up to so many damped Gauss-Newton steps (Levenberg-Marquardt)."""
    hold, damping = np.zeros(3 * len(poses)), 1e-9
    hold[:3] = 1e12
    errors = residuals(problem, poses)
    now = cost(problem, errors, scale)
    for _ in range(rounds):
        blocks, gi, gj = _blocks(problem, poses, trust_of(problem, errors, scale), errors)
        right = gradient(problem.i, problem.j, gi, gj, len(poses))
        moved = poses - solve(assembler.matrix(blocks, hold + damping + 1e-9), right).reshape(-1, 3)
        moved_errors = residuals(problem, moved)
        then = cost(problem, moved_errors, scale)
        if not then <= now:
            damping = max(damping, 1e-3) * 30
            if damping > 1e9:
                break
            continue
        done = now - then < 1e-6 * now + 1e-12
        poses, errors, now, damping = moved, moved_errors, then, damping * 0.1
        if done:
            break
    return poses


def chordal(problem: Problem, poses: Array) -> Array:
    """Compute an initial guess from scratch: headings as free complex numbers, then positions; two linear problems.

    Only the first pose is taken from `poses` (n, 3). The idea is that of chordal relaxation (Carlone et al. 2015).

    >>> edge = Problem(np.array([0]), np.array([1]), np.array([[1.0, 0.0, 0.5]]), np.eye(3)[None], np.array([False]))
    >>> chordal(edge, np.array([[0.0, 0.0, np.pi / 2], [9.0, 9.0, 9.0]])).round(3)[1].tolist()
    [0.0, 1.0, 2.071]
    """
    size = len(poses)
    weight_r, weight_t = np.sqrt(problem.precision[:, 2, 2]), np.sqrt(problem.precision[:, 0, 0])
    turn = np.exp(1j * problem.z[:, 2])
    first = np.exp(1j * poses[0, 2])
    heading = _linear(problem, weight_r, turn, np.zeros(len(problem.i), complex), first, size)
    unit = heading / np.maximum(np.abs(heading), 1e-12)
    shift = unit[problem.i] * (problem.z[:, 0] + 1j * problem.z[:, 1])
    place = _linear(
        problem, weight_t, np.ones(len(problem.i), complex), shift, poses[0, 0] + 1j * poses[0, 1], size
    )
    return np.stack([place.real, place.imag, np.angle(unit)], axis=1)


def _linear(
    problem: Problem, weight: Array, factor: np.ndarray, shift: np.ndarray, first: complex, size: int
) -> np.ndarray:
    """Solve v[j] = factor v[i] + shift by least squares with v[0] given, in complex numbers."""
    rows = np.arange(len(weight))
    matrix = coo_matrix(
        (
            np.concatenate([weight * 1.0, -weight * factor]),
            (np.concatenate([rows, rows]), np.concatenate([problem.j, problem.i])),
        ),
        shape=(len(rows), size),
    ).tocsc()
    rest, right = matrix[:, 1:], weight * shift - matrix[:, :1].toarray().ravel() * first
    normal = (rest.conj().T @ rest).tocsc() + 1e-12 * _identity(size - 1)
    return np.concatenate([[first], splu(normal.tocsc()).solve(rest.conj().T @ right)])


def _identity(size: int) -> csc_matrix:
    """Return a complex identity matrix."""
    index = np.arange(size)
    return csc_matrix((np.ones(size, complex), (index, index)), shape=(size, size))
