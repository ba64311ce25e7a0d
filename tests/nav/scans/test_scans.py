"""Scans from clouds and depth images, and filters of ranges."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.nav.scans import filters
from coursekit.nav.scans.making import Fan, angles_of_image, of_depth, of_points, points_of

RANGES = st.lists(st.floats(0.1, 20.0), min_size=3, max_size=60).map(np.array)
NAN = math.nan


@given(RANGES)
def test_a_scan_made_of_the_points_of_a_scan_is_that_scan(ranges):
    step = 2 * math.pi / 400
    fan = Fan(-math.pi / 2 - step / 2, math.pi / 2, step)
    again = of_points(points_of(ranges, -math.pi / 2, step), fan)
    assert again[: len(ranges)] == pytest.approx(ranges) and np.isinf(again[len(ranges) :]).all()


def test_the_nearest_counts_and_heights_and_distances_bound_what_does():
    points = np.array([[3.0, 0, 0], [2.0, 0, 0.5], [1.0, 0, 2.0], [0.1, 0, 0], [0, 50.0, 0]])
    fan = Fan(-0.5, 0.5, 1.0, range_min=0.2, range_max=10.0, min_height=-1.0, max_height=1.0)
    assert of_points(points, fan).tolist() == [2.0] and of_points(points[3:], fan, -1.0).tolist() == [-1.0]


def test_a_wall_in_a_depth_image_is_a_straight_line_in_the_scan():
    fx, cx, width = 100.0, 49.5, 100
    ranges = of_depth(np.full((20, width), 2.0), fx, cx, 4, 10.0, (0.1, 10.0))
    smallest, greatest, step = angles_of_image(width, fx, cx)
    there = points_of(ranges, smallest, step)[np.isfinite(ranges)]
    assert len(there) > 80 and there[:, 0] == pytest.approx(2.0, abs=0.02) and greatest == pytest.approx(-smallest)


def test_what_stands_left_in_the_image_has_a_positive_angle():
    depth = np.full((5, 100), NAN)
    depth[:, :10] = 1.0
    beams = np.flatnonzero(np.isfinite(of_depth(depth, 100.0, 49.5, 1, 2.0, (0.1, 10.0))))
    assert beams.min() > 80


@given(RANGES, st.floats(0.0, 5.0), st.floats(6.0, 20.0))
def test_after_the_range_filter_all_that_is_left_lies_between(ranges, low, high):
    left = filters.within(ranges, low, high)
    kept = np.isfinite(left)
    assert ((left[kept] > low) & (left[kept] < high)).all() and (kept == ((ranges > low) & (ranges < high))).all()


@pytest.mark.parametrize("by", ["distance", "neighbours"])
def test_a_single_point_is_a_speckle_and_a_wall_is_none(by):
    ranges = np.full(40, 3.0)
    ranges[20] = 1.0
    if by == "distance":
        left = filters.speckles_by_distance(ranges, 2, 0.1, 100.0)
    else:
        left = filters.speckles_by_neighbours(ranges, 2, 0.2, 100.0, 0.01)
    assert np.flatnonzero(np.isnan(left)).tolist() == [20]


def test_a_veil_between_two_walls_goes_and_the_near_wall_stays():
    ranges = np.array([1.0] * 20 + [1.8, 2.6] + [3.5] * 20)
    left = filters.veils(ranges, math.radians(0.5), (math.radians(10), math.radians(170)), 2, 1)
    assert np.isnan(left[20:22]).all() and np.isfinite(left[:20]).all() and np.isfinite(left[25:]).all()


@given(RANGES)
def test_filters_only_take_away(ranges):
    for left in (
        filters.speckles_by_distance(ranges, 2, 0.3, 10.0),
        filters.speckles_by_neighbours(ranges, 2, 0.3, 10.0, 0.01),
        filters.veils(ranges, 0.01, (0.2, 2.9), 3, 1),
    ):
        assert len(left) == len(ranges) and (np.isnan(left) | (left == ranges)).all()
