"""Measurements that wait, come late or stay away."""

import math

import pytest

from coursekit.nav.fusion.estimator import Estimator
from coursekit.nav.fusion.kalman import Ekf
from coursekit.nav.fusion.state import VX, X
from tests.nav.fusion.drive import say

SECOND, TICK = 10**9, 10**8


def told(estimator, *measurements, now_ns):
    for measurement in measurements:
        estimator.add(measurement)
    estimator.advance(now_ns)
    return estimator.filter.now


def test_measurements_are_taken_in_the_order_of_their_times_and_those_of_the_future_wait():
    estimator = Estimator(Ekf(), TICK)
    now = told(estimator, say(3 * TICK, X=(3.0, 0.1)), say(0, X=(0.0, 0.1)), say(9 * TICK, X=(9.0, 0.1)), now_ns=5 * TICK)
    assert now.time_ns == 3 * TICK and 0 < now.state[X] < 3
    estimator.advance(9 * TICK)
    assert estimator.filter.now.time_ns == 9 * TICK


def test_nothing_is_predicted_before_the_first_measurement_nor_before_the_sensors_are_overdue():
    estimator = Estimator(Ekf(), 2 * TICK)
    estimator.advance(SECOND)
    assert not estimator.filter.now.begun
    assert told(estimator, say(SECOND, VX=(1.0, 0.01)), now_ns=SECOND + TICK).time_ns == SECOND
    estimator.advance(SECOND + TICK)
    assert estimator.filter.now.time_ns == SECOND
    estimator.advance(SECOND + 2 * TICK)
    assert estimator.filter.now.time_ns == SECOND + 2 * TICK and estimator.filter.now.state[X] == pytest.approx(0.2)


def test_up_to_now_it_predicts_after_each_measurement():
    estimator = Estimator(Ekf(), SECOND, up_to_now=True)
    assert told(estimator, say(0, VX=(1.0, 0.01)), now_ns=SECOND).state[X] == pytest.approx(1.0)


def test_with_a_history_what_comes_late_counts_as_if_it_had_come_in_time():
    words = [say(k * TICK, VX=(math.sin(k), 0.01)) for k in range(10)]
    in_time, late, without = (Estimator(Ekf(), SECOND, history) for history in (0, SECOND, 0))
    expected = told(in_time, *words, now_ns=SECOND)
    told(late, *words[:4], *words[5:], now_ns=SECOND)
    assert told(late, words[4], now_ns=SECOND).state == pytest.approx(expected.state)
    told(without, *words[:4], *words[5:], now_ns=SECOND)
    assert told(without, words[4], now_ns=SECOND).state[VX] != pytest.approx(expected.state[VX], abs=1e-6)


def test_sources_that_are_not_believed_are_named():
    estimator = Estimator(Ekf(), SECOND)
    told(estimator, say(0, X=(0.0, 1e-4)), say(1, "liar", 2.0, X=(50.0, 1e-4)), now_ns=SECOND)
    assert estimator.refused == ["liar"]
