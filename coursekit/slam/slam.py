"""SLAM itself: scans in, poses and a map out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from coursekit.slam.frontend import Tracker
from coursekit.slam.graph import PoseGraph
from coursekit.slam.grid import OccupancyGrid
from coursekit.slam.keyframe import Keyframe
from coursekit.slam.loops import Loop, LoopSearch
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.pose import Array, Pose2, compose
from coursekit.slam.refine import Refined
from coursekit.slam.scan import Scan


@dataclass(frozen=True)
class Result:
    """What `Slam.add` found."""

    pose: Pose2
    score: float
    """0 (nothing fits) to 1."""
    accepted: bool
    """False: nothing matched, the pose comes from the odometry alone."""
    keyframe: bool
    degeneracy: float


class Slam:
    """Simultaneous localisation and mapping with a planar laser.

    >>> slam = Slam()
    >>> slam.add(Scan.from_points(np.array([[1.0, 0.0]]), slam.params), Pose2()).pose
    Pose2(x=0.0, y=0.0, theta=0.0)
    """

    def __init__(self, params: SlamParameters = SlamParameters()) -> None:
        self.params = params
        self.graph = PoseGraph()
        self.keyframes: list[Keyframe] = []
        self.tracker = Tracker(params)
        self.loops = LoopSearch(params)
        self.loops_accepted = 0
        self.lost = 0
        """Scans without a match."""
        self._dirty = 0
        self._stamps: list[float] = []
        self._bases: list[int] = []
        self._motions: list[Pose2] = []

    def add(self, scan: Scan, odometry: Pose2 | None = None) -> Result:
        """Take the next scan."""
        tracker = self.tracker
        found, score, accepted = tracker.track(scan, odometry)
        self.lost += not accepted
        fresh = not self.keyframes or tracker.moved_enough()
        if fresh:
            self._add_keyframe(scan, found)
        self._stamps.append(scan.stamp)
        self._bases.append(len(self.keyframes) - 1)
        self._motions.append(tracker.from_keyframe())
        pose = self.graph.pose(self._bases[-1]) @ self._motions[-1]
        return Result(pose, score, accepted, fresh, found.degeneracy)

    def _add_keyframe(self, scan: Scan, found: Refined) -> None:
        """Remember a scan, tie it to the one before."""
        tracker = self.tracker
        if not self.keyframes:
            number = self.graph.add_node(Pose2())
        else:
            motion = tracker.from_keyframe()
            last = len(self.keyframes) - 1
            number = self.graph.add_node(self.graph.pose(last) @ motion)
            self.graph.add_edge(last, number, motion, tracker.edge_precision(found))
        self.keyframes.append(Keyframe(number, scan))
        tracker.insert(number, scan)
        for submap in tracker.finished:
            self.loops.add(submap)
        tracker.finished.clear()
        self._close(self.loops.search(self.keyframes[-1], self.graph))

    def _close(self, loops: list[Loop]) -> None:
        """Tie loops into the graph; optimize when they move something."""
        before = [self.graph.pose(loop.first) @ loop.motion for loop in loops]
        for loop in loops:
            self.graph.add_edge(loop.first, loop.second, loop.motion, loop.precision, robust=True)
        self.loops_accepted += len(loops)
        self._dirty += len(loops)
        off = max(
            (pose.distance(self.graph.pose(x.second)) for pose, x in zip(before, loops, strict=True)),
            default=0.0,
        )
        if off > 0.1 or self._dirty > 20:
            self.graph.optimize(rounds=8)
            self._dirty = 0

    def finish(self) -> None:
        """Settle all that is open."""
        self.graph.optimize()

    @property
    def loops_rejected(self) -> int:
        """Loops that no other confirmed."""
        return self.loops.rejected

    def summary(self) -> str:
        return f"loops {self.loops_accepted}/{self.loops_rejected}"

    def map(self) -> OccupancyGrid:
        """The map, drawn from all keyframes."""
        grid = OccupancyGrid(self.params)
        grid.insert_all((k.scan, self.graph.pose(k.number)) for k in self.keyframes)
        return grid

    def trajectory(self) -> Array:
        """(n, 4) `stamp x y theta`, a row for each scan."""
        if not self._stamps:
            return np.zeros((0, 4))
        poses = compose(self.graph.poses[self._bases], np.array(self._motions))
        return np.column_stack([self._stamps, poses])
