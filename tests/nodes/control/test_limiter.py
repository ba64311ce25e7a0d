"""Limits of a speed by diff_drive_controller's parameters."""

import pytest

from coursekit.nodes.control.controller import ControlError
from coursekit.nodes.control.limiter import SpeedLimiter


def limiter(**told):
    values = {f"linear.x.{name}": value for name, value in told.items()}
    return SpeedLimiter(values.get, "linear.x")


def test_limits_that_are_not_asked_for_limit_nothing():
    assert limiter(max_velocity=0.5, max_acceleration=0.1).limit(3.0, 0.1) == 3.0


def test_a_speed_backwards_has_its_own_limit_or_that_of_forwards():
    assert limiter(has_velocity_limits=True, max_velocity=0.5).limit(-3.0, 0.1) == -0.5
    assert limiter(has_velocity_limits=True, max_velocity=0.5, min_velocity=-0.2).limit(-3.0, 0.1) == -0.2


def test_an_acceleration_is_limited_step_by_step():
    ramped = limiter(has_acceleration_limits=True, max_acceleration=1.0, min_acceleration=-2.0)
    assert [round(ramped.limit(wish, 0.1), 9) for wish in (0.25, 0.25, 0.25, 0.0, 0.0)] == [0.1, 0.2, 0.25, 0.05, 0.0]


def test_a_jerk_is_limited_too():
    jerk_limiter = limiter(has_jerk_limits=True, max_jerk=5.0)
    assert [round(jerk_limiter.limit(9.0, 0.1), 9) for _ in range(3)] == [0.1, 0.3, 0.6]


def test_a_limit_without_its_number_is_told():
    with pytest.raises(ControlError, match="Cannot apply velocity limits if max_velocity is not specified"):
        limiter(has_velocity_limits=True)
