"""Localization in a finished map."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from coursekit.geometry.plane import Array, Pose2D
from coursekit.slam.frontend import Tracker
from coursekit.slam.keyframe import Keyframe
from coursekit.slam.loop_field import LoopField
from coursekit.slam.matcher import sample
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.refine import refine
from coursekit.slam.scan import Scan
from coursekit.slam.slam import Result
from coursekit.slam.submap import Submap
from coursekit.slam.submaps import map_submap, submap_of


class Localizer:
    """Tracks the robot against one map; never changes it. In ROS 2: slam_toolbox's localization mode.

    >>> cells = np.zeros((40, 60), np.int8)
    >>> cells[[0, -1]], cells[:, [0, -1]] = 100, 100  # the walls of a room of 6 m by 4 m
    >>> localizer = Localizer.from_cells(cells, 0.1, (0.0, 0.0), SlamParameters())
    >>> localizer.set_pose(Pose2D(2.0, 1.0, 0.5))
    >>> localizer.pose.distance(Pose2D(2.0, 1.0, 0.5)) < 1e-9
    True
    """

    def __init__(self, submap: Submap, frame: Pose2D, params: SlamParameters) -> None:
        if not submap.count:
            raise ValueError("the map holds no walls: nothing to localise against")
        self.params = params
        self._submap, self._frame = submap, frame
        self._tracker = Tracker(params)
        self._tracker.start(submap, submap.anchor, Pose2D())
        self._field: LoopField | None = None
        self.lost = 0
        """Scans without a match since the last accepted one."""

    @classmethod
    def from_keyframes(cls, keyframes: Sequence[Keyframe], poses: Array, params: SlamParameters) -> Localizer:
        """Use the map of a finished SLAM: `Localizer.from_keyframes(slam.keyframes, slam.graph.poses, slam.params)`."""
        if not keyframes:
            raise ValueError("no keyframes: nothing to localise against")
        return cls(submap_of(keyframes, range(len(keyframes)), poses, params), Pose2D.of(poses[0]), params)

    @classmethod
    def from_cells(
        cls, cells: np.ndarray, resolution: float, origin: tuple[float, float], params: SlamParameters
    ) -> Localizer:
        """Use a map like nav_msgs/OccupancyGrid: cells (rows, columns) 0 to 100, row 0 the lowest y."""
        rows, columns = np.nonzero(cells >= 65)
        points = (np.stack([columns, rows], axis=1) + 0.5) * resolution + np.array(origin)
        return cls(*map_submap(points, params), params)

    @property
    def pose(self) -> Pose2D:
        """The robot's pose in the map."""
        return self._frame @ self._tracker.pose

    def set_pose(self, pose: Pose2D) -> None:
        """Set the robot's pose, as /initialpose does."""
        self._tracker.start(self._submap, self._submap.anchor, self._frame.to(pose))

    def add(self, scan: Scan, odometry: Pose2D | None = None) -> Result:
        """Process the next scan."""
        refined, score, accepted = self._tracker.track(scan, odometry)
        self.lost = 0 if accepted else self.lost + 1
        return Result(self.pose, score, accepted, refined.degeneracy, refined.covariance)

    def find(
        self, scan: Scan, near: Pose2D | None = None, distance: float | None = None, turn: float = math.pi
    ) -> tuple[Pose2D, float]:
        """Search for the robot in the whole map, or within `distance` [m] and `turn` [rad] of a pose.

        Returns the pose and its score, and continues from there; a score of 0 means that it was not found.
        """
        p, points = self.params, self._submap.points[: self._submap.count]
        if self._field is None:
            self._field = LoopField(points, p.loop_cell)
        low, high = points.min(axis=0), points.max(axis=0)
        middle = Pose2D.of((*(low + high) / 2, 0.0))
        guess = self._frame.to(near) if near is not None else middle
        reach = distance if distance is not None else float((high - low).max()) / 2
        pose, score = self._field.find(
            sample(scan.points, 100), guess, reach, turn, p.loop_angle_step, p.minimum_score
        )
        if score > 0:
            refined = refine(scan.points, self._submap, pose, pose, np.zeros((3, 3)), gate=0.4, rounds=15)
            self.set_pose(self._frame @ refined.pose)
        return (self.pose, score) if score > 0 else (guess, 0.0)
