"""Frontiers of maps."""

import numpy as np
import pytest

from coursekit.nav.frontiers import frontiers
from coursekit.nav.map_file import GridMap

WORDS = {" ": 0, "#": 100, ".": -1}


def grid(*rows):
    """A map of 1 m cells, the last row at y = 0."""
    return GridMap(np.array([[WORDS[word] for word in row] for row in rows[::-1]], np.int8), 1.0, (0.0, 0.0, 0.0))


ROOM = grid(
    "#######",
    "#    ..",
    "#    ..",
    "#    ..",
    "#######",
)


def test_unknown_cells_beside_free_ones_are_a_frontier():
    (frontier,) = frontiers(ROOM, (1.5, 2.5), 1.0)
    assert frontier.points.tolist() == [[5.5, 1.5], [5.5, 2.5], [5.5, 3.5]]
    assert frontier.centroid == (5.5, 2.5) and frontier.distance == 4.0 and frontier.nearest == (5.5, 2.5)


def test_what_is_all_seen_or_too_short_or_out_of_reach_has_none():
    assert frontiers(grid("###", "# #", "###"), (1.5, 1.5), 0.5) == []
    assert frontiers(ROOM, (1.5, 2.5), 4.0) == []
    assert frontiers(grid("  # .", "  # ."), (0.5, 0.5), 0.5) == []
    assert frontiers(grid("..", ".."), (0.5, 0.5), 0.5) == []


def test_near_and_long_ones_come_first():
    wide = grid("..#....", "       ", "       ", "#######")
    assert [len(frontier.points) for frontier in frontiers(wide, (6.5, 1.5), 0.5)] == [4, 2]
    near = frontiers(wide, (0.5, 1.5), 0.5, potential_scale=3.0, gain_scale=0.1)
    assert [len(frontier.points) for frontier in near] == [2, 4]


def test_a_robot_that_stands_on_a_wall_looks_from_the_nearest_free_cell():
    assert len(frontiers(ROOM, (0.5, 2.5), 1.0)) == 1


def test_a_robot_off_the_map_is_told():
    with pytest.raises(ValueError, match="Robot out of costmap bounds"):
        frontiers(ROOM, (-1.0, 0.0), 1.0)
