"""What the checks of chapter 8 say is wrong with a ray, a sensor model and a pose."""

import math

import numpy as np
import pytest

from coursekit.grade.chapters.measures.matches import why_pose
from coursekit.grade.checking import judge
from coursekit.grade.exercise import find
from tests.grade.tried import told_of


def distance(walls, x, y, angle, range_max=10.0):
    """As numpy's functions give it."""
    c, s, distances = math.cos(angle), math.sin(angle), [np.float64(math.inf)]
    for x1, y1, x2, y2 in walls:
        across = c * (y2 - y1) - s * (x2 - x1)
        if abs(across) > 1e-12:
            t = ((x1 - x) * (y2 - y1) - (y1 - y) * (x2 - x1)) / across
            part = ((x1 - x) * s - (y1 - y) * c) / across
            distances += [np.float64(t)] if 0 <= t <= range_max and 0 <= part <= 1 else []
    return np.min(distances)


def test_a_ray_that_ends_nowhere_may_say_so_with_numpys_infinity(tmp_path):
    assert judge(find("ch08.q2"), {"cast_ray": distance}, tmp_path).passed


@pytest.mark.parametrize(
    ("cast", "cause"),
    [
        (lambda walls, x, y, angle, *most: distance(walls, x, y, math.radians(angle), *most), "radians already"),
        (lambda walls, x, y, angle, range_max=10.0: min(distance(walls, x, y, angle, 99.0), range_max), "`math.inf`"),
        (lambda walls, x, y, angle, *most: None, "return"),
        (lambda walls, x, y, angle, range_max=10.0: distance(walls, x, y, angle), "further than range_max"),
        (lambda walls, x, y, angle, *most: -math.inf, "divided by zero"),
    ],
)
def test_a_ray_s_fault_is_named(tmp_path, cast, cause):
    assert cause in told_of("ch08.q2", {"cast_ray": cast}, tmp_path).cause


def test_a_ray_along_a_wall_divides_by_nothing(tmp_path):
    def unguarded(walls, x, y, angle, range_max=10.0):
        (x1, y1, x2, y2), c, s = walls[0], math.cos(angle), math.sin(angle)
        t = ((x1 - x) * (y2 - y1) - (y1 - y) * (x2 - x1)) / (c * (y2 - y1) - s * (x2 - x1))
        part = ((x1 - x) * s - (y1 - y) * c) / (c * (y2 - y1) - s * (x2 - x1))
        return t if 0 <= t <= range_max and 0 <= part <= 1 else math.inf

    assert "ZeroDivisionError" in told_of("ch08.q2", {"cast_ray": unguarded}, tmp_path).got


def model(r, z):
    return -0.4 if r < z - 0.04 else 0.85 if r < z + 0.04 else 0.0


def test_one_number_may_be_numpys_array_of_none_dimensions(tmp_path):
    assert judge(find("ch08.q1"), {"inverse_sensor_model": lambda r, z: np.array(model(r, z))}, tmp_path).passed


@pytest.mark.parametrize(
    ("wrong", "cause"),
    [
        (lambda r, z: 0.85 if r == z else -0.4 if r < z else 0.0, "Walls get lost"),
        (lambda r, z: (model(r, z), z), "One number is asked for"),
        (lambda r, z: np.array([model(r, z), z]), "One number is asked for"),
        (lambda r, z: f"{model(r, z)}", "That is a text"),
    ],
)
def test_a_sensor_model_s_fault_is_named(tmp_path, wrong, cause):
    assert cause in told_of("ch08.q1", {"inverse_sensor_model": wrong}, tmp_path).cause


@pytest.mark.parametrize(
    ("off", "turned", "moved", "cause"),
    [
        (0.28, 0.1, 0.0, "where the guess was"),
        (0.6, 0.1, 0.5, "further off than the guess"),
        (0.01, 1.2, 0.2, "in radians"),
        (0.25, 0.1, 0.1, "0.3 m and 0.15 rad around"),
        (0.05, 0.0, 0.2, "finer steps"),
    ],
)
def test_a_pose_s_fault_is_named(off, turned, moved, cause):
    assert cause in why_pose(off, turned, moved)
