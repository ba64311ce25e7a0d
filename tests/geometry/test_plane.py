"""SE(2) obeys the laws of a group, and arrays say the same as single poses."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from coursekit.geometry.plane import Pose2D, between, compose, wrap

numbers = st.floats(-100, 100)
poses = st.builds(Pose2D, numbers, numbers, st.floats(-math.pi, math.pi, exclude_max=True))


def same(one: Pose2D, other: Pose2D) -> bool:
    """Equal up to rounding, angles around the circle."""
    return math.hypot(one.x - other.x, one.y - other.y) < 1e-9 and abs(wrap(one.theta - other.theta)) < 1e-9


@given(poses, poses, poses)
def test_composition_is_associative(a: Pose2D, b: Pose2D, c: Pose2D) -> None:
    assert same((a @ b) @ c, a @ (b @ c))


@given(poses)
def test_the_inverse_undoes_a_pose_from_both_sides(a: Pose2D) -> None:
    assert same(a @ a.inverse(), Pose2D())
    assert same(a.inverse() @ a, Pose2D())


@given(poses, poses)
def test_the_motion_to_another_pose_leads_there(a: Pose2D, b: Pose2D) -> None:
    assert same(a @ a.to(b), b)


@given(poses, poses)
def test_points_move_as_poses_do(a: Pose2D, b: Pose2D) -> None:
    points = np.array([[0.0, 0.0], [1.0, 0.0], [3.0, -2.0]])
    assert np.allclose((a @ b).transform(points), a.transform(b.transform(points)))


@given(st.lists(st.tuples(poses, poses), min_size=1, max_size=5))
def test_arrays_say_the_same_as_single_poses(pairs: list[tuple[Pose2D, Pose2D]]) -> None:
    first, second = np.array([a for a, _ in pairs]), np.array([b for _, b in pairs])
    for row, (a, b) in zip(compose(first, second), pairs, strict=True):
        assert same(Pose2D.of(row), a @ b)
    for row, (a, b) in zip(between(first, second), pairs, strict=True):
        assert same(Pose2D.of(row), a.to(b))


@given(st.floats(-1e4, 1e4))
def test_wrapped_angles_lie_in_one_turn_and_point_the_same_way(angle: float) -> None:
    assert -math.pi <= wrap(angle) < math.pi
    assert math.isclose(math.cos(wrap(angle)), math.cos(angle), abs_tol=1e-9)
    assert wrap(angle) == wrap(np.array([angle]))[0]
