"""A world of cells revealed bit by bit, for testing an explorer."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from scipy import ndimage

from coursekit.nav.map_compare import outline_points
from coursekit.sim import load_world

CELL = 0.1
BEAMS = 480
UNKNOWN, FREE, WALL = -1, 0, 100
Cell = tuple[int, int]


class Unseen:
    """A world file as cells; `cells` are the cells seen so far, `here` is the robot's cell (row, column).

    It starts at the world's start pose, or, with `part` from 0 to 1, at another cell of the floor connected to it.
    """

    def __init__(self, world: Path, sight: float = 4.0, part: float | None = None) -> None:
        loaded = load_world(world)
        cut = loaded.cut(0.2)
        points = outline_points(cut.edges, cut.circles, 0.02)
        corner = points.min(axis=0) - 5 * CELL
        columns, rows = np.ceil((points.max(axis=0) - corner) / CELL).astype(int) + 5
        self._open = np.ones((rows, columns), bool)
        at = np.floor((points - corner) / CELL).astype(int)
        self._open[at[:, 1], at[:, 0]] = False
        column, row = np.floor((np.array(loaded.start[:2]) - corner) / CELL).astype(int)
        self.here: Cell = (int(row), int(column))
        areas, _ = ndimage.label(self._open)
        self._reachable = areas == areas[self.here]
        if part is not None:
            floor = np.argwhere(self._reachable)
            self.here = tuple(floor[int(part * (len(floor) - 1))].tolist())
        self.cells = np.full((rows, columns), UNKNOWN, np.int8)
        self.driven = 0.0
        angles, along = np.linspace(0, 2 * math.pi, BEAMS, endpoint=False), np.arange(0, sight / CELL, 0.4)
        self._rays = np.stack([np.outer(np.sin(angles), along), np.outer(np.cos(angles), along)], axis=-1)
        self.look()

    def look(self) -> None:
        """Reveal the cells visible from here: free cells along each beam, up to the first wall."""
        at = np.floor(self._rays + np.array(self.here) + 0.5).astype(int)
        inside = ((at >= 0) & (at < self.cells.shape)).all(axis=-1)
        at = np.where(inside[..., None], at, 0)
        free = self._open[at[..., 0], at[..., 1]] & inside
        before = np.logical_and.accumulate(free, axis=1)
        first = inside & ~free & np.concatenate([np.ones((BEAMS, 1), bool), before[:, :-1]], axis=1)
        self.cells[at[before][:, 0], at[before][:, 1]] = FREE
        self.cells[at[first][:, 0], at[first][:, 1]] = WALL

    def can_go(self, goal: Cell) -> bool:
        """Whether neighbouring free cells lead to the goal."""
        areas, _ = ndimage.label(self.cells == FREE)
        return bool(self.cells[goal] == FREE and areas[goal] == areas[self.here])

    def go(self, goal: Cell) -> None:
        """Go to the goal and look."""
        self.driven += CELL * math.dist(goal, self.here)
        self.here = goal
        self.look()

    def known(self) -> float:
        """Return the share of the reachable floor that was seen."""
        return float((self.cells[self._reachable] != UNKNOWN).mean())

    def unseen_floor(self) -> np.ndarray:
        """Return the reachable floor that was not seen: bool (rows, columns)."""
        unseen: np.ndarray = self._reachable & (self.cells == UNKNOWN)
        return unseen

    def path(self, stops: list[Cell]) -> list[Cell]:
        """Return the cells of a short path over seen floor from each stop to the next."""
        from scipy.sparse.csgraph import breadth_first_order

        floor, columns, path = _neighbours(self.cells == FREE), self.cells.shape[1], stops[:1]
        for begin, end in pairwise(stops):
            before = breadth_first_order(floor, end[0] * columns + end[1])[1]
            at = begin[0] * columns + begin[1]
            while before[at] >= 0:
                at = int(before[at])
                path.append(divmod(at, columns))
        return path


def _neighbours(free: np.ndarray) -> Any:
    """Return the sparse adjacency matrix of free cells, by cell number."""
    from scipy.sparse import coo_matrix

    number = np.arange(free.size).reshape(free.shape)
    along, down = free[:, :-1] & free[:, 1:], free[:-1] & free[1:]
    ahead = down[:, :-1] & along[:-1] & along[1:]
    slopes = ((number[:-1, :-1], number[1:, 1:]), (number[:-1, 1:], number[1:, :-1]))
    pairs = [*((one[ahead], other[ahead]) for one, other in slopes)]
    pairs += [(number[:, :-1][along], number[:, 1:][along]), (number[:-1][down], number[1:][down])]
    one, other = (np.concatenate(parts) for parts in zip(*pairs, strict=True))
    return coo_matrix((np.ones(2 * len(one)), (np.r_[one, other], np.r_[other, one])), (free.size, free.size)).tocsr()
