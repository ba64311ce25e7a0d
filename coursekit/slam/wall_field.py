"""A distance field: the distance from any position to the nearest of some points, for scan matchers."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.ndimage import distance_transform_edt

MOST_CELLS = 50_000_000


class WallField:
    """Distances to the nearest of `points` (n, 2) [m], stored in cells; beyond `reach` they count as `reach` [m].

    >>> field = WallField(np.array([[0.0, 0.0], [1.0, 0.0]]))
    >>> field([[0.01, 0.3], [50.0, 50.0]]).round(1).tolist()
    [0.3, 0.5]
    """

    def __init__(self, points: Any, cell: float = 0.02, reach: float = 0.5) -> None:
        walls = np.asarray(points, float).reshape(-1, 2)
        if not len(walls) or not np.isfinite(walls).all():
            raise ValueError("a field needs points, and finite ones: leave out the beams that met nothing")
        self.points, self.cell, self.reach = walls, cell, reach
        self._corner = walls.min(axis=0) - reach - cell
        columns, rows = np.ceil((walls.max(axis=0) + reach + cell - self._corner) / cell).astype(int) + 1
        if rows * columns > MOST_CELLS:
            raise ValueError(f"{columns} by {rows} cells are too many: use larger cells, or leave out the points far away")
        open_ = np.ones((rows, columns), bool)
        at = np.floor((walls - self._corner) / cell).astype(int)
        open_[at[:, 1], at[:, 0]] = False
        self._gaps = np.minimum(distance_transform_edt(open_) * cell, reach)

    def __call__(self, points: Any) -> np.ndarray:
        """Return the distance at each of the points (n, 2) [m]."""
        at = np.floor((np.asarray(points, float).reshape(-1, 2) - self._corner) / self.cell).astype(int)
        rows, columns = self._gaps.shape
        inside = ((at >= 0) & (at < (columns, rows))).all(axis=1)
        gaps = np.full(len(at), self.reach)
        gaps[inside] = self._gaps[at[inside, 1], at[inside, 0]]
        return gaps
