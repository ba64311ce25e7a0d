"""Scans that look through each other's walls are not of one place."""

import math

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.slam.contradiction import contradiction
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Laser, Scan
from coursekit.slam.slam import Slam
from tests.slam.building import ROUND, Wheels, drive, look, office, rectangle

LASER = Laser(-math.pi, math.radians(1), range_max=12.0)
AHEAD = Laser(-math.pi / 2, math.radians(1), range_max=10.0)


def scan(walls, pose, laser=LASER, beams=360):
    rng = np.random.default_rng(0)
    return Scan.from_ranges(look(np.array(walls), pose, laser, beams, rng), laser, SlamParameters())


def test_two_looks_at_one_room_agree_from_wherever():
    walls = office(2)
    poses = [Pose2D(3.0, 5.0, 0.0), Pose2D(4.0, 5.2, 1.0), Pose2D(5.5, 4.6, -2.0)]
    pairs = [(scan(walls, a), scan(walls, b), a.to(b)) for a in poses for b in poses]
    assert contradiction(pairs) < 0.01


@pytest.mark.parametrize("laser", [LASER, AHEAD], ids=["all round", "ahead"])
def test_a_wall_that_was_moved_is_a_contradiction(laser):
    beams = 360 if laser is LASER else 181
    room, shorter = rectangle(0, 0, 8, 5), rectangle(0, 0, 6.5, 5)
    here = Pose2D(2.0, 2.0, 0.3)
    assert contradiction([(scan(room, here, laser, beams), scan(shorter, here, laser, beams), Pose2D())]) > 0.05
    assert contradiction([(scan(room, here, laser, beams), scan(room, here, laser, beams), Pose2D())]) == 0.0


def test_what_is_hidden_contradicts_nothing():
    room = rectangle(0, 0, 8, 5)
    behind = [*room, *rectangle(5.0, 1.0, 0.5, 1.5)]  # a cupboard that was brought in hides the wall behind it
    told = contradiction([(scan(behind, Pose2D(2.0, 2.0)), scan(behind, Pose2D(7.0, 2.0, 3.0)), Pose2D(5.0, 0.0, 3.0))])
    assert told < 0.01


def test_scans_without_hits_tell_nothing():
    empty = Scan.from_ranges([math.inf] * 360, LASER, SlamParameters())
    assert contradiction([(empty, empty, Pose2D())]) == 0.0 and contradiction([]) == 0.0


@pytest.mark.parametrize("seed", [7, 9])
def test_rooms_that_look_alike_are_told_apart(seed):
    walls, rng, wheels = office(seed), np.random.default_rng(1), Wheels(np.random.default_rng(1))
    way = list(drive(ROUND, 0.15))
    slam = Slam()
    for number, pose in enumerate(way):
        slam.add_ranges(0.1 * number, look(walls, pose, AHEAD, 181, rng), AHEAD, wheels.roll(pose))
    slam.finish()
    truth = np.array([tuple(way[0].to(pose)) for pose in way])
    assert np.hypot(*(slam.trajectory()[:, 1:3] - truth[:, :2]).T).max() < 0.1
    assert slam.search.rejected > 0


@pytest.mark.parametrize("seed", [3, 7])
def test_corridors_that_look_alike_all_along_close_no_loop(seed):
    short = Laser(-math.pi, math.radians(1), range_max=3.5)
    walls, rng, wheels = office(seed), np.random.default_rng(1), Wheels(np.random.default_rng(1))
    way = list(drive(ROUND, 0.15))
    slam = Slam()
    for number, pose in enumerate(way):
        slam.add_ranges(0.1 * number, look(walls, pose, short, 360, rng), short, wheels.roll(pose))
    truth = [way[0].to(pose) for pose in way]
    keys = [truth[k] for k in [0] + [k for k in range(1, len(way)) if slam.bases[k] != slam.bases[k - 1]]]
    assert slam.loops
    assert all(keys[loop.first].to(keys[loop.second]).distance(loop.motion) < 0.3 for loop in slam.loops)
