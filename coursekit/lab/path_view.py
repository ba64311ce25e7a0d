"""A path on a cost map as a picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from coursekit.grade.figures.floors import path_on_map
from coursekit.view.figure_html import html

if TYPE_CHECKING:
    import numpy as np


class PathView:
    """Costs and a path over them; shows itself as a picture, or as a text description."""

    def __init__(self, costs: np.ndarray, path: Sequence[tuple[int, int]]) -> None:
        self.figure = path_on_map(costs, path)

    def __repr__(self) -> str:
        return self.figure.alt

    def _repr_html_(self) -> str:
        return html(self.figure)


def path_view(costs: np.ndarray, path: Sequence[tuple[int, int]] | None = None) -> PathView:
    """Show costs (rows, columns) from 0 to 254, row 0 at the bottom, with a path of cells (row, column) over them.

    >>> import numpy as np
    >>> path_view(np.zeros((4, 6), int), [(0, 0), (0, 1), (1, 1)])
    The costs of 4 x 6 cells from above, and a path of 2 steps over them.

    Raises:
        ValueError: when the costs are no 2D array of numbers, or the path leaves it.

    In ROS 2: `rviz2` shows /global_costmap/costmap and /plan.
    """
    import numpy as np

    table, cells = np.asarray(costs), [(row, column) for row, column in path or ()]
    if table.ndim != 2 or table.dtype.kind not in "iuf":
        raise ValueError("the costs are not rows and columns of numbers, such as np.array([[0, 100], [0, 254]]) has")
    for row, column in cells:
        if not (0 <= row < table.shape[0] and 0 <= column < table.shape[1]):
            size = f"{table.shape[0]} x {table.shape[1]}"
            raise ValueError(f"the path leaves the {size} cells at ({row}, {column}): is it row first, then column?")
    return PathView(table, cells)


__all__ = ["PathView", "path_view"]
