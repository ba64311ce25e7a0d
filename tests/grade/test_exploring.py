"""The world that an explorer is tried in, and the scans that a matcher is tried with."""

from pathlib import Path

import numpy as np

from coursekit.grade.chapters.measures.exploring import FREE, UNKNOWN, WALL, Unseen
from coursekit.grade.matching import Puzzle

WORLDS = Path(__file__).parents[2] / "maps" / "worlds"


def test_what_is_seen_grows_and_stays():
    world = Unseen(WORLDS / "office.yaml", sight=3.0)
    before, known = world.cells.copy(), world.known()
    assert {UNKNOWN, FREE, WALL} == set(np.unique(before).tolist()) and 0 < known < 0.3
    rows, columns = np.nonzero(world.cells == FREE)
    seen = zip(rows.tolist(), columns.tolist(), strict=True)
    world.go(max(seen, key=lambda at: world.can_go(at) and abs(at[0] - world.here[0])))
    assert world.known() > known and world.driven > 1.0
    assert (world.cells[before != UNKNOWN] == before[before != UNKNOWN]).all()


def test_walls_and_the_unknown_are_no_goals():
    world = Unseen(WORLDS / "robot_world.yaml")
    assert world.can_go(world.here)
    for kind in (WALL, UNKNOWN):
        row, column = np.argwhere(world.cells == kind)[0].tolist()
        assert not world.can_go((row, column))


def test_a_scan_fits_at_the_truth_and_not_at_the_guess():
    for number in range(4):
        puzzle = Puzzle(WORLDS / "tec_warehouse.yaml", number)
        assert puzzle.misfit(puzzle.truth) < 0.03 < 2 * 0.03 < puzzle.misfit(puzzle.guess)
    assert Puzzle(WORLDS / "office.yaml", 1).truth == Puzzle(WORLDS / "office.yaml", 1).truth
