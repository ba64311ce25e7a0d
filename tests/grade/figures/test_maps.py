"""The own map beside the truth, and the explorer's path: what is wrong is marked."""

from itertools import pairwise

import numpy as np
import pytest

from coursekit.grade.chapters.ch08 import _world
from coursekit.grade.chapters.measures.exploring import FREE, Unseen
from coursekit.grade.figures.maps import explored, map_beside_truth
from coursekit.nav.map_compare import outline_points
from coursekit.nav.map_file import GridMap

from .seen import count, handed_out, labels

WALL = outline_points(np.array([[0.25, 1.025, 1.94, 1.025]]))


def model(before, behind):
    return lambda r, z: -0.4 if r < z - before else 0.85 if r < z + behind else 0.0


def test_of_a_good_model_nearly_all_walls_are_right():
    figure, passed = handed_out("ch08.q1", inverse_sensor_model=model(0.04, 0.04))
    assert passed and [panel.title for panel in figure.panels] == ["your map", "beside the truth"]
    assert count(figure, "truth") > 10 * (count(figure, "bad") + count(figure, "guess"))


@pytest.mark.parametrize(("before", "behind", "kind"), [(0.04, 0.3, "bad"), (0.005, 0.005, "guess")])
def test_thick_walls_and_lost_walls_are_marked(before, behind, kind):
    figure, passed = handed_out("ch08.q1", inverse_sensor_model=model(before, behind))
    assert not passed and count(figure, kind) > 300


def test_differences_are_where_they_are():
    cells = np.zeros((40, 40), dtype=np.int8)
    cells[20, 5:35] = cells[8, 8] = 100
    figure = map_beside_truth(GridMap(cells, 0.05), WALL)
    beside = figure.panels[1].shapes[0]
    at = {kind: np.argwhere(beside.codes == beside.kinds.index(kind)).tolist() for kind in ("bad", "guess")}
    assert at == {"bad": [[8, 8]], "guess": [[20, 36], [20, 37], [20, 38]]}
    assert "30 wall cells are right, 1 are walls falsely, 3 cells of true walls are missing" in figure.alt


@pytest.mark.parametrize("cells", [np.zeros((9, 9), np.int8), np.full((9, 9), -1, np.int8)])
def test_a_map_without_walls_is_drawn_all_the_same(cells):
    assert "0 wall cells are right" in map_beside_truth(GridMap(cells, 0.05), WALL).alt


def test_the_way_leads_over_floor_from_goal_to_goal():
    world = Unseen(_world("robot_world"))
    goals = [tuple(goal) for goal in np.argwhere(world.cells == FREE)[[10, 300, 700]].tolist()]
    path = world.path([world.here, *goals])
    assert [cell for cell in path if cell in goals] == goals and all(world.cells[cell] == FREE for cell in path)
    assert all(max(abs(a[0] - b[0]), abs(a[1] - b[1])) == 1 for a, b in pairwise(path))


def test_floor_that_was_not_seen_is_marked():
    figure, passed = handed_out("ch08.q4", next_goal=lambda cells, here: None)
    assert not passed and count(figure, "missed") > 100 and "0 goals, 50 % of the floor seen" in figure.alt
    assert "her path" in labels(figure)


def test_a_goal_that_cannot_be_reached_is_marked_where_it_is():
    figure, _ = handed_out("ch08.q4", next_goal=lambda cells, here: tuple(np.argwhere(cells == -1)[5].tolist()))
    ((x, y),), world = figure.panels[-1].rings, figure.panels[-1].shapes[0]
    assert world.kinds[world.codes[int(y), int(x)]] in ("unknown", "missed")


def test_every_world_has_a_panel_and_its_numbers():
    worlds = [(name, world, [world.here]) for name in ("office", "robot_world") for world in [Unseen(_world(name))]]
    figure = explored(worlds)
    assert len(figure.panels) == 2 and "office: 0 goals" in figure.alt and "robot_world: 0 goals" in figure.alt
