"""Odometry from scans alone follows a robot round the office."""

import math

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.slam.laser_odometry import LaserOdometry
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Laser, Scan
from tests.slam.building import look, office

PARAMS = SlamParameters()
LASER = Laser(-math.pi, math.radians(1), range_max=12.0, offset=Pose2D(0.1, 0.0, 0.3))
NOTHING = Scan.from_points(np.zeros((0, 2)), PARAMS)


def drive(odometry, start, steps, walls):
    """Drive in steps of (forward, turn); where the robot is in the end, seen from the start."""
    rng, pose = np.random.default_rng(2), start
    for number, (forward, turn) in enumerate([(0.0, 0.0), *steps]):
        pose = pose @ Pose2D(forward, 0.0, turn)
        ranges = look(walls, pose @ LASER.offset, Laser(LASER.angle_min, LASER.angle_increment, range_max=12.0), 360, rng)
        assert odometry.add(Scan.from_ranges(ranges, LASER, PARAMS, 0.1 * number))
    return start.to(pose)


@pytest.mark.parametrize("turn", [0.0, 0.02, -0.03])
def test_it_follows_a_drive_down_the_corridor(turn):
    odometry = LaserOdometry()
    moved = drive(odometry, Pose2D(3.0, 5.0, 0.0), [(0.05, turn * math.cos(k / 10)) for k in range(160)], office(3))
    assert math.hypot(moved.x, moved.y) > 4.0
    assert odometry.pose.distance(moved) < 0.1 and abs(odometry.pose.theta - moved.theta) < 0.03


def test_it_begins_where_it_is_told():
    odometry = LaserOdometry(Pose2D(1.0, 2.0, math.pi / 2))
    moved = drive(odometry, Pose2D(3.0, 5.0, 0.0), [(0.05, 0.0)] * 20, office(3))
    assert odometry.pose.distance(Pose2D(1.0, 2.0, math.pi / 2) @ moved) < 0.05


def test_a_covered_laser_stands_still():
    odometry = LaserOdometry()
    drive(odometry, Pose2D(3.0, 5.0, 0.0), [(0.05, 0.0)] * 10, office(3))
    before = odometry.pose
    assert not odometry.add(NOTHING) and odometry.pose.distance(before) == 0.0 and odometry.motion == Pose2D()


def test_a_laser_that_never_saw_anything_stands_still():
    odometry = LaserOdometry()
    for _ in range(3):
        odometry.add(NOTHING)
    assert odometry.pose == Pose2D()
