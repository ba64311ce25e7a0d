"""Maps of chapter 8: the student's map beside the truth, and an explorer's view."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from coursekit.view.figure import Cells, Dots, Figure, Line, Panel, View

if TYPE_CHECKING:
    from coursekit.grade.chapters.measures.exploring import Unseen
    from coursekit.nav.map_file import GridMap

Cell = tuple[int, int]
KINDS = ("free", "unknown", "wall")
WALL = 65


def map_beside_truth(grid: GridMap, outline: np.ndarray) -> Figure:
    """Draw the map, and beside it the same with its false and missing parts of the true walls (n, 2) [m]."""
    from coursekit.nav.map_compare import differences

    false, missed = differences(grid, outline)
    codes = np.where(grid.cells < 0, 1, np.where(grid.cells > WALL, 2, 0))
    beside, kinds = codes.copy(), ("free", "unknown", "truth", "bad", "guess")
    beside[tuple(false.T)], beside[tuple(missed.T)] = 3, 4
    corner, size, view = grid.origin[:2], grid.resolution, _known(grid, missed)
    own = Panel([Cells(codes, KINDS, KINDS, corner, size)], "your map", view)
    labels = ("", "", "a wall, rightly", "no wall is there", "a wall that is missing")
    truth = Panel([Cells(beside, kinds, labels, corner, size)], "beside the truth", view)
    right = int((beside == 2).sum())
    alt = f"The map that your model made, beside the truth: {right} wall cells are right, {len(false)} are walls falsely,"
    return Figure([own, truth], f"{alt} {len(missed)} cells of true walls are missing.")


def _known(grid: GridMap, missed: np.ndarray) -> View:
    """Return a view of the known part of a map, with a margin."""
    known = np.concatenate([np.argwhere(grid.cells >= 0), missed])
    (low, left), (high, right) = (known.min(axis=0), known.max(axis=0)) if len(known) else ((0, 0), grid.cells.shape)
    (x, y), size = grid.origin[:2], grid.resolution
    return x + (left - 4) * size, x + (right + 5) * size, y + (low - 4) * size, y + (high + 5) * size


def explored(worlds: Sequence[tuple[str, Unseen, list[Cell]]]) -> Figure:
    """Draw each world as seen, with the path from goal to goal; unseen floor is marked."""
    panels = [_explored(*explored) for explored in worlds]
    told = [f"{name}: {len(stops) - 1} goals, {_percent(world)} of the floor seen" for name, world, stops in worlds]
    return Figure(panels, f"Maps from above with the explorer's path. {'; '.join(told)}.")


def _explored(name: str, world: Unseen, stops: list[Cell]) -> Panel:
    codes = np.select([world.cells == 0, world.cells > WALL, world.unseen_floor()], [0, 2, 3], 1)
    cells = Cells(codes, (*KINDS, "missed"), (*KINDS, "floor that was not seen"))
    path = [(column + 0.5, row + 0.5) for row, column in world.path(stops)]
    goals = Dots([(column + 0.5, row + 0.5) for row, column in stops[1:]], "own", "a goal", 2.0)
    start = Dots([(stops[0][1] + 0.5, stops[0][0] + 0.5)], "truth", "her start", 5.0)
    return Panel([cells, Line(path, "own", "her path"), goals, start], f"{name}: {_percent(world)} seen", _seen(codes))


def _percent(world: Unseen) -> str:
    return f"{int(100 * world.known())} %"


def _seen(codes: np.ndarray) -> View:
    at = np.argwhere(codes != 1)
    (low, left), (high, right) = at.min(axis=0), at.max(axis=0)
    return left - 2.0, right + 3.0, low - 2.0, high + 3.0


__all__ = ["explored", "map_beside_truth"]
