"""A map for the particle filter: distances to the nearest wall, and the free floor."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import distance_transform_edt

from coursekit.nav.map_file import GridMap

WALL, FREE = 65, 25
"""Cells from WALL on are walls; known cells up to FREE are floor."""


class ParticleMap:
    """Distances to the nearest wall [m], at most `farthest`.

    >>> ParticleMap(GridMap(np.array([[100, 0, 0, 0]], np.int8), 0.5), farthest=1.25).distances.tolist()
    [[0.0, 0.5, 1.0, 1.25]]
    """

    def __init__(self, grid: GridMap, farthest: float = 2.0) -> None:
        walls = grid.cells >= WALL
        if not walls.any():
            raise ValueError("the map holds no walls: nothing to localise against")
        self.cell, self.farthest = grid.resolution, farthest
        self.x, self.y = grid.origin[0], grid.origin[1]
        away = np.asarray(distance_transform_edt(~walls)) * grid.resolution
        self.distances = np.minimum(away, farthest).astype(np.float32)
        self._free = np.argwhere((grid.cells >= 0) & (grid.cells <= FREE))
        if not len(self._free):
            raise ValueError("the map holds no free floor: a robot cannot be in it")

    def anywhere(self, count: int, rng: np.random.Generator) -> np.ndarray:
        """Return (count, 3) random poses on the free floor, with any heading."""
        cells = self._free[rng.integers(len(self._free), size=count)] + rng.random((count, 2))
        x, y = self.x + cells[:, 1] * self.cell, self.y + cells[:, 0] * self.cell
        return np.column_stack([x, y, rng.uniform(-np.pi, np.pi, count)])
