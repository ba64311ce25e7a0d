"""Trajectories between their points: line, cubic and quintic, as joint_trajectory_controller has them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.nodes.control.tolerances import Tolerances
from coursekit.nodes.control.trajectory import Point, Trajectory, between

NUMBER = st.floats(-3, 3)


def point(time, *values):
    return Point(time, *(None if value is None else np.array([value]) for value in values))


def derivative(one, other, time, which):
    step = 1e-5
    left, right = (getattr(between(one, other, time + sign * step), which) for sign in (-1, 1))
    return float(right[0] - left[0]) / (2 * step)


@given(st.lists(NUMBER, min_size=6, max_size=6), st.floats(0.5, 4.0), st.floats(0.1, 0.9))
def test_a_spline_meets_all_that_both_points_tell_and_its_derivatives_are_its_own(values, span, share):
    for count in (1, 2, 3):
        one, other = point(0.0, *values[:count]), point(span, *values[3 : 3 + count])
        for at, wanted in ((0.0, values[:count]), (span, values[3 : 3 + count])):
            sampled = between(one, other, at)
            told = (sampled.positions, sampled.velocities, sampled.accelerations)[:count]
            assert [float(each[0]) for each in told] == pytest.approx(wanted, abs=1e-6)
        sampled = between(one, other, share * span)
        assert float(sampled.velocities[0]) == pytest.approx(derivative(one, other, share * span, "positions"), abs=1e-4)
        assert float(sampled.accelerations[0]) == pytest.approx(derivative(one, other, share * span, "velocities"), abs=1e-3)


def test_without_speeds_it_is_a_line_also_when_one_point_has_them():
    halfway = between(point(0.0, 0.0, 5.0), point(2.0, 1.0), 1.0)
    assert (halfway.positions[0], halfway.velocities[0]) == pytest.approx((0.5, 0.5))


def test_before_the_first_point_it_comes_from_where_the_joints_were_and_after_the_last_it_stays():
    way = Trajectory([point(1.0, 2.0), point(2.0, 3.0)], 10_000_000_000, point(0.0, 0.0), 10_000_000_000)
    assert [float(way.sample(round(at * 1e9))[0].positions[0]) for at in (10.0, 10.5, 11.0, 11.5, 12.0, 20.0)] == (
        pytest.approx([0.0, 1.0, 2.0, 2.5, 3.0, 3.0])
    )
    assert [way.sample(round(at * 1e9))[1] for at in (11.9, 12.0)] == [False, True]
    assert way.sample(20_000_000_000)[0].velocities[0] == 0.0


def test_without_interpolation_it_jumps_to_the_next_point():
    way = Trajectory([point(1.0, 2.0), point(2.0, 3.0)], 0, point(0.0, 0.0), 0, splines=False)
    assert [float(way.sample(round(at * 1e9))[0].positions[0]) for at in (0.5, 1.5, 2.5)] == [0.0, 3.0, 3.0]


def test_a_tolerance_of_zero_is_without_end_and_what_is_no_number_is_never_within_one():
    most = Tolerances(np.array([0.1, 0.0]), np.array([0.1, 0.0]), np.array([0.0, 0.0]))
    assert most.on_path(np.array([0.1, 99.0]), None) and not most.on_path(np.array([0.2, 0.0]), None)
    assert not most.at_goal(np.array([np.nan, 0.0]), None) and not most.at_goal(np.array([np.inf, 0.0]), None)
