"""The pose graph: where the keyframes are, what was measured between them, and the poses that agree best."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursekit.slam.pose import Array, Pose2
from coursekit.slam.solver import Problem, chordal, optimize


class PoseGraph:
    """Poses (n, 3) and measured motions between them. In ROS 2: what slam_toolbox hands to its solver.

    >>> graph = PoseGraph()
    >>> for x in (0.0, 1.1, 2.0):
    ...     _ = graph.add_node(Pose2(x, 0.0, 0.0))
    >>> for a, b in ((0, 1), (1, 2)):
    ...     _ = graph.add_edge(a, b, Pose2(1.0, 0.0, 0.0), np.eye(3))
    >>> _ = graph.optimize()
    >>> round(graph.pose(1).x, 6)
    1.0
    """

    def __init__(self) -> None:
        self._poses = np.zeros((64, 3))
        self.size = 0
        self.pairs: list[tuple[int, int]] = []
        self.motions: list[Pose2] = []
        self.precisions: list[Array] = []
        self.robust: list[bool] = []
        """Edges that may be false, such as loops; the others are trusted."""

    @property
    def poses(self) -> Array:
        """(n, 3), a view."""
        return self._poses[: self.size]

    def pose(self, node: int) -> Pose2:
        """One pose."""
        return Pose2.of(self._poses[node])

    def add_node(self, pose: Pose2) -> int:
        """A new pose; returns its number."""
        if self.size == len(self._poses):
            self._poses = np.concatenate([self._poses, np.zeros_like(self._poses)])
        self._poses[self.size] = pose
        self.size += 1
        return self.size - 1

    def add_edge(self, first: int, second: int, motion: Pose2, precision: Array, robust: bool = False) -> int:
        """A measured motion from one node to another with its (3, 3) inverse covariance; returns its number."""
        for node in (first, second):
            if not 0 <= node < self.size:
                raise IndexError(f"no node {node}: the graph has {self.size}, add it with add_node first")
        self.pairs.append((first, second))
        self.motions.append(motion)
        self.precisions.append(np.asarray(precision, float))
        self.robust.append(robust)
        return len(self.pairs) - 1

    def problem(self, edges: Sequence[int] | None = None) -> Problem:
        """The edges (all, or these) as arrays."""
        chosen = range(len(self.pairs)) if edges is None else edges
        pairs = np.array([self.pairs[k] for k in chosen], dtype=np.int64).reshape(-1, 2)
        motions = np.array([self.motions[k] for k in chosen], dtype=float).reshape(-1, 3)
        precisions = np.array([self.precisions[k] for k in chosen], dtype=float).reshape(-1, 3, 3)
        return Problem(
            pairs[:, 0], pairs[:, 1], motions, precisions, np.array([self.robust[k] for k in chosen], bool)
        )

    def optimize(self, *, rounds: int = 20, fresh: bool = False) -> Array:
        """Move the poses to where they agree best with the edges, node 0 held; returns each edge's trust (0 to 1).

        `fresh` starts from the chordal solution instead of the present poses.
        """
        problem = self.problem()
        start = chordal(problem, self.poses) if fresh else self.poses
        poses, trust = optimize(problem, start, rounds=rounds)
        self._poses[: self.size] = poses
        return trust
