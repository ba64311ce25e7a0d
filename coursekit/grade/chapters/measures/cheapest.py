"""The cheapest path over a floor of costs, and the validation of a given path."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.grade.plain import items, shown, whole
from coursekit.grade.verdict import NO_HINT, Wrong

if TYPE_CHECKING:
    import numpy as np

Cell = tuple[int, int]
MOST_TICKS = 5000
"""The maximum number of steps of a path."""


def prices(costs: np.ndarray, start: Cell) -> np.ndarray:
    """Return the price of the cheapest path to each cell, by relaxation until nothing changes; infinite if unreachable.

    >>> import numpy as np
    >>> prices(np.array([[0, 50, 254]]), (0, 0)).tolist()  # a step costs 1 and a fiftieth of the cell's cost
    [[0.0, 2.0, inf]]
    """
    import numpy as np

    price = np.full((costs.shape[0] + 2, costs.shape[1] + 2), np.inf)
    inner, entry = price[1:-1, 1:-1], np.where(costs < 253, 1 + costs / 50, np.inf)
    inner[start] = 0.0
    while True:
        around = np.minimum.reduce([price[:-2, 1:-1], price[2:, 1:-1], price[1:-1, :-2], price[1:-1, 2:]])
        better = np.minimum(inner, around + entry)
        if np.array_equal(better, inner):
            return inner
        inner[:] = better


def path_back(price: np.ndarray, goal: Cell) -> list[Cell]:
    """Return the cheapest path to a reachable goal, from the cell where `price` is 0.

    >>> import numpy as np
    >>> floor = np.array([[0, 0, 0], [0, 254, 0]])
    >>> path_back(prices(floor, (1, 0)), (1, 2))
    [(1, 0), (0, 0), (0, 1), (0, 2), (1, 2)]
    """
    path = [goal]
    while price[path[-1]] > 0:
        r, c = path[-1]
        near = ((r + 1, c), (r - 1, c), (r, c + 1), (r, c - 1))
        inside = (to for to in near if 0 <= to[0] < price.shape[0] and 0 <= to[1] < price.shape[1])
        path.append(min(inside, key=price.__getitem__))
    return path[::-1]


def cells_of(got: Any, told: str) -> list[Cell]:
    """Return the cells of an answer; Wrong when it is no list of cells."""
    wanted = f"a list of cells (row, column) for {told}"
    cells = items(got, wanted)
    if len(cells) > 2 * MOST_TICKS:
        raise Wrong(wanted, gave=f"{len(cells)} cells", hint=NO_HINT)
    if any(type(cell) is list and len(cell) and type(cell[0]) in (tuple, list) for cell in cells):
        raise Wrong(wanted, gave=shown(got, 60), cause="The path alone is asked for, and nothing beside it.", hint=NO_HINT)
    pairs = [[whole(part, wanted) for part in items(cell, wanted)] for cell in cells]
    if any(len(pair) != 2 for pair in pairs):
        raise Wrong(wanted, gave=shown(got, 60), hint=NO_HINT)
    return [(row, column) for row, column in pairs]
