"""The pose graph: keyframe poses, the measured motions between them, and the poses that fit these best."""

from __future__ import annotations

import numpy as np

from coursekit.geometry.plane import Array, Pose2D
from coursekit.slam.solver import Problem, chordal, cost, optimize, residuals, squared_errors, trust_of


class PoseGraph:
    """Poses (n, 3) and measured motions between them. In ROS 2: the input of slam_toolbox's solver.

    >>> graph = PoseGraph()
    >>> for x in (0.0, 1.1, 2.0):
    ...     _ = graph.add_node(Pose2D(x, 0.0, 0.0))
    >>> for a, b in ((0, 1), (1, 2)):
    ...     _ = graph.add_edge(a, b, Pose2D(1.0, 0.0, 0.0), np.eye(3))
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
        """The poses (n, 3), as a view."""
        return self._poses[: self.size]

    def pose(self, node: int) -> Pose2D:
        """Return one pose."""
        return Pose2D.of(self._poses[node])

    def add_node(self, pose: Pose2D) -> int:
        """Add a pose; return its number."""
        if self.size == len(self._poses):
            self._poses = np.concatenate([self._poses, np.zeros_like(self._poses)])
        self._poses[self.size] = pose
        self.size += 1
        return self.size - 1

    def add_edge(self, first: int, second: int, motion: Pose2D, precision: Array, robust: bool = False) -> int:
        """Add a measured motion from one node to another; return its number.

        `precision` is the (3, 3) inverse covariance of the motion [1/m², 1/rad²].
        `robust` marks an edge that may be false, such as a loop. Raises IndexError for a node that is not in the graph.

        >>> PoseGraph().add_edge(0, 1, Pose2D(1.0, 0.0, 0.0), np.eye(3))
        Traceback (most recent call last):
        IndexError: no node 0: the graph has 0, add it with add_node first
        """
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
        """The edges as views of arrays; `robust` marks those that may be false, such as loops."""
        n = self._edges
        return Problem(
            self._pairs[:n, 0], self._pairs[:n, 1], self._motions[:n], self._precisions[:n], self._robust[:n]
        )

    def optimize(self, *, rounds: int = 20, slack: float = 0.0) -> Array:
        """Optimize the poses to fit the edges, with node 0 fixed; return each edge's trust (0 to 1).

        `slack` gives doubtful edges with up to this squared error (in sigmas) full weight at first.

        >>> graph = PoseGraph()
        >>> for x in (0.0, 1.0, 2.0):
        ...     _ = graph.add_node(Pose2D(x, 0.0, 0.0))
        >>> for a, b, x, loop in ((0, 1, 1.0, False), (1, 2, 1.0, False), (0, 2, 9.0, True)):  # the loop is false
        ...     _ = graph.add_edge(a, b, Pose2D(x, 0.0, 0.0), 100 * np.eye(3), robust=loop)
        >>> trust = graph.optimize()
        >>> trust.round(2).tolist(), round(graph.pose(2).x, 1)
        ([1.0, 1.0, 0.0], 2.0)
        """
        poses, trust = optimize(self.edges, self.poses, rounds, slack)
        self._poses[: self.size] = poses
        return trust

    def restart(self) -> Array:
        """Like `optimize`, but from the chordal solution of the trusted edges if the result is better; return the trust."""
        edges = self.edges
        trust = self.optimize()
        sure = Problem(*(part[trust > 0.5] for part in vars(edges).values()))
        if not len(sure.i):
            return trust
        poses, other = optimize(edges, chordal(sure, self.poses))
        if cost(edges, residuals(edges, poses)) < cost(edges, residuals(edges, self.poses)) - 1e-9:
            self._poses[: self.size] = poses
            trust = other
        return trust

    def trust(self) -> Array:
        """Return (m,) the trust in each edge at the current poses: 1, or less for doubtful ones that disagree."""
        return trust_of(self.edges, residuals(self.edges, self.poses))

    def error_of(self, edge: int) -> float:
        """Return the squared error of an edge at the current poses, in sigmas.

        >>> graph = PoseGraph()
        >>> _ = graph.add_node(Pose2D()), graph.add_node(Pose2D(1.3, 0.0, 0.0))
        >>> edge = graph.add_edge(0, 1, Pose2D(1.0, 0.0, 0.0), np.eye(3) / 0.1**2)  # sigma 0.1 m: the error is 3 sigmas
        >>> round(graph.error_of(edge), 6)
        9.0
        """
        problem = Problem(*(part[edge : edge + 1] for part in vars(self.edges).values()))
        return float(squared_errors(problem, residuals(problem, self.poses))[0])
