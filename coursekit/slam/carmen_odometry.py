"""The ODOM lines of a CARMEN log, for scans without their own odometry."""

from __future__ import annotations

import numpy as np

from coursekit.geometry.plane import Pose2D
from coursekit.slam.carmen_line import parse_odometry


class OdometryTrack:
    """Poses by their stamps.

    >>> track = OdometryTrack()
    >>> for line in ("ODOM 0 0 0 0 0 0 1.0 host 1.0", "ODOM 2 0 0 0 0 0 3.0 host 3.0"):
    ...     track.add(line)
    >>> track.at(1.5)
    Pose2D(x=0.5, y=0.0, theta=0.0)
    """

    def __init__(self) -> None:
        self._rows: list[tuple[float, float, float, float]] = []
        self._sorted: np.ndarray | None = None

    def add(self, line: str) -> None:
        """Parse an ODOM line. Raises ValueError with the reason."""
        self._rows.append(parse_odometry(line))
        self._sorted = None

    def at(self, stamp: float) -> Pose2D:
        """Return the pose at a time, interpolated; the first or last one outside of the track, the origin without any."""
        if not self._rows:
            return Pose2D()
        if self._sorted is None:
            rows = np.array(sorted(self._rows))
            rows[:, 3] = np.unwrap(rows[:, 3])
            self._sorted = rows
        rows = self._sorted
        return Pose2D.of([float(np.interp(stamp, rows[:, 0], rows[:, k])) for k in (1, 2, 3)])


__all__ = ["OdometryTrack"]
