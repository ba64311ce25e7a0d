"""A local map for scan matching: wall points with normals, and fields for constant-time look-ups."""

from __future__ import annotations

import numpy as np

from coursekit.geometry.plane import Array, Pose2D, rotation
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Scan
from coursekit.slam.submap_kernels import insert_points

COARSE = 4
"""Size of a coarse cell, in cells."""
FARTHEST = 200.0
"""Points farther than this from the frame's origin [m] are dropped: fields must not fill the memory."""
MARGIN = 64
"""Extra cells when growing, to make it rare; a multiple of COARSE."""


class Submap:
    """Wall points of several scans in one frame; nearby points of one wall are merged into their mean.

    `nearest` is the nearest wall point of a cell, `likelihood` (0 to 255) the likelihood of a beam's end there, `coarse` the
    highest likelihood of a block of cells and the blocks above and to the right of it.

    >>> submap = Submap(SlamParameters())
    >>> for x in (1.0, 1.01):  # the same wall point, seen twice
    ...     submap.insert(Scan.from_points(np.array([[x, 0.0]]), submap.params), Pose2D())
    >>> submap.points[: submap.count].round(3).tolist()
    [[1.005, 0.0]]
    """

    def __init__(self, params: SlamParameters, anchor: int = 0) -> None:
        self.params = params
        self.anchor = anchor
        """The keyframe whose pose is this submap's frame."""
        self.members: dict[int, Pose2D] = {}
        """Its keyframes, with their poses in this frame."""
        self.count = 0
        self.points = np.zeros((256, 2))
        self.normals = np.zeros((256, 2))
        self.weights = np.zeros(256)
        """The number of hits averaged in each point."""
        self.origin = np.zeros(2)
        """Lower left corner of the fields."""
        self.nearest = np.full((0, 0), -1, dtype=np.int32)
        self.likelihood = np.zeros((0, 0), dtype=np.uint8)
        self.coarse = np.zeros((0, 0), dtype=np.uint8)

    def insert(self, scan: Scan, pose: Pose2D) -> None:
        """Add a scan's points, seen from `pose` in this frame."""
        self._add(scan.points, scan.normals, pose)
        self._add(scan.filled, scan.filled_normals, pose)

    def _add(self, points: Array, normals: Array, pose: Pose2D) -> None:
        """Add points with normals."""
        moved = pose.transform(points)
        near = np.abs(moved).max(axis=1, initial=0.0) < FARTHEST
        moved = np.ascontiguousarray(moved[near])
        turned = np.ascontiguousarray((normals @ rotation(pose.theta).T)[near])
        if not len(moved):
            return
        self._make_room(moved)
        p = self.params
        self.count = insert_points(
            moved, turned, self.points, self.normals, self.weights, self.count, self.nearest, self.likelihood,
            self.coarse, self.origin[0], self.origin[1], p.cell, p.field_reach, p.field_sigma, p.merge_distance,
        )  # fmt: skip

    def _make_room(self, points: Array) -> None:
        """Enlarge arrays and fields to fit the points."""
        while self.count + len(points) > len(self.points):
            self.points, self.normals = (
                np.concatenate([a, np.zeros_like(a)]) for a in (self.points, self.normals)
            )
            self.weights = np.concatenate([self.weights, np.zeros_like(self.weights)])
        cell = self.params.cell
        reach = self.params.field_reach + (COARSE + 1) * cell  # a rim of empty coarse cells
        rows, columns = self.nearest.shape
        top = self.origin + np.array([columns, rows]) * cell
        low, high = points.min(axis=0) - reach, points.max(axis=0) + reach
        if not self.nearest.size:
            self.origin = top = np.floor(low / (cell * COARSE)) * cell * COARSE
        before = np.where(low < self.origin, np.ceil((self.origin - low) / cell), 0).astype(int)
        after = np.where(high > top, np.ceil((high - top) / cell), 0).astype(int)
        if before.any() or after.any():
            self._grow(_roomy(before), _roomy(after))

    def _grow(self, before: np.ndarray, after: np.ndarray) -> None:
        """Add cells below/left (`before`) and above/right (`after`), (x, y) each."""
        pads = ((before[1], after[1]), (before[0], after[0]))
        self.nearest = np.pad(self.nearest, pads, constant_values=-1)
        self.likelihood = np.pad(self.likelihood, pads)
        self.coarse = np.pad(self.coarse, tuple((a // COARSE, b // COARSE) for a, b in pads))
        self.origin = self.origin - before * self.params.cell

    def finish(self) -> None:
        """Drop the fields; `restore` recreates them.

        >>> submap = Submap(SlamParameters())
        >>> submap.insert(Scan.from_points(np.array([[1.0, 0.0]]), submap.params), Pose2D())
        >>> before = submap.likelihood.sum()
        >>> submap.finish()
        >>> submap.likelihood.size
        0
        >>> submap.restore()
        >>> bool(submap.likelihood.sum() == before)
        True
        """
        self.points, self.normals = self.points[: self.count].copy(), self.normals[: self.count].copy()
        self.weights = self.weights[: self.count].copy()
        self.nearest = np.full((0, 0), -1, dtype=np.int32)
        self.likelihood, self.coarse = (np.zeros((0, 0), dtype=np.uint8) for _ in range(2))

    def restore(self) -> None:
        """Recreate the fields of a finished submap."""
        if self.nearest.size or not self.count:
            return
        points, normals, weights = self.points, self.normals, self.weights
        self.count = 0
        self._make_room(points)
        p = self.params
        self.count = insert_points(
            points, normals, self.points, self.normals, self.weights, 0, self.nearest, self.likelihood, self.coarse,
            self.origin[0], self.origin[1], p.cell, p.field_reach, p.field_sigma, 0.0,
        )  # fmt: skip
        self.weights[: self.count] = weights[: self.count]


def _roomy(cells: np.ndarray) -> np.ndarray:
    """Round up the cells to add: at least MARGIN more, in whole coarse cells."""
    return np.where(cells > 0, -(-(cells + MARGIN) // COARSE) * COARSE, 0)
