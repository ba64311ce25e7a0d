"""Driving through a building of straight walls, with drifting odometry and other lasers, ends where the truth is."""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Laser, Scan
from coursekit.slam.slam import Slam
from tests.slam.building import ROUND, Wheels, drive, look, office

FULL = Laser(-math.pi, math.radians(1), range_max=12.0)
LASERS = {
    "360 beams all round to 8 m": (Laser(-math.pi, math.radians(1), range_max=8.0), 360),
    "181 beams ahead": (Laser(-math.pi / 2, math.radians(1), range_max=30.0), 181),
    "1081 beams over 270 degrees": (Laser(-math.radians(135), math.radians(0.25), range_max=30.0), 1081),
    "3600 beams to 80 m": (Laser(-math.pi, math.radians(0.1), range_max=80.0), 3600),
    "looking back, off the middle": (
        Laser(-math.pi / 2, math.radians(0.5), 0.0, 20.0, Pose2D(-0.2, 0.1, math.pi)),
        361,
    ),
}


@functools.cache
def seen(laser: Laser, beams: int, seed: int, step: float) -> list[np.ndarray]:
    """The ranges of each scan on the way."""
    rng, walls = np.random.default_rng(seed), office(3)
    return [look(walls, pose, laser, beams, rng) for pose in drive(ROUND, step)]


class Drive:
    """A drive through the office: what SLAM made of it, and the truth from its first pose on."""

    def __init__(
        self, laser: Laser, beams: int, *, seed: int = 1, odometry: bool = True, step: float = 0.1, spoil=None
    ) -> None:
        rng, self.wheels, self.slam = np.random.default_rng(seed), Wheels(np.random.default_rng(seed)), Slam()
        way = list(drive(ROUND, step))
        self.truth = [way[0].to(pose) for pose in way]
        self.results = []
        for number, (pose, ranges) in enumerate(zip(way, seen(laser, beams, seed, step), strict=True)):
            if spoil is not None:
                ranges = spoil(number, ranges.copy(), rng)
            rolled = self.wheels.roll(pose)
            self.results.append(
                self.slam.add_ranges(0.1 * number, ranges, laser, rolled if odometry else None)
            )
        self.slam.finish()

    @property
    def errors(self) -> np.ndarray:
        """Metres off, for each scan."""
        estimated = self.slam.trajectory()[:, 1:3]
        return np.hypot(*(estimated - np.array(self.truth)[:, :2]).T)


@functools.cache
def usual() -> Drive:
    """The drive that several tests look at."""
    return Drive(FULL, 360)


def test_the_odometry_of_these_drives_is_useless_on_its_own() -> None:
    assert usual().wheels.pose.distance(usual().truth[-1]) > 5


@pytest.mark.parametrize("kind", LASERS)
def test_every_laser_brings_the_robot_home(kind: str) -> None:
    laser, beams = LASERS[kind]
    assert Drive(laser, beams, step=0.1 if beams < 1000 else 0.3).errors.max() < 0.1


def test_no_odometry_is_needed() -> None:
    assert Drive(FULL, 360, odometry=False).errors.max() < 0.05


def test_few_scans_a_metre_are_enough() -> None:
    assert Drive(FULL, 360, step=0.4).errors.max() < 0.1


def test_loops_are_found_and_every_scan_has_a_pose() -> None:
    slam = usual().slam
    assert len(slam.loops) > 5 and slam.lost == 0
    assert len(slam.trajectory()) == len(usual().truth) == len(usual().results)
    assert sum(result.keyframe for result in usual().results) == len(slam.keyframes)


def test_the_map_agrees_with_the_building() -> None:
    grid, start = usual().slam.map(), next(iter(drive(ROUND)))
    rows, columns = np.nonzero(grid.cells() >= 65)
    points = start.transform(
        (np.stack([columns, rows], axis=1) + 0.5) * grid.resolution + np.array(grid.origin)
    )
    walls = office(3)
    a, b = walls[:, None, :2], walls[:, None, 2:]
    along = np.clip(
        ((points - a) * (b - a)).sum(axis=2) / np.maximum(((b - a) ** 2).sum(axis=2), 1e-12), 0, 1
    )
    gaps = np.linalg.norm(points - a - along[..., None] * (b - a), axis=2).min(axis=0)
    assert len(points) > 2000 and (gaps < 0.075).mean() > 0.97


def test_bad_beams_of_every_kind_do_no_harm() -> None:
    def spoil(number: int, ranges: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        ranges[rng.integers(0, 360, 40)] = [math.nan, 0.0, math.inf, -1.0] * 10
        ranges[rng.integers(0, 360, 10)] = rng.uniform(0.1, 10, 10)  # people
        return ranges

    assert Drive(FULL, 360, spoil=spoil).errors.max() < 0.1


def test_scans_that_see_nothing_are_bridged_by_the_odometry() -> None:
    def blind(number: int, ranges: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        return np.full(360, math.inf) if 100 <= number < 105 else ranges

    drive_ = Drive(FULL, 360, spoil=blind)
    assert not any(result.accepted for result in drive_.results[100:105])
    assert drive_.slam.lost == 5 and drive_.errors.max() < 0.1


def test_other_beam_counts_in_between_do_no_harm() -> None:
    def cut(number: int, ranges: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        return ranges[: 360 - 37 * (number % 3)]

    assert Drive(FULL, 360, spoil=cut).errors.max() < 0.1


def test_the_same_input_gives_the_same_bytes() -> None:
    again = Drive(FULL, 360)
    assert again.slam.trajectory().tobytes() == usual().slam.trajectory().tobytes()
    assert again.slam.map().log_odds.tobytes() == usual().slam.map().log_odds.tobytes()


def test_the_map_can_be_asked_for_at_any_time() -> None:
    slam, rng, wheels = Slam(), np.random.default_rng(0), Wheels(np.random.default_rng(0))
    seen = []
    for number, pose in enumerate(list(drive(ROUND))[:120]):
        slam.add_ranges(0.1 * number, look(office(3), pose, FULL, 360, rng), FULL, wheels.roll(pose))
        if number % 20 == 0:
            seen.append(int((slam.map().cells() >= 0).sum()))
    assert seen == sorted(seen) and seen[-1] > seen[0] > 100


def test_odometry_that_is_reset_or_absurd_is_not_followed() -> None:
    slam, rng, wheels = Slam(), np.random.default_rng(0), Wheels(np.random.default_rng(0))
    way = list(drive(ROUND))[:80]
    for number, pose in enumerate(way):
        rolled = wheels.roll(pose)
        if number >= 40:
            rolled = rolled @ Pose2D(1e9, 0.0, 0.0) if number < 60 else Pose2D(math.nan, 0.0, 0.0)
        result = slam.add_ranges(0.1 * number, look(office(3), pose, FULL, 360, rng), FULL, rolled)
    assert result.pose.distance(way[0].to(way[-1])) < 0.1


def test_a_long_way_without_a_scan_is_bridged_by_the_odometry() -> None:
    """A busy computer takes no scan for eight seconds, and the robot drives on."""
    way, slam, off = list(drive(ROUND, 0.1)), Slam(), []
    for number, (pose, ranges) in enumerate(zip(way, seen(FULL, 360, 1, 0.1), strict=True)):
        if not 60 <= number < 140:
            estimate = slam.add_ranges(0.1 * number, ranges, FULL, pose).pose
            off.append(estimate.distance(way[0].to(pose)))
    assert way[59].distance(way[140]) > 6.0 and max(off) < 0.2


def test_an_empty_session_has_an_empty_trajectory_and_map() -> None:
    slam = Slam(start=Pose2D(1.0, 2.0, 0.5))
    slam.finish()
    assert slam.trajectory().shape == (0, 4) and not slam.map().log_odds.size
    assert slam.pose == Pose2D(1.0, 2.0, 0.5)


def test_a_session_may_begin_with_nothing_to_see() -> None:
    slam = Slam()
    for number in range(5):
        slam.add(Scan.from_points(np.zeros((0, 2)), slam.params, stamp=number), Pose2D(0.5 * number, 0.0, 0.0))
    assert slam.pose.distance(Pose2D(2.0, 0.0, 0.0)) < 1e-6


def test_parameters_that_cannot_work_are_refused() -> None:
    with pytest.raises(ValueError, match="cell must be above 0"):
        SlamParameters(cell=0.0)
