"""What counts as a hit, where it lies, and which way its wall runs."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from coursekit.geometry.plane import Pose2D
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Laser, Scan
from tests.slam.building import look, rectangle

PARAMS = SlamParameters()
ROOM = np.array(rectangle(-3, -2, 6, 4))


def seen(laser: Laser, beams: int) -> Scan:
    """A scan from the middle of the room."""
    rng = np.random.default_rng(0)
    return Scan.from_ranges(look(ROOM, Pose2D(), laser, beams, rng, noise=0.0), laser, PARAMS)


def test_hits_lie_on_the_walls() -> None:
    hits = seen(Laser(-math.pi, math.radians(1)), 360).hits
    off = np.minimum(np.abs(np.abs(hits[:, 0]) - 3), np.abs(np.abs(hits[:, 1]) - 2))
    assert len(hits) == 360 and off.max() < 1e-9


def test_a_mounted_laser_sees_the_same_walls_in_the_robots_frame() -> None:
    for offset in (Pose2D(0.3, -0.2, 0.0), Pose2D(-0.4, 0.1, math.pi), Pose2D(0.0, 0.5, 1.0)):
        hits = seen(Laser(-math.pi, math.radians(1), offset=offset), 360).hits
        off = np.minimum(np.abs(np.abs(hits[:, 0]) - 3), np.abs(np.abs(hits[:, 1]) - 2))
        assert off.max() < 1e-9


def test_a_laser_mounted_upside_down_turns_the_other_way() -> None:
    laser = Laser(0.0, math.radians(90), flipped=True)
    hits = Scan.from_ranges([1.0, 2.0], laser, PARAMS).hits
    assert np.allclose(sorted(hits.tolist()), [[0.0, -2.0], [1.0, 0.0]])


def test_normals_stand_across_the_walls_and_face_the_laser() -> None:
    scan = seen(Laser(-math.pi, math.radians(1)), 360)
    clear = np.hypot(*scan.normals.T) > 0
    assert clear.mean() > 0.8
    assert (np.abs(scan.normals[clear]).max(axis=1) > 0.99).mean() > 0.9
    assert (np.einsum("ij,ij->i", scan.normals, scan.points)[clear] < 0).all()


def test_what_is_no_range_is_no_hit() -> None:
    ranges = [math.nan, math.inf, -math.inf, -1.0, 0.0, 0.01, 12.0, 30.0, 5.0]
    scan = Scan.from_ranges(ranges, Laser(0.0, 0.1, range_min=0.1, range_max=30.0), PARAMS)
    assert sorted(np.hypot(*scan.hits.T).round(6)) == [5.0, 12.0]


def test_beams_without_return_clear_only_when_asked() -> None:
    laser = Laser(0.0, 0.1, range_max=30.0)
    ranges = [30.0, math.inf, math.nan, 2.0]
    assert len(Scan.from_ranges(ranges, laser, PARAMS).misses) == 0
    cleared = Scan.from_ranges(ranges, laser, SlamParameters(clear_no_return=3.0)).misses
    assert np.allclose(np.hypot(*cleared.T), [3.0, 3.0])


def test_few_beams_on_a_wall_leave_no_gap() -> None:
    scan = seen(Laser(-math.pi, math.radians(4)), 90)
    points = np.concatenate([scan.points, scan.filled])
    wall = np.sort(points[(np.abs(points[:, 1] - 2) < 1e-6) & (np.abs(points[:, 0]) < 2.3)][:, 0])
    assert np.diff(wall).max() < 2 * PARAMS.point_spacing


@given(st.lists(st.floats(allow_nan=True, allow_infinity=True, width=32), max_size=50))
def test_any_numbers_make_a_scan(ranges: list[float]) -> None:
    scan = Scan.from_ranges(ranges, Laser(-1.0, 0.05, range_max=100.0), PARAMS)
    assert np.isfinite(scan.hits).all() and np.isfinite(scan.normals).all()
    assert len(scan.points) <= len(scan.hits) <= len(ranges)


def test_points_may_come_in_any_order() -> None:
    scan = seen(Laser(-math.pi, math.radians(1)), 360)
    mixed = np.random.default_rng(1).permutation(scan.hits)
    again = Scan.from_points(mixed, PARAMS)
    assert np.array_equal(again.points, scan.points) and np.array_equal(again.normals, scan.normals)


def test_few_beams_far_apart_still_tell_how_the_walls_run() -> None:
    scan = seen(Laser(-math.pi, math.radians(10)), 36)
    clear = np.abs(scan.normals).max(axis=1) > 0.999
    assert clear.sum() > len(scan.points) / 2
    assert all(np.isclose(np.abs(scan.normals[clear]).min(axis=1), 0.0, atol=0.01))
