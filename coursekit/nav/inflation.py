"""Inflation: raises the costs near obstacles, by nav2's formula."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from coursekit.nav.costmap import INSCRIBED, LETHAL, Cells


def cost_at(distance: float, inscribed: float, scaling: float) -> int:
    """Return the cost at a distance [m] from an obstacle: 253 within the inscribed radius, then exponentially falling.

    >>> [cost_at(d, 0.22, 3.0) for d in (0.0, 0.22, 0.32, 0.55)]
    [254, 253, 186, 93]
    """
    if distance <= 0:
        return LETHAL
    if distance <= inscribed:
        return INSCRIBED
    return int((INSCRIBED - 1) * math.exp(-scaling * (distance - inscribed)))


class Inflation:
    """Spreads costs up to `radius` [m] around obstacles, for robots with an inscribed radius [m].

    >>> cells = np.zeros((1, 5), np.uint8); cells[0, 0] = 254
    >>> Inflation(0.55, 3.0, 0.22, 0.2).spread(cells); cells.tolist()
    [[254, 253, 146, 0, 0]]
    """

    def __init__(self, radius: float, scaling: float, inscribed: float, resolution: float) -> None:
        self.reach = int(radius / resolution)
        around = np.arange(-self.reach, self.reach + 1)
        distances = np.hypot(*np.meshgrid(around, around))
        costs = [
            cost_at(distance * resolution, inscribed, scaling) if distance <= self.reach else 0
            for distance in distances.ravel()
        ]
        self._stamp = np.array(costs, dtype=np.uint8).reshape(distances.shape)

    def spread(self, cells: Cells, unknown: bool = False) -> None:
        """Raise the costs around obstacles, in place; of unknown cells only the nearest ones, or all with `unknown`."""
        spread(cells, self._stamp, self.reach, unknown)


@njit(cache=True)
def spread(cells, stamp, reach, unknown):  # type: ignore[no-untyped-def]
    """Apply the stamp to every obstacle cell that is not surrounded by obstacles.

    >>> cells = np.zeros((1, 4), np.uint8)
    >>> cells[0, 0] = 254
    >>> spread(cells, np.array([[9, 99, 9]], np.uint8).repeat(3, axis=0), 1, False)
    >>> cells.tolist()
    [[254, 9, 0, 0]]
    """
    rows, columns = cells.shape
    for i in range(rows):
        for j in range(columns):
            if cells[i, j] != 254 or _enclosed(cells, i, j):
                continue
            for k in range(max(i - reach, 0), min(i + reach + 1, rows)):
                for m in range(max(j - reach, 0), min(j + reach + 1, columns)):
                    old, new = cells[k, m], stamp[k - i + reach, m - j + reach]
                    if old == 255:
                        if new >= 253 or (unknown and new > 0):
                            cells[k, m] = new
                    elif new > old:
                        cells[k, m] = new


@njit(cache=True)
def _enclosed(cells, i, j):  # type: ignore[no-untyped-def]
    rows, columns = cells.shape
    for k in range(max(i - 1, 0), min(i + 2, rows)):
        for m in range(max(j - 1, 0), min(j + 2, columns)):
            if cells[k, m] != 254:
                return False
    return True
