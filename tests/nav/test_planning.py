"""Costmaps, paths and control, as numbers."""

import math

import numpy as np
import pytest

from coursekit.nav.controller import ControlError, Controller, Limits
from coursekit.nav.costmap import INSCRIBED, LETHAL, UNKNOWN, Costmap
from coursekit.nav.footprint import Footprint
from coursekit.nav.inflation import Inflation
from coursekit.nav.obstacles import ObstacleLayer
from coursekit.nav.planner import PlanError, Planner, length


def room(*blocks, size=6.0, inflated=True):
    """A room with blocks (x0, y0, x1, y1) [m] in it, and a wall around."""
    costmap = Costmap.of_size(size, size, 0.05)
    edge = size - 0.1
    walls = (0, 0, size, 0.1), (0, 0, 0.1, size), (edge, 0, size, size), (0, edge, size, size)
    for x0, y0, x1, y1 in (*blocks, *walls):
        costmap.cells[round(y0 / 0.05) : round(y1 / 0.05), round(x0 / 0.05) : round(x1 / 0.05)] = LETHAL
    if inflated:
        Inflation(0.55, 3.0, 0.2, 0.05).spread(costmap.cells)
    return costmap


WALL = (2.9, 0.0, 3.1, 4.5)


def test_a_path_goes_around_a_wall_and_keeps_away_from_it():
    costs = room(WALL)
    path = Planner().plan(costs, (1.0, 1.0, 0.0), (5.0, 1.0, 1.5))
    assert path[0, :2].tolist() == [1.0, 1.0] and path[-1].tolist() == [5.0, 1.0, 1.5]
    assert max(costs.cost(x, y) for x, y, _ in path.tolist()) < 200
    assert 8.0 < length(path) < 10.5
    assert np.hypot(*np.diff(path[:, :2], axis=0).T).max() < 0.1


def test_a_goal_beside_a_wall_is_replaced_by_a_near_one_and_one_in_it_is_refused():
    costs = room((2.5, 0.0, 3.5, 4.5))
    path = Planner(tolerance=0.5).plan(costs, (1.0, 1.0, 0.0), (2.45, 1.0, 0.0))
    assert 0.0 < math.hypot(path[-1, 0] - 2.45, path[-1, 1] - 1.0) < 0.5
    with pytest.raises(PlanError, match="the goal is inside or beside an obstacle"):
        Planner(tolerance=0.1).plan(costs, (1.0, 1.0, 0.0), (3.0, 1.0, 0.0))


def test_beside_a_goal_that_is_taken_paths_keep_to_one_side_while_scans_see_it_a_little_elsewhere():
    goal, ends, before = (3.0, 3.0, 0.0), [], None
    for shift in (0.0, 0.05, -0.05, 0.05, -0.05):
        costs = room((2.8 + shift, 2.8 + shift, 3.2 + shift, 3.2 + shift))
        path = Planner().plan(costs, (1.0, 3.0, 0.0), goal, before)
        before = path[-1, 0], path[-1, 1]
        ends.append(before)
    assert max(math.dist(end, ends[0]) for end in ends) < 0.2
    assert max(math.dist(end, goal[:2]) for end in ends) <= 0.5
    free = Planner().plan(room(), (1.0, 3.0, 0.0), goal, before)
    assert free[-1].tolist() == [3.0, 3.0, 0.0]


@pytest.mark.parametrize(
    ("start", "goal", "says"),
    [
        ((1.0, 1.0, 0.0), (50.0, 1.0, 0.0), "The goal .50.00, 1.00. is off the global costmap"),
        ((-1.0, 1.0, 0.0), (5.0, 1.0, 0.0), "The start .* is off the global costmap"),
        ((1.0, 1.0, 0.0), (math.nan, 1.0, 0.0), "The goal is not made of finite numbers"),
        ((1.0, 1.0, 0.0), (5.0, 1.0, 0.0), "no path leads there"),
    ],
)
def test_what_cannot_be_planned_says_why(start, goal, says):
    with pytest.raises(PlanError, match=says):
        Planner().plan(room((2.9, 0.0, 3.1, 6.0)), start, goal)


def test_a_robot_that_stands_too_near_to_a_wall_finds_out():
    costs = room(WALL)
    assert costs.cost(2.8, 1.0) == INSCRIBED
    path = Planner().plan(costs, (2.8, 1.0, 0.0), (1.0, 1.0, 0.0))
    assert path[-1, 0] == 1.0


def test_unknown_space_is_crossed_only_when_allowed():
    costs = room()
    costs.cells[:, 60:64] = UNKNOWN
    assert len(Planner(unknown=True).plan(costs, (1.0, 1.0, 0.0), (5.0, 1.0, 0.0)))
    with pytest.raises(PlanError):
        Planner(unknown=False).plan(costs, (1.0, 1.0, 0.0), (5.0, 1.0, 0.0))


def test_beams_clear_what_has_gone_but_not_the_walls_behind_which_they_end():
    layer = ObstacleLayer(room(inflated=False))
    there, beyond = np.array([[3.0, 3.01]]), np.array([[5.0, 3.01]])
    layer.see((1.0, 3.01), there, np.array([True]))
    assert layer.map.cost(3.0, 3.01) == LETHAL
    layer.see((1.0, 3.01), beyond, np.array([True]))
    assert layer.map.cost(3.0, 3.01) == 0 and layer.map.cost(5.0, 3.01) == LETHAL
    layer.forget_square(5.0, 3.0, 1.0)
    assert layer.map.cost(5.0, 3.01) == UNKNOWN and layer.map.cost(3.0, 3.01) == 0


def test_a_rolling_map_keeps_what_it_still_covers():
    costs = Costmap.of_size(3.0, 3.0, 0.05)
    costs.cells[costs.cell(2.0, 2.0)] = LETHAL
    moved = costs.moved_to(1.0, 0.52, 0)
    assert moved.cost(2.0, 2.0) == LETHAL and (moved.cells == LETHAL).sum() == 1
    assert (costs.moved_to(9.0, 9.0, UNKNOWN).cells == UNKNOWN).all()


def drive(costs, path, pose=(1.0, 1.0, 0.0), seconds=60.0, footprint=None):
    """Where a robot of perfect wheels gets with a new plan every second, and the greatest cost on its way."""
    control = Controller(Limits(max_speed=0.4, max_turn=1.5), footprint or Footprint.disc(0.2))
    now, worst = (0.0, 0.0), 0
    for tick in range(int(seconds / control.period)):
        if tick % 20 == 19:
            path = Planner().plan(costs, pose, tuple(path[-1].tolist()))
            control.begin()
        now = control.command(costs, pose, now, path)
        x, y, yaw = pose
        pose = (x + now[0] * math.cos(yaw) * 0.05, y + now[0] * math.sin(yaw) * 0.05, yaw + now[1] * 0.05)
        worst = max(worst, costs.cost(*pose[:2]))
        assert not control.blocked(costs, pose)
        if math.hypot(pose[0] - path[-1, 0], pose[1] - path[-1, 1]) < 0.2:
            break
    return pose, worst


def test_the_controller_follows_a_path_around_a_wall():
    costs = room(WALL)
    path = Planner().plan(costs, (1.0, 1.0, 0.0), (5.0, 1.0, 0.0))
    pose, worst = drive(costs, path)
    assert math.hypot(pose[0] - 5.0, pose[1] - 1.0) < 0.2 and worst < INSCRIBED


def test_the_controller_goes_around_what_was_not_there_when_the_path_was_made():
    path = Planner().plan(room(), (1.0, 1.0, 0.0), (5.0, 1.0, 0.0))
    pose, worst = drive(room((2.9, 0.9, 3.1, 1.3)), path)
    assert math.hypot(pose[0] - 5.0, pose[1] - 1.0) < 0.2 and worst < INSCRIBED


def test_a_long_robot_does_not_turn_where_its_ends_would_touch():
    costs = room((0.0, 1.0, 6.0, 1.2), (0.0, 1.7, 6.0, 6.0))
    long = Controller(footprint=Footprint.parse("[[0.4, 0.1], [0.4, -0.1], [-0.4, -0.1], [-0.4, 0.1]]"))
    assert not long.blocked(costs, (3.0, 1.45, 0.0)) and long.blocked(costs, (3.0, 1.45, 1.57))
    with pytest.raises(ControlError, match="Turning on the spot"):
        long.turn(costs, (3.0, 1.45, 0.3), (0.0, 0.0), 1.0)


def test_a_robot_in_a_corner_gets_no_command_that_touches():
    costs = room((1.25, 0.0, 6.0, 6.0))
    path = np.column_stack([np.linspace(1.0, 5.0, 80), np.full(80, 1.0), np.zeros(80)])
    with pytest.raises(ControlError, match="No valid trajectories"):
        Controller(Limits(min_speed=0.2)).command(costs, (1.0, 1.0, 0.0), (0.2, 0.0), path)


def test_speeds_never_change_faster_than_they_may():
    limits = Limits(acceleration=1.0, deceleration=2.0, turn_acceleration=3.0)
    assert limits.toward((0.0, 0.0), (1.0, 1.0), 0.1) == (0.1, 0.3)
    assert limits.toward((0.5, 0.0), (0.0, -1.0), 0.1) == (0.3, -0.3)


@pytest.mark.parametrize("text", ["[[0, 0]]", "robot", "[[1, 2], [3, 4], [5]]", "[[0, 1], [1, 0], [1e999, 0]]"])
def test_a_footprint_that_is_none_is_refused(text):
    with pytest.raises(ValueError, match="write at least three corners"):
        Footprint.parse(text)
