"""Costs, paths over them and robots in a warehouse: the path that was found, the cheapest one, and where it goes wrong."""

import math

import numpy as np
import pytest

from coursekit.grade.chapters.ch09 import _expect_step
from coursekit.grade.chapters.measures.cheapest import path_back, prices
from coursekit.grade.figures.floors import crew, path_over_costs
from coursekit.grade.verdict import Wrong
from coursekit.view.figure import Mover

from .seen import handed_out, labels


def straight(costs, start, goal):
    """Down, then to the right, whatever stands there."""
    rows = [(row, start[1]) for row in range(start[0], goal[0] + 1)]
    return rows + [(goal[0], column) for column in range(start[1] + 1, goal[1] + 1)]


def test_the_cheapest_way_costs_what_the_prices_say():
    costs = np.random.default_rng(3).integers(0, 253, (9, 9))
    price = prices(costs, (0, 0))
    path = path_back(price, (8, 8))
    assert path[0] == (0, 0) and path[-1] == (8, 8)
    assert sum(1 + costs[cell] / 50 for cell in path[1:]) == pytest.approx(price[8, 8])


def test_a_cheapest_way_stands_alone_and_a_dearer_one_beside_the_cheapest():
    costs = np.zeros((3, 4), int)
    costs[1, 0] = 200
    cheapest = path_back(prices(costs, (0, 0)), (2, 3))
    assert "the cheapest path" not in labels(path_over_costs(costs, cheapest, cheapest, "a floor"))
    figure = path_over_costs(costs, straight(costs, (0, 0), (2, 3)), cheapest, "a floor")
    assert {"the cheapest path", "your path"} <= labels(figure)


def test_dearer_cells_have_darker_colours():
    cells = path_over_costs(np.array([[0, 1, 64, 127, 190, 252, 253]]), [], [(0, 0)], "a row").panels[0].shapes[0]
    assert [cells.kinds[code] for code in cells.codes[0]] == ["free", "cost1", "cost2", "cost3", "cost4", "cost4", "wall"]


def test_a_way_through_a_closed_wall_is_drawn_where_none_leads():
    figure, passed = handed_out("ch09.q2", find_path=straight)
    assert not passed and "your path" in labels(figure) and "the cheapest path" not in labels(figure)
    assert "no path leads" in figure.alt


def test_a_jump_is_marked_where_it_lands():
    figure, passed = handed_out("ch09.q2", find_path=lambda costs, start, goal: [start, goal])
    assert not passed and figure.panels[0].rings == [(8.5, 5.5)]


def test_a_step_into_a_wall_is_marked_in_the_wall():
    with pytest.raises(Wrong) as caught:
        _expect_step(np.array([[0, 253]]), (0, 0), (0, 1), "a row")
    assert caught.value.at == [(1.5, 0.5)]


def test_a_cost_beside_the_curve_is_marked_where_it_is():
    figure, passed = handed_out("ch09.q1", inflation_cost=lambda d, i=0.2, s=3.0, r=0.55: 254 if d <= 0 else 100)
    assert not passed and figure.panels[0].rings == [(0.1, 100)]


def test_all_costs_lie_on_the_curve_of_a_right_function():
    def cost(distance, inscribed=0.2, scaling=3.0, radius=0.55):
        if distance <= inscribed:
            return 253 if distance > 0 else 254
        return int(252 * math.exp(-scaling * (distance - inscribed))) if distance <= radius else 0

    figure, passed = handed_out("ch09.q1", inflation_cost=cost)
    dots = figure.panels[0].shapes[1].points
    assert passed and len(dots) > 15 and all(abs(cost(gap, 0.1, 1.5, 2.0) - got) < 1e-9 for gap, got in dots)


def test_where_two_robots_meet_is_marked_and_all_four_move():
    def meet(free, homes, loads):
        return {name: [home, (home[0], 2), (2, 2)] if home[0] in (1, 3) else [home] for name, home in homes.items()}

    figure, passed = handed_out("ch09.q4", manage=meet)
    assert not passed and figure.panels[0].rings == [(2.5, 2.5)]
    assert sum(isinstance(shape, Mover) for shape in figure.panels[0].shapes) == 4


def test_loads_that_stay_where_they_are_are_marked():
    figure, _ = handed_out("ch09.q4", manage=lambda free, homes, loads: {name: [home] for name, home in homes.items()})
    assert len(figure.panels[0].rings) == 8


def test_a_robot_s_line_lies_beside_another_s_in_one_aisle():
    path = [(0, 0), (0, 1), (0, 2)]
    homes = {"robot1": (0, 0), "robot2": (0, 0)}
    lines = [shape for shape in crew(np.ones((2, 4), bool), homes, [], dict.fromkeys(homes, path), "a").panels[0].shapes
             if getattr(shape, "label", "").startswith("robot")]  # fmt: skip
    assert lines[0].points[0] != lines[1].points[0]
