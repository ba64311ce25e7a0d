"""Odometry from a laser alone: each scan is matched with the walls that were seen just before."""

from __future__ import annotations

from coursekit.geometry.plane import Pose2D
from coursekit.slam.frontend import Tracker
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Scan


class LaserOdometry:
    """Adds up the motions between scans; it drifts slowly, as it forgets walls that are out of sight.

    >>> import numpy as np
    >>> corner = np.array([[2.0, y / 20] for y in range(-20, 20)] + [[x / 20, 1.0] for x in range(-20, 40)])
    >>> odometry, params = LaserOdometry(), SlamParameters()
    >>> for moved in (0.0, 0.05, 0.1):
    ...     seen = odometry.add(Scan.from_points(corner - np.array([moved, 0.0]), params, stamp=moved))
    >>> seen, odometry.pose.distance(Pose2D(0.1, 0.0, 0.0)) < 0.01
    (True, True)
    """

    def __init__(self, pose: Pose2D | None = None, params: SlamParameters | None = None) -> None:
        self.params = params or SlamParameters()
        self.pose = pose or Pose2D()
        self.motion = Pose2D()
        """The motion of the last scan, in the robot's frame."""
        self._tracker, self._keyframes = Tracker(self.params), 0

    def add(self, scan: Scan) -> bool:
        """Move to where the next scan fits; return whether it fits. Where it does not, the robot stands still."""
        tracker, before = self._tracker, self._tracker.pose
        accepted = tracker.track(scan, None)[2]
        self.motion = before.to(tracker.pose) if accepted else Pose2D()
        if not accepted:
            tracker.pose = before
        self.pose = self.pose @ self.motion
        if accepted and len(scan.points) and (not tracker.submaps or tracker.moved_enough()):
            tracker.insert(self._keyframes, scan)
            self._keyframes += 1
            tracker.finished.clear()
        return accepted
