"""The error of a trajectory against known motions."""

from __future__ import annotations

import math

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D, between, compose
from coursekit.slam.relations import errors, poses_at, read_relations, read_trajectory, write_trajectory

rng = np.random.default_rng(0)
PATH = np.column_stack([np.arange(50.0), rng.uniform(-5, 5, (50, 2)), rng.uniform(-3, 3, 50)])
PAIRS = np.array([[k, k + 7] for k in range(40)], dtype=float)
TRUE = np.column_stack([PAIRS, between(poses_at(PATH, PAIRS[:, 0]), poses_at(PATH, PAIRS[:, 1]))])


def test_the_true_trajectory_has_no_error_wherever_it_begins() -> None:
    moved = np.column_stack([PATH[:, 0], compose(np.array([4.0, -2.0, 1.3]), PATH[:, 1:])])
    error = errors(moved, TRUE)
    assert error.translation < 1e-9 and error.rotation < 1e-6 and error.used == 40


def test_a_known_fault_has_a_known_size() -> None:
    wrong = TRUE.copy()
    wrong[:, 2:] = compose(TRUE[:, 2:], np.array([0.3, 0.4, math.radians(2)]))
    error = errors(PATH, wrong)
    assert error.translation == pytest.approx(0.5) and error.rotation == pytest.approx(2.0)
    assert error.translation_std == pytest.approx(0.0, abs=1e-9)


def test_rows_may_come_in_any_order() -> None:
    assert errors(np.random.default_rng(1).permutation(PATH), TRUE).translation < 1e-9


def test_stamps_outside_are_left_out_and_told() -> None:
    more = np.vstack([TRUE, [100.0, 107.0, 1.0, 0.0, 0.0]])
    assert (errors(PATH, more).used, errors(PATH, more).outside) == (40, 1)
    with pytest.raises(ValueError, match="do the two files belong to the same log"):
        errors(PATH, more[-1:])


def test_headings_are_interpolated_the_short_way() -> None:
    half = poses_at(np.array([[0.0, 0, 0, 3.1], [1.0, 1, 0, -3.1]]), np.array([0.5]))
    assert abs(abs(half[0, 2]) - math.pi) < 1e-9


def test_files_come_back_as_written(tmp_path) -> None:
    write_trajectory(tmp_path / "out.txt", PATH)
    assert np.allclose(read_trajectory(tmp_path / "out.txt"), PATH, atol=1e-6)
    file = tmp_path / "a.relations"
    file.write_text("# comment\n0.0 7.0 1 2 0 0 0 0.5\n\n")
    assert read_relations(file).tolist() == [[0.0, 7.0, 1.0, 2.0, 0.5]]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "holds no relations"),
        ("0 1 2\n", "line 1: expected 't1 t2 x y z roll pitch yaw'"),
        ("0 1 0 0 0 0 0 0\n0 1 0 0 0 0 0 nan\n", "line 2"),
        ("0 1 0 0 zero 0 0 0\n", "line 1"),
    ],
)
def test_foreign_files_are_told_with_the_line(tmp_path, text: str, says: str) -> None:
    file = tmp_path / "bad.relations"
    file.write_text(text)
    with pytest.raises(ValueError, match=says):
        read_relations(file)


def test_a_single_pose_answers_for_every_stamp() -> None:
    assert Pose2D.of(poses_at(np.array([[1.0, 2.0, 3.0, 0.5]]), np.array([9.0]))[0]) == Pose2D(2.0, 3.0, 0.5)
