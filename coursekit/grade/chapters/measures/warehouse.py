"""A warehouse of cells, and checks of robots' paths: drivable, without collisions, and delivering all loads."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from coursekit.grade.chapters.measures.cheapest import MOST_TICKS, Cell
from coursekit.grade.figures.floors import spots
from coursekit.grade.verdict import NO_HINT, Wrong

if TYPE_CHECKING:
    from random import Random

    import numpy as np


def warehouse(number: int, chance: Random) -> tuple[np.ndarray, dict[str, Cell], list[Cell]]:
    """Return aisles between shelves, with homes in bays at the left, and loads in bays of the shelves."""
    import numpy as np

    aisles, width = 2 + number % 2, 16 + number
    free = np.zeros((4 * aisles + 2, width), bool)
    rows = [4 * k + 2 for k in range(aisles)]
    free[rows, 2:-1] = free[[row + 1 for row in rows], 2:-1] = True
    free[1 : rows[-1] + 2, 2] = free[rows[0] : rows[-1] + 2, width - 2] = True
    homes = {f"robot{k + 1}": (2 * k + 1, 1) for k in range(4)}
    bays = [(row - 1, column) for row in rows for column in range(5, width - 3, 3)]
    loads = chance.sample(bays, 8)
    for cell in [*homes.values(), *loads]:
        free[cell] = True
    return free, homes, loads


def expect_drivable(free: np.ndarray, path: list[Cell], home: Cell, told: str) -> None:
    """Raise Wrong unless a robot can drive this path from its home, cell by cell."""
    if not path or path[0] != home:
        raise Wrong(f"a path of {told} that begins at its home {home}", gave=f"{path[:3]}", hint=NO_HINT)
    if len(path) > MOST_TICKS:
        raise Wrong(f"at most {MOST_TICKS} ticks for {told}", gave=f"{len(path)}", hint=NO_HINT)
    for before, after in pairwise(path):
        if abs(before[0] - after[0]) + abs(before[1] - after[1]) > 1:
            wanted, gave = f"{told} stays or goes to a neighbour in each tick", f"{before} to {after}"
            raise Wrong(wanted, gave=gave, hint=NO_HINT, at=spots(after))
        inside = 0 <= after[0] < free.shape[0] and 0 <= after[1] < free.shape[1]
        if not inside or not free[after]:
            raise Wrong(f"{told} on free cells", gave=f"{after}, which is none", hint=NO_HINT, at=spots(after))


def _at(path: list[Cell], tick: int) -> Cell:
    return path[min(tick, len(path) - 1)]


def expect_apart(paths: dict[str, list[Cell]], told: str) -> None:
    """Raise Wrong when two robots share a cell, or pass through each other."""
    for tick in range(1, max(map(len, paths.values()))):
        seen: dict[Cell, str] = {}
        moves = {(_at(path, tick - 1), _at(path, tick)): name for name, path in paths.items()}
        for name, path in paths.items():
            here, before = _at(path, tick), _at(path, tick - 1)
            other = seen.setdefault(here, name)
            if other != name:
                both = f"{other} and {name} both in {here} at tick {tick}"
                raise Wrong(f"one robot to a cell in {told}", both, hint=0, at=spots(here))
            if here != before and (here, before) in moves:
                what = f"{name} and {moves[here, before]} change places at tick {tick}: {before}, {here}"
                cause = "The moves are to be reserved, too."
                raise Wrong(f"no two robots through each other in {told}", what, cause, at=spots(before, here))


def delivered(paths: dict[str, list[Cell]], homes: dict[str, Cell], loads: list[Cell], told: str) -> int:
    """Return the tick at which the last load is at home."""
    left, carried, done, last = set(loads), dict.fromkeys(paths, False), 0, 0
    for tick in range(max(map(len, paths.values()))):
        for name, path in paths.items():
            here = _at(path, tick)
            if carried[name] and here == homes[name]:
                carried[name], done, last = False, done + 1, tick
            elif not carried[name] and here in left:
                left.remove(here)
                carried[name] = True
    if done < len(loads):
        cause = "After each load the robot has to come home before it can take another."
        share = 0.25 if done else 0.0
        raise Wrong(f"all {len(loads)} loads of {told} at home", f"{done}", cause, share=share, at=spots(*left))
    return last
