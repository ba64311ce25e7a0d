"""Floors of cells: costs around walls, a path, robots in a warehouse."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from coursekit.view.figure import Cells, Dots, Figure, Line, Mover, Panel, Point, Shape, Words

if TYPE_CHECKING:
    import numpy as np

Cell = tuple[int, int]
COSTS = ("free", "cost1", "cost2", "cost3", "cost4", "wall")
DEARER = (1, 64, 127, 190, 253)
"""The cost thresholds of the colours."""


def spots(*cells: Cell) -> list[Point]:
    """Return the centres of cells (row, column), as x and y in a floor's picture.

    >>> spots((2, 5))
    [(5.5, 2.5)]
    """
    return [(column + 0.5, row + 0.5) for row, column in cells]


def inflated(asked: Sequence[Point], inscribed: float, scaling: float, radius: float) -> Figure:
    """Draw costs over the distance from a wall, with the answers (distance [m], cost)."""
    falling = [inscribed + (radius - inscribed) * k / 40 for k in range(41)]
    curve = [(0.0, 254.0), (0.0, 253.0), (inscribed, 253.0)]
    curve += [(gap, 252 * math.exp(-scaling * (gap - inscribed))) for gap in falling]
    end = radius * 1.25
    dots = Dots([cell for cell in asked if cell[0] <= end], "own", "your function", 3.2)
    line = Line([*curve, (radius, 0.0), (end, 0.0)], "truth", "nav2's formula")
    alt = f"Cost over the distance from a wall: nav2's curve falls from 252 at {inscribed:g} m to 0 beyond {radius:g} m"
    axes = ("distance from the wall [m]", "cost")
    return Figure([Panel([line, dots], view=(0.0, end, 0.0, 268.0), axes=axes)], f"{alt}; {len(asked)} of your answers.")


def path_over_costs(costs: np.ndarray, path: Sequence[Cell], cheapest: Sequence[Cell], told: str) -> Figure:
    """Draw a floor of costs with the path found, and the cheapest path if that is another one."""
    paid, least = (sum(1 + costs[cell] / 50 for cell in cells[1:] if _inside(cell, costs)) for cells in (path, cheapest))
    right = list(path[:1]) == list(cheapest[:1]) and abs(paid - least) < 1e-6
    better = [] if right else [Line(spots(*cheapest), "truth", "the cheapest path", wide=True)]
    shapes = [_costs(costs), *better, Line(spots(*path), "guess", "your path", wide=True), *_ends(cheapest)]
    alt = f"The costs of {told} from above, and your path of {max(0, len(path) - 1)} steps"
    alt += ", the cheapest." if right else f"; the cheapest path has {len(cheapest) - 1}."
    return Figure([Panel(shapes, told, _whole(costs), down=True)], alt)


def closed_floor(costs: np.ndarray, path: Sequence[Cell], start: Cell, goal: Cell, told: str) -> Figure:
    """Draw a floor without a path to the goal, with the path that was given."""
    figure = path_over_costs(costs, path, [start, goal], told)
    shapes = [shape for shape in figure.panels[0].shapes if not isinstance(shape, Line) or shape.label == "your path"]
    return Figure([Panel(shapes, told, _whole(costs), down=True)], f"{told} from above: no path leads to the goal.")


def path_on_map(costs: np.ndarray, path: Sequence[Cell]) -> Figure:
    """Draw a map's costs, with rows growing upwards, and a path."""
    shapes = [_costs(costs), Line(spots(*path), "guess", "the path", wide=True), *_ends(path)]
    rows, columns = costs.shape
    alt = f"The costs of {rows} x {columns} cells from above, and a path of {max(0, len(path) - 1)} steps over them."
    return Figure([Panel(shapes, view=_whole(costs))], alt)


def _costs(costs: np.ndarray) -> Cells:
    import numpy as np

    labels = ("free", "", "dear", "", "dearer", "closed: 253 and more")
    return Cells(np.digitize(costs, DEARER), COSTS, labels)


def _ends(path: Sequence[Cell]) -> list[Shape]:
    return [Dots(spots(*path[:1]), "ink", "start", 4.5), Dots(spots(*path[-1:]), "guess", "goal", 5.5)]


def _inside(cell: Cell, floor: np.ndarray) -> bool:
    return 0 <= cell[0] < floor.shape[0] and 0 <= cell[1] < floor.shape[1]


def _whole(floor: np.ndarray) -> tuple[float, float, float, float]:
    return 0.0, float(floor.shape[1]), 0.0, float(floor.shape[0])


def crew(
    free: np.ndarray, homes: Mapping[str, Cell], loads: Sequence[Cell], paths: Mapping[str, Sequence[Cell]], told: str
) -> Figure:
    """Draw a warehouse with the robots' paths, side by side in shared aisles."""
    shapes: list[Shape] = [Cells((~free).astype(int), ("free", "shelf"))]
    shapes.append(Dots(spots(*loads), "ink", "a load", 3.0))
    for number, (name, path) in enumerate(paths.items(), 1):
        aside = (number - 2.5) * 0.16
        kind = f"robot{number}"
        shapes.append(Line([(x + aside, y + aside) for x, y in spots(*path)], kind, name))
        shapes += [Dots(spots(homes[name]), kind, "", 5.0), Words(0.1, homes[name][0] + 0.5, str(number), "wall")]
        shapes.append(Mover(spots(*path), kind))
    ticks = ", ".join(f"{name} {max(0, len(path) - 1)}" for name, path in paths.items())
    alt = f"{told} from above with the robots' paths. Ticks: {ticks}."
    return Figure([Panel(shapes, told, _whole(free), down=True)], alt)


__all__ = ["closed_floor", "crew", "inflated", "path_on_map", "path_over_costs", "spots"]
