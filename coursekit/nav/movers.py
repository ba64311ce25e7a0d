"""Moving obstacles in a rolling costmap, and their predicted positions."""

from __future__ import annotations

from collections import deque

import numpy as np
from scipy import ndimage

from coursekit.nav.costmap import FREE, INSCRIBED, LETHAL, UNKNOWN, Costmap

LOOK_BACK = (0.9, 1.7)
"""Ages of the costmaps used for comparison [s]; only cells occupied in none of them can count as newly occupied."""
JITTER = 2.2
"""Apparent motion of the edge of a static obstacle [cells]."""
FASTEST = 1.0
"""Maximum speed of obstacles [m/s]; an apparently faster one has just come into view."""
EVERY = 0.09
"""Minimum interval between observations [s]."""


class Movers:
    """Compares the obstacles of a costmap with earlier ones: an obstacle on formerly free floor has moved.

    >>> def room(x):
    ...     made = Costmap.of_size(3.0, 1.0, 0.05); made.cells[8:12, round(x / 0.05)] = LETHAL; return made
    >>> movers = Movers(seconds=1.0)
    >>> for k in range(12):
    ...     movers.see(room(1.0 + 0.03 * k), k * 0.1)
    >>> [(round(float(one), 1)) for one in movers.found[0][1]]
    [0.3, 0.0]
    """

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds
        self._past: deque[tuple[float, Costmap]] = deque()
        self.found: list[tuple[np.ndarray, np.ndarray]] = []
        """Cells (n, 2: row, column) of each moving obstacle, and its velocity (x, y) [m/s]."""

    def see(self, costs: Costmap, now: float) -> None:
        """Process the obstacles at a time [s]."""
        if self._past and not 0.0 <= now - self._past[-1][0] < 1.0:
            self._past.clear()
        if self._past and now - self._past[-1][0] < EVERY:
            return
        while self._past and now - self._past[0][0] > LOOK_BACK[1]:
            self._past.popleft()
        old = [(now - then, earlier) for then, earlier in self._past if now - then >= LOOK_BACK[0] - 1e-6]
        self.found = self._compare(costs, [earlier for _, earlier in old], old[-1][0]) if old else []
        self._past.append((now, Costmap(costs.cells.copy(), costs.resolution, costs.x, costs.y)))

    def _compare(self, costs: Costmap, old: list[Costmap], age: float) -> list[tuple[np.ndarray, np.ndarray]]:
        before = [grid.moved_to(costs.x, costs.y, UNKNOWN).cells for grid in old]
        standing = np.logical_or.reduce([cells == LETHAL for cells in before])
        solid = costs.cells == LETHAL
        if not standing.any():
            return []
        gap, nearest = ndimage.distance_transform_edt(~standing, return_indices=True)
        fresh = solid & (gap > JITTER) & np.logical_and.reduce([cells == FREE for cells in before])
        fresh &= gap * costs.resolution < FASTEST * age
        labels, count = ndimage.label(ndimage.binary_dilation(fresh, iterations=2))
        return [self._mover(costs, labels == k, fresh, solid, gap, nearest, age) for k in range(1, count + 1)]

    @staticmethod
    def _mover(costs, place, fresh, solid, gap, nearest, age):  # type: ignore[no-untyped-def]
        """Return one moving obstacle: its cells near the fresh ones, and the velocity of the foremost of those."""
        rows, columns = np.nonzero(fresh & place)
        front = gap[rows, columns] >= 0.7 * gap[rows, columns].max()
        came = np.stack([columns - nearest[1][rows, columns], rows - nearest[0][rows, columns]], axis=1)[front]
        velocity = came.mean(axis=0) * costs.resolution / age
        near = ndimage.binary_dilation(place, iterations=6)
        return np.argwhere(solid & near), velocity

    def ahead(self, costs: Costmap, radius: float) -> np.ndarray:
        """Return a mask (rows, columns) of the predicted cells of moving obstacles, grown by `radius` [m].

        >>> movers, room = Movers(seconds=1.0), Costmap.of_size(1.0, 0.1, 0.1)
        >>> movers.found = [(np.array([[0, 2]]), np.array([0.4, 0.0]))]  # the cell in column 2 moves at 0.4 m/s along x
        >>> np.flatnonzero(movers.ahead(room, radius=0.0)).tolist()
        [3, 4, 5, 6]
        """
        swept = np.zeros(costs.cells.shape, dtype=bool)
        for cells, velocity in self.found:
            steps = max(int(np.hypot(*velocity) * self.seconds / costs.resolution), 1)
            for share in np.arange(1, steps + 1) / steps:
                move = np.rint(velocity[::-1] * self.seconds * share / costs.resolution).astype(int)
                at = cells + move
                good = ((at >= 0) & (at < swept.shape)).all(axis=1)
                swept[tuple(at[good].T)] = True
        if not swept.any():
            return swept
        return np.asarray(ndimage.distance_transform_edt(~swept) * costs.resolution <= radius)

    def mark(self, costs: Costmap, radius: float) -> None:
        """Raise the cost of those cells to that of cells beside an obstacle."""
        if self.found:
            costs.cells[self.ahead(costs, radius) & (costs.cells < INSCRIBED)] = INSCRIBED
