"""The SLAM itself: scans in, poses and a map out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from coursekit.geometry.plane import Array, Pose2D, compose
from coursekit.slam.frontend import Tracker
from coursekit.slam.graph import PoseGraph
from coursekit.slam.grid import OccupancyGrid
from coursekit.slam.keyframe import Keyframe
from coursekit.slam.loops import Loop, LoopSearch
from coursekit.slam.map_drawing import MapDrawing
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.refine import Refined
from coursekit.slam.scan import Laser, Scan


@dataclass(frozen=True)
class Result:
    """The result of `Slam.add`."""

    pose: Pose2D
    """The robot's pose in the map."""
    score: float
    """The quality of the match, 0 to 1."""
    accepted: bool
    """False: no match was accepted, the pose comes from the odometry alone."""
    degeneracy: float
    """0: the walls constrain all directions alike; towards 1: one is unconstrained, as in a bare corridor."""
    covariance: Array
    """(3, 3) covariance of the pose, from this match alone [m², rad²]."""
    keyframe: bool = False
    loops: tuple[Loop, ...] = ()
    """Loops confirmed by this scan."""
    corrected: bool = False
    """Earlier poses have been moved: the map must be redrawn."""


class Slam:
    """Simultaneous localisation and mapping with a planar laser. In ROS 2: slam_toolbox.

    >>> slam = Slam()
    >>> laser = Laser(angle_min=0.0, angle_increment=0.1)
    >>> slam.add_ranges(0.0, [1.0, 1.0, 1.0], laser, Pose2D()).keyframe
    True
    >>> slam.trajectory()
    array([[0., 0., 0., 0.]])
    """

    def __init__(self, params: SlamParameters | None = None, start: Pose2D | None = None) -> None:
        self.params = params or SlamParameters()
        self.graph = PoseGraph()
        self.keyframes: list[Keyframe] = []
        self.tracker = Tracker(self.params)
        self.search = LoopSearch(self.params, self.keyframes)
        self.loops: list[Loop] = []
        """All accepted loops."""
        self.lost = 0
        """Scans without a match."""
        self.stamps: list[float] = []
        self.bases: list[int] = []
        """The keyframe to which each scan is connected,"""
        self.motions: list[Pose2D] = []
        """and the motion from it."""
        self._start = start or Pose2D()
        self._waiting = 0
        self._drawing = MapDrawing(self.params)

    def add_ranges(
        self, stamp: float, ranges: Sequence[float] | np.ndarray, laser: Laser, odometry: Pose2D | None = None
    ) -> Result:
        """Process the next scan as ranges [m]; see `add`."""
        return self.add(Scan.from_ranges(ranges, laser, self.params, stamp), odometry)

    def add(self, scan: Scan, odometry: Pose2D | None = None) -> Result:
        """Process the next scan, with the robot's odometry pose if available.

        Without odometry the motion is predicted from that between the last two scans.

        >>> slam = Slam()
        >>> corner = np.array([[2.0, y / 20] for y in range(-20, 20)] + [[x / 20, 1.0] for x in range(-20, 40)])
        >>> for step in (0.0, 0.1):  # the robot drives 10 cm towards the wall
        ...     result = slam.add(Scan.from_points(corner - (step, 0.0), slam.params))
        >>> round(result.pose.x, 2), result.accepted
        (0.1, True)
        """
        refined, score, accepted = self.tracker.track(scan, odometry)
        self.lost += not accepted
        loops: list[Loop] = []
        corrected, fresh = False, not self.keyframes or self.tracker.moved_enough()
        if fresh:
            self._add_keyframe(scan, refined)
            loops = self.search.search(self.keyframes[-1], self.graph)
            corrected = self._close(loops)
        self.stamps.append(scan.stamp)
        self.bases.append(self.tracker.base)
        self.motions.append(self.tracker.from_keyframe())
        return Result(self.pose, score, accepted, refined.degeneracy, refined.covariance, fresh, tuple(loops), corrected)

    @property
    def pose(self) -> Pose2D:
        """The robot's pose in the map."""
        if not self.keyframes:
            return self._start
        return self.graph.pose(self.tracker.base) @ self.tracker.from_keyframe()

    def begin_at(self, pose: Pose2D) -> None:
        """Set the robot's pose in the map at its first scan; later it has no effect.

        >>> slam = Slam()
        >>> slam.begin_at(Pose2D(3.0, 1.0, 0.0))
        >>> slam.add_ranges(0.0, [1.0, 1.0], Laser(angle_min=0.0, angle_increment=0.1)).pose
        Pose2D(x=3.0, y=1.0, theta=0.0)
        """
        self._start = pose

    def _add_keyframe(self, scan: Scan, refined: Refined) -> None:
        """Store a scan as a keyframe, and connect it to the one before."""
        tracker = self.tracker
        number = self.graph.add_node(self.pose)
        if self.keyframes:
            motion = tracker.from_keyframe()
            self.graph.add_edge(tracker.base, number, motion, tracker.edge_precision(refined))
        self.keyframes.append(Keyframe(number, scan))
        tracker.insert(number, scan)
        while tracker.finished:
            self.search.add(tracker.finished.pop(0))

    def _close(self, loops: list[Loop]) -> bool:
        """Add loops to the graph; optimize when they move anything. True when poses have moved."""
        off = 0.0
        edges = []
        for loop in loops:
            there = self.graph.pose(loop.first) @ loop.motion
            off = max(off, there.distance(self.graph.pose(loop.second)))
            edges.append(
                self.graph.add_edge(loop.first, loop.second, loop.motion, loop.precision, robust=True)
            )
        self.loops += loops
        self._waiting += len(loops)
        if off < self.params.loop_tension and self._waiting < self.params.loop_batch:
            return False
        self._waiting = 0
        self.graph.optimize(rounds=8, slack=max((self.graph.error_of(edge) for edge in edges), default=0.0))
        return True

    def finish(self) -> None:
        """Finish pending optimization; more scans may follow."""
        self.graph.restart()
        self._waiting = 0

    @property
    def rejected(self) -> int:
        """Number of loops that no other one confirmed, or that the rest of the graph contradicts."""
        edges = self.graph.edges
        return self.search.rejected + int((self.graph.trust()[edges.robust] < 0.1).sum())

    def map(self) -> OccupancyGrid:
        """Return the map: new scans are added, and all are redrawn after poses have moved. Do not modify it.

        >>> slam = Slam()
        >>> _ = slam.add_ranges(0.0, [1.0, 1.0, 1.0], Laser(angle_min=-0.1, angle_increment=0.1), Pose2D())
        >>> slam.map().value_at(1.02, 0.0) > 50
        True
        """
        return self._drawing.draw(self.keyframes, self.graph.poses)

    def trajectory(self) -> Array:
        """Return (n, 4) `stamp x y theta`, a row for each scan."""
        if not self.stamps:
            return np.zeros((0, 4))
        return np.column_stack([self.stamps, compose(self.graph.poses[self.bases], np.array(self.motions))])
