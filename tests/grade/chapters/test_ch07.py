"""What the checks of chapter 7 say is wrong with a view, a step and a stage."""

import cmath
import math

import pytest

from coursekit.grade.chapters.measures.stages import judge_stage, judge_step
from coursekit.grade.verdict import Wrong
from tests.grade.tried import told_of


def seen_from(me, other, yaw=None, sign=1.0):
    shift = sign * (complex(*other[:2]) - complex(*me[:2])) * cmath.rect(1.0, -(me[2] if yaw is None else yaw))
    return shift.real, shift.imag, math.remainder(other[2] - me[2], math.tau)


@pytest.mark.parametrize(
    ("seen", "cause"),
    [
        (lambda me, other: seen_from(me, other, yaw=0.0), "My yaw is not used"),
        (lambda me, other: seen_from(me, other, yaw=-me[2]), "wrong direction"),
        (lambda me, other: seen_from(me, other, yaw=math.radians(me[2])), "in radians already"),
        (lambda me, other: seen_from(me, other, sign=-1.0), "The other minus me"),
        (lambda me, other: seen_from(me, other)[:2], "3 values are asked for, these are 2"),
    ],
)
def test_a_view_s_fault_is_named(tmp_path, seen, cause):
    assert cause in told_of("ch07.q1", {"seen": seen}, tmp_path).cause


@pytest.mark.parametrize(("turned", "cause"), [(1.0, "theta is in radians"), (0.5, "")])
def test_a_turn_of_a_radian_is_told_as_such(turned, cause):
    with pytest.raises(Wrong) as caught:
        judge_step(0, 0, (0.0, 0.0, 0.0), (0.0, 0.0, turned))
    assert caught.value.cause.startswith(cause) and bool(caught.value.cause) == bool(cause)


@pytest.mark.parametrize(
    ("end", "steps", "cause"), [(0.1, 10, "too early"), (-0.5, 10, "two poses"), (0.995, 100, "last, shorter step")]
)
def test_how_a_stage_ends_wrong_is_told(end, steps, cause):
    with pytest.raises(Wrong) as caught:
        judge_stage(1, (0.0, 0.0, 0.0), (end, 0.0, 0.0), (1.0, 0.0, 0.0), steps)
    assert cause in caught.value.cause
