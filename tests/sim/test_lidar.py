"""The LiDAR against an independent computation of every beam with every edge."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from coursekit.geometry.plane import Pose2D
from coursekit.sim import Cut, Lidar, WorldError

FAR = np.inf


def by_hand(cut, place, angles, reach):
    """Each beam with each edge and circle, by solving two equations; no bearings, no intervals."""
    ranges = np.full(len(angles), FAR)
    for k, angle in enumerate(angles):
        d = np.array([math.cos(place.theta + angle), math.sin(place.theta + angle)])
        o = np.array(place[:2])
        for x1, y1, x2, y2 in cut.edges:
            matrix = np.array([[d[0], x1 - x2], [d[1], y1 - y2]])
            if abs(np.linalg.det(matrix)) < 1e-14:
                continue
            t, u = np.linalg.solve(matrix, np.array([x1, y1]) - o)
            if t >= 0 and 0 <= u <= 1:
                ranges[k] = min(ranges[k], t)
        for x, y, r in cut.circles:
            roots = np.roots([1.0, -2 * d @ (np.array([x, y]) - o), (x - o[0]) ** 2 + (y - o[1]) ** 2 - r * r])
            real = [root.real for root in roots if abs(root.imag) < 1e-12 and root.real >= 0]
            ranges[k] = min([ranges[k], *real])
    ranges[ranges > reach] = FAR
    return ranges


def scene(seed, edges=40, circles=5):
    chance = np.random.default_rng(seed)
    centre, turn = chance.uniform(-8, 8, (edges, 2)), chance.uniform(0, 7, edges)
    half = chance.uniform(0.02, 2, edges)[:, None] * np.column_stack((np.cos(turn), np.sin(turn)))
    round_ones = np.column_stack((chance.uniform(-8, 8, (circles, 2)), chance.uniform(0.05, 0.8, circles)))
    return Cut(np.hstack((centre - half, centre + half)), round_ones), Pose2D(*chance.uniform(-3, 3, 3))


def agree(seen, true):
    ends = np.isfinite(seen) != np.isfinite(true)
    assert ends.sum() == 0, f"{ends.sum()} beams differ about whether there is anything"
    both = np.isfinite(true)
    np.testing.assert_allclose(seen[both], true[both], rtol=0, atol=1e-9)


@pytest.mark.parametrize("fov", [(0.0, 2 * math.pi * 89 / 90), (-math.pi, math.pi), (-1.2, 1.2), (2.0, 5.0), (-6.0, -1.0)])
@pytest.mark.parametrize("seed", range(4))
def test_every_beam_is_exact(seed, fov):
    cut, place = scene(seed)
    lidar = Lidar(beams=90, angle_min=fov[0], angle_max=fov[1], range_max=12.0)
    seen = lidar.look(cut, place)
    seen[seen > 12.0] = FAR
    agree(seen, by_hand(cut, place, np.linspace(*fov, 90), 12.0))


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.integers(0, 10**6))
def test_any_scene_is_exact(seed):
    cut, place = scene(seed, 12, 2)
    seen = Lidar(beams=24, angle_max=2 * math.pi * 23 / 24, range_max=30.0).look(cut, place)
    agree(seen, by_hand(cut, place, 2 * math.pi * np.arange(24) / 24, 30.0))


@settings(max_examples=60, deadline=None, derandomize=True)
@given(st.integers(0, 10**6), st.integers(1, 30), st.floats(-7.0, 7.0), st.floats(1e-6, 2 * math.pi + 1e-3))
def test_any_field_of_view_is_exact(seed, beams, low, fov):
    cut, place = scene(seed, 15, 2)
    high = low + fov * (beams > 1)
    seen = Lidar(beams=beams, angle_min=low, angle_max=high, range_max=30.0).look(cut, place)
    agree(seen, by_hand(cut, place, np.linspace(low, high, beams), 30.0))


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.integers(0, 10**6), st.integers(1, 3))
def test_edges_that_begin_and_end_on_beams_leave_no_gap(seed, corners):
    """A closed outline around the sensor with corners on the beams, in both directions: each beam meets its corner."""
    chance = np.random.default_rng(seed)
    far = chance.uniform(0.5, 5.0, 12 * corners)
    turn = 2 * math.pi * np.arange(len(far)) / len(far)
    points = far[:, None] * np.column_stack((np.cos(turn), np.sin(turn)))
    ends = np.roll(points, -1, axis=0)
    for edges in (np.hstack((points, ends)), np.hstack((ends, points))):
        seen = Lidar(beams=len(far), angle_max=float(turn[-1])).look(Cut(edges, np.zeros((0, 3))), Pose2D())
        np.testing.assert_allclose(seen, far, rtol=1e-7)


def test_the_first_and_the_last_beam_of_a_full_turn_see_the_same():
    edges = np.array([[-1.0, 0.0, -2.0, -1.0], [-3.0, -1.0, -3.0, 1.0]])
    seen = Lidar(beams=721, angle_min=-math.pi, angle_max=math.pi).look(Cut(edges, np.zeros((0, 3))), Pose2D())
    assert (seen[0], seen[-1]) == (pytest.approx(1.0), pytest.approx(1.0))


def test_on_an_edge_there_is_no_distance_left():
    wall = Cut(np.array([[-1.0, -1.0, 2.0, 2.0]]), np.zeros((0, 3)))
    assert Lidar(beams=8, angle_min=-3.0, angle_max=3.0).look(wall, Pose2D()).tolist() == [0.0] * 8


def test_edges_that_are_no_numbers_hide_nothing():
    wrong = [[math.nan, 0.0, 1.0, 1.0], [math.inf, 0.0, -math.inf, 1.0], [1e300, 0.0, 0.0, 1e300]]
    edges = Cut(np.array([*wrong, [2.0, -1.0, 2.0, 1.0]]), np.zeros((0, 3)))
    seen = Lidar(beams=4, angle_max=1.5 * math.pi).look(edges, Pose2D())
    assert seen.tolist() == [2.0, FAR, FAR, FAR]


def test_a_closed_room_has_no_gap_even_through_its_corners():
    room = np.array([[-1, -1, 1, -1], [1, -1, 1, 1], [1, 1, -1, 1], [-1, 1, -1, -1]], float)
    seen = Lidar(beams=3600, angle_max=2 * math.pi * 3599 / 3600).look(Cut(room, np.zeros((0, 3))), Pose2D())
    assert seen.max() <= math.sqrt(2) + 1e-9 and seen.min() == pytest.approx(1.0)


def test_an_edge_seen_end_on_is_as_far_as_its_near_end():
    edge = Cut(np.array([[1.0, 0.0, 2.0, 0.0]]), np.zeros((0, 3)))
    seen = Lidar(beams=4, angle_max=1.5 * math.pi).look(edge, Pose2D())
    assert seen.tolist() == [1.0, FAR, FAR, FAR]


def test_a_lidar_on_its_head_reports_the_mirrored_scan():
    cut, place = scene(3)
    chance = np.random.default_rng(0)
    up = Lidar(beams=60, angle_min=-1.0, angle_max=1.0)
    down = Lidar(beams=60, angle_min=-1.0, angle_max=1.0, upside_down=True)
    np.testing.assert_allclose(
        down.measure(down.look(cut, place), chance), up.measure(up.look(cut, place), chance)[::-1]
    )


def test_noise_dropouts_and_limits_are_as_told():
    wall = Cut(np.array([[-50.0, 2.0, 50.0, 2.0]]), np.array([[0.0, -0.3, 0.25]]))
    lidar = Lidar(beams=1001, angle_min=-1.0 + math.pi / 2, angle_max=1.0 + math.pi / 2, noise=0.05, dropouts=0.1)
    true = lidar.look(wall, Pose2D())
    seen = lidar.measure(true, np.random.default_rng(1))
    assert 60 < np.isinf(seen).sum() < 140
    assert np.std((seen - true)[np.isfinite(seen)]) == pytest.approx(0.05, rel=0.15)
    behind = Lidar(beams=1, angle_min=-math.pi / 2, angle_max=-math.pi / 2)
    assert behind.measure(behind.look(wall, Pose2D()), np.random.default_rng(1)).tolist() == [-FAR]


def test_what_is_beyond_the_reach_is_not_seen():
    wall = Cut(np.array([[5.0, -1.0, 5.0, 1.0]]), np.zeros((0, 3)))
    near = Lidar(beams=1, angle_min=0.0, angle_max=0.0, range_max=4.9)
    assert np.isinf(near.measure(near.look(wall, Pose2D()), np.random.default_rng(1))).all()


@pytest.mark.parametrize(
    "wrong", [{"beams": 0}, {"range_max": 0.1}, {"noise": -1.0}, {"dropouts": 2.0}, {"rate": 0.0},
              {"angle_max": 7.0}, {"angle_max": math.nan}, {"angle_max": 0.0}]
)  # fmt: skip
def test_impossible_lidars_are_refused(wrong):
    with pytest.raises(WorldError, match="LiDAR"):
        Lidar(**wrong)
