"""angles: the same direction, and the way from one to another."""

import math
from math import pi

import pytest
from angles import (
    normalize_angle,
    normalize_angle_positive,
    shortest_angular_distance,
    shortest_angular_distance_with_large_limits,
    shortest_angular_distance_with_limits,
    two_pi_complement,
)
from hypothesis import given
from hypothesis import strategies as st

ANGLES = st.floats(-50, 50)


def same(a, b):
    return math.cos(a - b) == pytest.approx(1.0, abs=1e-9)


@given(ANGLES)
def test_normal_angles_point_the_same_way_within_their_bounds(angle):
    assert -math.pi <= normalize_angle(angle) <= math.pi and same(normalize_angle(angle), angle)
    assert 0 <= normalize_angle_positive(angle) <= 2 * math.pi and same(normalize_angle_positive(angle), angle)
    assert same(two_pi_complement(angle), angle)


@given(ANGLES, ANGLES)
def test_the_shortest_way_leads_there_and_is_at_most_half_a_turn(a, b):
    way = shortest_angular_distance(a, b)
    assert abs(way) <= math.pi + 1e-12 and same(a + way, b)


@pytest.mark.parametrize(
    "start, end, left, right, expected",
    [(-0.5, 0.5, -0.25, 0.25, (False, 1.0)), (-0.2, 0.2, -0.25, 0.25, (True, 0.4)), (2.5, -2.5, -3.0, 3.0, (True, -5.0)),
     (0.0, 3.0, -1.0, 1.0, (False, 3.0)), (0.2, 0.6, -0.5, -0.3, (False, -5.883185)), (0.0, 0.9, -0.25, 0.5, (False, 0.9)),
     (0.1, -0.6, -0.25, 0.5, (False, -0.7)), (1.0, 1.0, -pi, pi, (True, 0.0))],
)  # fmt: skip
def test_within_limits_the_way_passes_neither(start, end, left, right, expected):
    able, way = shortest_angular_distance_with_limits(start, end, left, right)
    assert (able, way) == (expected[0], pytest.approx(expected[1]))


@pytest.mark.parametrize(
    "start, end, left, right, expected",
    [(0.0, 10.5 * pi, -2 * pi, 2 * pi, (True, 0.5 * pi)), (0.0, 10.5 * pi, -2 * pi, 0.1 * pi, (True, -1.5 * pi)),
     (2 * pi, pi, 2 * pi - 0.1, 2 * pi + 0.1, (False, pi)), (10.5 * pi, 0.0, -2 * pi, 2 * pi, (False, -0.5 * pi)),
     (0.0, 0.1, 2 * pi, -2 * pi, (False, 0.1)), (0.9995, 1.0, -20 * pi, 20 * pi, (True, 0.0005))],
)  # fmt: skip
def test_a_joint_may_turn_more_than_once(start, end, left, right, expected):
    able, way = shortest_angular_distance_with_large_limits(start, end, left, right)
    assert (able, way) == (expected[0], pytest.approx(expected[1]))
