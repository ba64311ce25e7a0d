"""Kalman filters: the properties that hold for both kinds."""

import math
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from coursekit.nav.fusion.control import Control
from coursekit.nav.fusion.kalman import PROCESS_NOISE, Ekf
from coursekit.nav.fusion.state import OUT_OF_PLANE, POSE, SIZE, VX, VYAW, YAW, X, Y
from coursekit.nav.fusion.unscented import Ukf
from tests.nav.fusion.drive import drive, say

BOTH = pytest.mark.parametrize("kind", [Ekf, Ukf])
SECOND = 10**9
CALM = np.diag(PROCESS_NOISE) * 0.01
"""Noise of a robot whose wheels hold the floor; with more, headings that nobody measures are soon anyone's guess."""


def started(kind, **numbers):
    kalman = kind()
    kalman.take(say(0, **numbers))
    return kalman


@BOTH
def test_the_first_measurement_is_believed_as_it_is(kind):
    kalman = started(kind, X=(3.0, 0.5), YAW=(1.0, 0.1))
    assert kalman.now.state[[X, Y, YAW]].tolist() == [3.0, 0.0, 1.0] and kalman.now.covariance[X, X] == 0.5


@BOTH
def test_equal_doubts_meet_in_the_middle_with_half_the_doubt(kind):
    kalman = started(kind, X=(0.0, 2.0))
    kalman.take(say(0, X=(1.0, 2.0)))
    assert kalman.now.state[X] == pytest.approx(0.5) and kalman.now.covariance[X, X] == pytest.approx(1.0)


@BOTH
def test_angles_are_corrected_the_short_way_round(kind):
    kalman = started(kind, YAW=(3.1, 0.1))
    kalman.take(say(0, YAW=(-3.1, 0.1)))
    assert abs(kalman.now.state[YAW]) == pytest.approx(math.pi, abs=1e-6)


@BOTH
def test_what_is_too_far_off_is_not_believed_and_changes_nothing(kind):
    kalman = started(kind, X=(0.0, 0.01))
    before = kalman.now.covariance.copy()
    assert kalman.take(say(0, X=(5.0, 0.01), threshold=3.0)) is False
    assert kalman.now.state[X] == 0.0 and (kalman.now.covariance == before).all()
    assert kalman.take(say(0, X=(0.3, 0.01), threshold=3.0)) is True
    assert kalman.take(say(0, X=(900.0, 0.01), threshold=sys.float_info.max)) is True


@BOTH
def test_numbers_that_are_none_are_left_out_and_variances_that_are_wrong_do_no_harm(kind):
    kalman = started(kind, X=(1.0, 0.1), Y=(1.0, 0.1))
    kalman.take(say(0, X=(math.nan, 0.1), Y=(2.0, -0.1)))
    assert kalman.now.state[[X, Y]] == pytest.approx([1.0, 1.5])
    kalman.take(say(0, X=(2.0, 0.0)))
    assert kalman.now.state[X] == pytest.approx(2.0, abs=1e-6) and np.isfinite(kalman.now.covariance).all()


@BOTH
def test_without_measurements_doubt_grows_and_the_motion_goes_on(kind):
    kalman = started(kind, VX=(1.0, 1e-6), YAW=(math.pi / 2, 1e-6))
    doubt = np.diag(kalman.now.covariance).copy()
    kalman.predict(SECOND)
    assert kalman.now.state[Y] == pytest.approx(1.0, abs=1e-3) and (np.diag(kalman.now.covariance) > doubt).all()


@BOTH
def test_a_robot_that_stands_does_not_lose_itself_when_noise_follows_the_speed(kind):
    kalman = kind(scaled=True)
    kalman.take(say(0, VX=(0.0, 1e-9)))
    kalman.predict(SECOND)
    assert np.diag(kalman.now.covariance)[POSE][:2].max() < 1e-2 < np.diag(kalman.noise)[0]


@BOTH
def test_wheels_and_gyroscope_together_are_nearer_to_the_truth_than_wheels_alone(kind):
    errors = {}
    for heard in ("wheels", "both"):
        kalman, truth = kind(CALM), (0.0, 0.0, 0.0)
        for truth, wheels, gyroscope in drive(3, 600):  # noqa: B007
            kalman.take(wheels)
            if heard == "both":
                kalman.take(gyroscope)
        errors[heard] = math.dist(kalman.now.state[[X, Y]], truth[:2])
        assert kalman.now.state[list(OUT_OF_PLANE)].tolist() == pytest.approx([0.0] * 7, abs=1e-9)
    assert errors["both"] < 0.1 and errors["both"] < errors["wheels"] / 3


def test_both_kinds_say_the_same_of_a_gentle_drive():
    one, other = Ekf(CALM), Ukf(CALM)
    for _, wheels, gyroscope in drive(5, 300):
        for kalman in (one, other):
            kalman.take(wheels)
            kalman.take(gyroscope)
    assert one.now.state == pytest.approx(other.now.state, abs=0.01)


@settings(max_examples=25)
@given(st.integers(0, 10**6))
def test_the_covariance_stays_one(seed):
    rng, ekf = np.random.default_rng(seed), Ekf()
    names = ("X", "Y", "YAW", "VX", "VYAW", "ROLL", "AX")
    for k in range(40):
        told = {str(name): (float(rng.normal()), float(rng.uniform(0, 2))) for name in rng.choice(names, 3, replace=False)}
        ekf.take(say(k * 10**8, **told))
    eigen = np.linalg.eigvalsh((ekf.now.covariance + ekf.now.covariance.T) / 2)
    assert ekf.now.covariance == pytest.approx(ekf.now.covariance.T, rel=1e-6, abs=1e-9) and eigen.min() > -1e-9


def test_a_command_speeds_the_robot_up_within_its_limits_until_it_is_too_old():
    ones, used = np.ones(6), np.zeros(6, bool)
    used[[0, 5]] = True
    ekf = Ekf(control=Control(used, SECOND // 5, 2.0 * ones, ones, 3.0 * ones, ones))
    ekf.take(say(0, VX=(0.0, 1e-9), VYAW=(0.0, 1e-9)))
    ekf.control.command(np.array([10.0, 0, 0, 0, 0, 1.0]), 0)
    ekf.predict(SECOND // 10)
    assert ekf.now.state[[VX, VYAW]] == pytest.approx([0.2, 0.1])
    ekf.predict(SECOND)
    assert ekf.now.state[VX] < 0.2  # too old: as if told to stand
    assert len(ekf.now.state) == SIZE
