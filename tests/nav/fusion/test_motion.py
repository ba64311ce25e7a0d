"""The motion model of 15 numbers."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.nav.fusion.motion import jacobian, rotation, step
from coursekit.nav.fusion.state import SIZE, VX, VYAW, X, Y, wrap

STATES = st.lists(st.floats(-1.2, 1.2), min_size=SIZE, max_size=SIZE).map(np.array)


@given(STATES, st.floats(0.001, 0.5))
def test_the_jacobian_is_the_slope_of_the_step(state, seconds):
    tiny = 1e-6
    slopes = [
        (step(state + tiny * axis, seconds) - step(state - tiny * axis, seconds)) / (2 * tiny) for axis in np.eye(SIZE)
    ]
    assert jacobian(state, seconds) == pytest.approx(np.array(slopes).T, abs=1e-6)


@given(*[st.floats(-3.0, 3.0)] * 3)
def test_rotations_keep_lengths_and_hands(roll, pitch, yaw):
    matrix = rotation(roll, pitch, yaw)
    assert matrix @ matrix.T == pytest.approx(np.eye(3), abs=1e-12) and np.linalg.det(matrix) == pytest.approx(1.0)


def test_a_circle_closes():
    state = np.zeros(SIZE)
    state[VX], state[VYAW] = 1.0, 1.0
    for _ in range(6283):
        state = step(state, 2 * math.pi / 6283)
    assert math.hypot(state[X], state[Y]) < 0.01


def test_no_time_changes_nothing():
    state = np.linspace(-1, 1, SIZE)
    assert (step(state, 0.0) == state).all() and (jacobian(state, 0.0) == np.eye(SIZE)).all()


@given(st.floats(-1000, 1000))
def test_a_wrapped_angle_points_the_same_way(angle):
    wrapped = float(wrap(np.array([angle]))[0])
    assert -math.pi <= wrapped <= math.pi and math.cos(wrapped) == pytest.approx(math.cos(angle), abs=1e-9)
