"""What the wheels get wrong is learnt, and never more than can be."""

from __future__ import annotations

import math

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.slam.odometry import Calibration
from coursekit.slam.scan import Laser
from coursekit.slam.slam import Slam
from tests.slam.building import ROUND, Wheels, drive, look, office


@pytest.mark.parametrize(("scale", "turn", "pull"), [(1.0, 1.0, 0.0), (0.8, 1.1, 0.1), (1.3, 0.9, -0.15)])
def test_most_of_what_is_wrong_is_learnt_on_the_way(scale: float, turn: float, pull: float) -> None:
    rng, wheels = np.random.default_rng(0), Calibration()
    for _ in range(600):
        told = Pose2D(0.1, 0.0, rng.normal(0, 0.15))
        true = Pose2D(scale * told.x, 0.0, turn * told.theta + pull * told.x)
        wheels.learn(told, Pose2D(true.x + rng.normal(0, 0.003), 0.0, true.theta + rng.normal(0, 0.003)))
    for learnt, real, plain in ((wheels.scale, scale, 1), (wheels.turn_scale, turn, 1), (wheels.pull, pull, 0)):
        assert abs(learnt - real) < 0.35 * abs(plain - real) + 0.02


def test_a_standing_robot_and_absurd_motions_teach_nothing_absurd() -> None:
    wheels = Calibration()
    wheels.learn(Pose2D(), Pose2D(0.1, 0.0, 0.2))
    assert wheels.correct(Pose2D(1.0, 0.0, 0.1)) == pytest.approx(Pose2D(1.0, 0.0, 0.1))
    wheels.learn(Pose2D(3.0, 0.0, 3.0), Pose2D(-3.0, 0.0, -3.0))
    assert 0.5 <= wheels.scale <= 2.0 and 0.5 <= wheels.turn_scale <= 2.0 and abs(wheels.pull) <= 1.0


def test_wheels_that_are_far_off_still_bring_the_robot_home() -> None:
    laser, rng = Laser(-math.pi / 2, math.radians(1), range_max=10.0), np.random.default_rng(3)
    wheels, slam, way = Wheels(rng, scale=1.3, pull=0.15, noise=0.1), Slam(), list(drive(ROUND))
    for number, pose in enumerate(way):
        slam.add_ranges(0.1 * number, look(office(3), pose, laser, 181, rng), laser, wheels.roll(pose))
    slam.finish()
    truth = np.array([way[0].to(pose) for pose in way])
    assert wheels.pose.distance(way[0].to(way[-1])) > 10
    assert np.hypot(*(slam.trajectory()[:, 1:3] - truth[:, :2]).T).max() < 0.1
