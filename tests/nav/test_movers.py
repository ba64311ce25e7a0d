"""Things that move in a costmap that rolls with its robot, and a robot that gets out of their way."""

import math

import numpy as np

from coursekit.nav.controller import Controller, Limits
from coursekit.nav.costmap import FREE, INSCRIBED, LETHAL, Costmap
from coursekit.nav.footprint import Footprint
from coursekit.nav.movers import Movers

CELL = 0.05


def room(x=None, wall=True):
    """Six by four metres around (0, 0) of free floor with a wall at y = 1.5, and the front of a box that faces -x at `x`."""
    costs = Costmap.of_size(6.0, 4.0, CELL, -3.0, -2.0, FREE)
    if wall:
        costs.cells[costs.cell(0.0, 1.5)[0], :] = LETHAL
    if x is not None:
        row, column = costs.cell(x, -0.25)
        costs.cells[row : row + 10, column] = LETHAL
    return costs


def watched(places, period=0.1):
    """Movers that have seen a box at these places."""
    movers = Movers(seconds=1.0)
    for k, x in enumerate(places):
        movers.see(room(x), k * period)
    return movers


def test_a_box_that_comes_is_found_with_its_velocity_and_its_way_is_kept_free():
    movers = watched([2.0 - 0.03 * k for k in range(15)])
    ((cells, velocity),) = movers.found
    assert math.dist(velocity, (-0.3, 0.0)) < 0.06 and len(cells) >= 8
    costs = room(2.0 - 0.03 * 14)
    movers.mark(costs, 0.2)
    assert costs.cost(1.4, 0.0) == INSCRIBED and costs.cost(1.1, 0.0) == INSCRIBED
    assert costs.cost(0.8, 0.0) == FREE and costs.cost(1.4, 0.7) == FREE
    assert (costs.cells == LETHAL).sum() == (room(1.58).cells == LETHAL).sum()


def test_what_stands_does_not_move_though_its_edge_trembles_and_the_map_rolls_on():
    movers, rng = Movers(seconds=1.0), np.random.default_rng(3)
    for k in range(40):
        movers.see(room(1.5 + rng.normal(0.0, 0.02)).moved_to(-3.0 + 0.04 * k, -2.0, FREE), k * 0.1)
        assert movers.found == []


def test_what_comes_into_sight_is_no_mover():
    assert watched([None] * 12 + [-1.5] * 3).found == []


def test_time_that_goes_back_begins_anew():
    movers = watched([2.0 - 0.03 * k for k in range(15)])
    movers.see(room(1.5), 0.2)
    assert movers.found == []


def test_a_robot_in_the_way_of_something_leaves_it_backwards_if_need_be():
    movers = watched([1.0 - 0.03 * k for k in range(15)])
    costs, pose, now = room(0.58), (0.2, 0.0, 0.0), (0.0, 0.0)
    movers.mark(costs, 0.2)
    control = Controller(Limits(max_speed=0.4, max_turn=1.5), Footprint.disc(0.2))
    assert control.blocked(costs, pose)
    path = np.column_stack([np.linspace(0.0, 2.5, 50), np.zeros(50), np.zeros(50)])
    for _ in range(40):
        now = control.command(costs, pose, now, path)
        x, y, yaw = pose
        pose = (x + now[0] * math.cos(yaw) * 0.05, y + now[0] * math.sin(yaw) * 0.05, yaw + now[1] * 0.05)
        assert costs.cost(*pose[:2]) < LETHAL
    assert not control.blocked(costs, pose) and pose[0] < 0.1
