"""The pose graph: where the keyframes are, what was measured between them, and the poses that agree best."""

from __future__ import annotations

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
        self._edges = 0
        self._pairs = np.zeros((64, 2), dtype=np.int64)
        self._motions = np.zeros((64, 3))
        self._precisions = np.zeros((64, 3, 3))
        self._robust = np.zeros(64, dtype=bool)

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
        k = self._edges
        if k == len(self._pairs):
            self._pairs, self._motions, self._precisions, self._robust = (
                np.concatenate([part, np.zeros_like(part)])
                for part in (self._pairs, self._motions, self._precisions, self._robust)
            )
        self._pairs[k], self._motions[k], self._precisions[k], self._robust[k] = (
            (first, second),
            motion,
            precision,
            robust,
        )
        self._edges += 1
        return k

    @property
    def edges(self) -> Problem:
        """The edges as arrays, views; `robust` marks those that may be false, such as loops."""
        n = self._edges
        return Problem(
            self._pairs[:n, 0], self._pairs[:n, 1], self._motions[:n], self._precisions[:n], self._robust[:n]
        )

    def optimize(self, *, rounds: int = 20, fresh: bool = False) -> Array:
        """Move the poses to where they agree best with the edges, node 0 held; returns each edge's trust (0 to 1).

        `fresh` starts from the chordal solution instead of the present poses.
        """
        problem = self.edges
        start = chordal(problem, self.poses) if fresh else self.poses
        poses, trust = optimize(problem, start, rounds=rounds)
        self._poses[: self.size] = poses
        return trust
