"""Keeping the map in step with the keyframes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursekit.geometry.plane import Array, Pose2D, wrap
from coursekit.slam.grid import OccupancyGrid
from coursekit.slam.keyframe import Keyframe
from coursekit.slam.parameters import SlamParameters


class MapDrawing:
    """A grid, and the poses from which its scans were drawn.

    >>> from coursekit.slam.scan import Scan
    >>> params = SlamParameters()
    >>> keyframes = [Keyframe(0, Scan.from_points(np.array([[1.0, 0.02]]), params))]
    >>> drawing = MapDrawing(params)
    >>> [drawing.draw(keyframes, np.array([[x, 0.0, 0.0]])).value_at(1.0, 0.02) > 50 for x in (0.0, 3.0)]
    [True, False]
    """

    def __init__(self, params: SlamParameters) -> None:
        self._params = params
        self._grid = OccupancyGrid(params)
        self._drawn = np.zeros((0, 3))

    def draw(self, keyframes: Sequence[Keyframe], poses: Array) -> OccupancyGrid:
        """Return the grid with all keyframes: new ones are added; everything is redrawn when old ones have moved."""
        if self._moved(poses):
            self._grid, self._drawn = OccupancyGrid(self._params), np.zeros((0, 3))
        for keyframe in keyframes[len(self._drawn) :]:
            self._grid.insert(keyframe.scan, Pose2D.of(poses[keyframe.number]))
        self._drawn = poses.copy()
        return self._grid

    def _moved(self, poses: Array) -> bool:
        """Whether a drawn pose has moved by more than a hundredth of a cell, or of a degree."""
        change = poses[: len(self._drawn)] - self._drawn
        if not len(change):
            return False
        far = np.abs(change[:, :2]).max() > 0.01 * self._params.resolution
        return bool(far or np.abs(wrap(change[:, 2])).max() > 2e-4)
