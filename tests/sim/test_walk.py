"""Walks: a thing is at each pose at its time and moves smoothly between; sensors see it, nothing bumps into it."""

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.geometry.plane import Pose2D, wrap
from coursekit.sim import Disc, Lidar, RobotModel, Simulation, Thing, World
from coursekit.sim.walk import Walk

PLACES = st.tuples(*[st.floats(-50, 50)] * 2, st.floats(-3, 3)).map(lambda one: Pose2D(*one))
STEPS = st.lists(st.tuples(st.floats(0.1, 10), PLACES), min_size=1, max_size=6)
ACROSS = Walk((0.0, 4.0), (Pose2D(2.0, -2.0, 0.0), Pose2D(2.0, 2.0, 0.0)), loop=False)
AHEAD = Lidar(beams=1, angle_max=0.0, range_max=50.0, range_min=0.0)


@given(STEPS, st.booleans(), st.floats(0, 5))
def test_each_pose_is_reached_at_its_time_in_each_round(steps, loop, delay):
    times, now = [], 0.0
    for seconds, _ in steps:
        times.append(now)
        now += seconds
    walk = Walk(tuple(times), tuple(place for _, place in steps), loop, delay)
    for number in range(2 if loop else 1):
        for time, (_, place) in list(zip(times, steps, strict=True))[:-1]:
            at = walk.at(number * (delay + times[-1]) + delay + time + 1e-9)
            assert math.dist(at[:2], place[:2]) < 1e-4 and abs(wrap(at.theta - place.theta)) < 1e-4


def test_the_way_is_smooth_and_turns_the_short_way_round():
    walk = Walk((0.0, 1.0, 2.0), (Pose2D(0, 0, 3.0), Pose2D(1, 0, -3.0), Pose2D(1, 1, -2.0)), loop=False)
    places = [walk.at(0.01 * step) for step in range(201)]
    moved = [math.dist(before[:2], after[:2]) for before, after in pairwise(places)]
    turned = [abs(wrap(after.theta - before.theta)) for before, after in pairwise(places)]
    assert max(moved) < 0.02 and max(turned) < 0.02


def test_a_laser_sees_who_walks_by():
    simulation = Simulation(World("hall", (Thing("walker", (Disc(0, 0, 0.25, 0, 1.75),), mass=math.inf, walk=ACROSS),)))
    seen = []
    for _ in range(4):
        simulation.advance(1.0)
        seen.append(float(simulation.scan(AHEAD)[0]))
    assert seen == [math.inf, pytest.approx(1.75, abs=0.01), math.inf, math.inf]
    assert simulation.pose_of("walker").y == pytest.approx(2.0)


@pytest.mark.parametrize("solid", [True, False])
def test_a_robot_bumps_only_into_what_is_solid(solid):
    post = Thing("walker", (Disc(0, 0, 0.25, 0, 1.75),), Pose2D(1.5, 0, 0), mass=math.inf, solid=solid)
    simulation = Simulation(World("hall", (post,)))
    cart = simulation.spawn(RobotModel("cart"))
    cart.command(0.5)
    simulation.advance(8.0)
    assert (cart.place.x > 2.5) != solid
    assert ("walker" in cart.contacts) == solid


def test_it_can_be_taken_out_and_begins_again_at_a_reset():
    simulation = Simulation(World("hall", (Thing("walker", (Disc(0, 0, 0.25),), ACROSS.at(0), math.inf, walk=ACROSS),)))
    simulation.advance(3.0)
    simulation.reset()
    assert simulation.pose_of("walker") == ACROSS.at(0)
    simulation.advance(2.0)
    assert simulation.pose_of("walker").y == pytest.approx(0.0, abs=1e-6)
    simulation.remove("walker")
    simulation.advance(1.0)
    assert simulation.names() == []
