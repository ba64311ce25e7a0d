"""The two-level search finds what looking at every pose finds; refinement ends on the walls."""

from __future__ import annotations

import math

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.slam.loop_field import LoopField
from coursekit.slam.matcher import correlate, match
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.refine import refine
from coursekit.slam.scan import Laser, Scan
from coursekit.slam.submap import Submap
from tests.slam.building import look, office

PARAMS = SlamParameters()
LASER = Laser(-math.pi, math.radians(1), range_max=12.0)
HERE = Pose2D(3.0, 5.0, 0.4)


def scan_at(pose: Pose2D, seed: int = 0, laser: Laser = LASER, walls: np.ndarray | None = None) -> Scan:
    """What is seen of the office."""
    rng = np.random.default_rng(seed)
    walls = office(3) if walls is None else walls
    return Scan.from_ranges(look(walls, pose, laser, 360, rng), laser, PARAMS)


@pytest.fixture(scope="module")
def submap() -> Submap:
    """The office as seen from one place."""
    new_submap = Submap(PARAMS)
    for k in range(4):
        new_submap.insert(scan_at(HERE @ Pose2D(0.1 * k, 0, 0), k), Pose2D(0.1 * k, 0.0, 0.0))
    return new_submap


def brute_force(
    points: np.ndarray,
    submap: Submap,
    guess: Pose2D,
    reach: int,
    angles: int,
    costs: tuple[float, float, float],
) -> float:
    """Highest score less its cost over all poses of the window."""
    best, (per_cell, per_step, most) = -1.0, costs
    field, cell = submap.likelihood, PARAMS.cell
    for a in range(-angles, angles + 1):
        moved = Pose2D(guess.x, guess.y, guess.theta + a * PARAMS.angle_step).transform(points)
        cells = np.floor((moved - submap.origin) / cell).astype(int)
        for i in range(-reach, reach + 1):
            for j in range(-reach, reach + 1):
                rows, columns = cells[:, 1] + i, cells[:, 0] + j
                inside = (rows >= 0) & (columns >= 0) & (rows < field.shape[0]) & (columns < field.shape[1])
                score = field[rows[inside], columns[inside]].sum() / 255 / len(points)
                best = max(best, score - min(per_cell * (i * i + j * j) + per_step * a * a, most))
    return best


@pytest.mark.parametrize("seed", range(6))
def test_best_first_search_finds_the_best_of_all_poses(submap: Submap, seed: int) -> None:
    rng = np.random.default_rng(seed)
    points = scan_at(HERE @ Pose2D.of(rng.normal(0, 0.2, 3)), seed + 10).points[:: rng.integers(3, 9)].copy()
    guess, costs = (
        Pose2D.of(rng.normal(0, [0.15, 0.15, 0.1])),
        (rng.uniform(0, 0.01), rng.uniform(0, 0.001), 0.15),
    )
    reach, angles = int(rng.integers(1, 7)), int(rng.integers(1, 8))
    x, y, theta, score = correlate(
        points, submap.likelihood, submap.coarse, submap.origin[0], submap.origin[1], PARAMS.cell,
        guess.x, guess.y, guess.theta, reach, angles, PARAMS.angle_step, costs[0], costs[1], costs[2],
    )  # fmt: skip
    i, j = round((y - guess.y) / PARAMS.cell), round((x - guess.x) / PARAMS.cell)
    a = round((theta - guess.theta) / PARAMS.angle_step)
    net = score - min(costs[0] * (i * i + j * j) + costs[1] * a * a, costs[2])
    assert math.isclose(net, brute_force(points, submap, guess, reach, angles, costs), abs_tol=1e-9)


def test_coarse_cells_bound_the_cells_below_them(submap: Submap) -> None:
    fine = submap.likelihood
    for i, j in zip(*np.nonzero(fine), strict=True):
        for a in (i // 4, max(i // 4 - 1, 0)):
            for b in (j // 4, max(j // 4 - 1, 0)):
                assert submap.coarse[a, b] >= fine[i, j]


@pytest.mark.parametrize("seed", range(5))
def test_matching_and_refinement_find_the_true_pose(submap: Submap, seed: int) -> None:
    rng = np.random.default_rng(seed)
    truth = Pose2D.of(rng.uniform(-0.25, 0.25, 3))
    points = scan_at(HERE @ truth, seed + 20).points
    rough, score = match(points, submap, Pose2D(), 0.3, math.radians(20), (0.3, 0.3))
    refined = refine(points, submap, rough, rough, np.zeros((3, 3)))
    assert score > 0.7 and refined.inliers > 0.7
    assert refined.pose.distance(truth) < 0.015 and abs(refined.pose.theta - truth.theta) < 0.005


def test_the_information_of_a_match_tells_its_scatter(submap: Submap) -> None:
    errors, predicted = [], []
    for seed in range(30):
        points = scan_at(HERE @ Pose2D(0.05, 0.02, 0.0), 100 + seed).points
        refined = refine(points, submap, Pose2D(0.05, 0.02, 0.0), Pose2D(), np.zeros((3, 3)))
        errors.append([refined.pose.x, refined.pose.y, refined.pose.theta])
        predicted.append(np.sqrt(np.diag(np.linalg.inv(refined.information))))
    ratio = np.std(errors, axis=0) / np.mean(predicted, axis=0)
    assert (ratio < 2).all() and (ratio > 0.05).all()


def test_a_bare_corridor_is_degenerate_and_the_guess_decides_along_it() -> None:
    corridor = np.array([[-50.0, -1.0, 50.0, -1.0], [-50.0, 1.0, 50.0, 1.0]])
    corridor_submap = Submap(PARAMS)
    corridor_submap.insert(scan_at(Pose2D(), walls=corridor), Pose2D())
    guess = Pose2D(0.12, 0.0, 0.0)
    points = scan_at(Pose2D(0.3, 0.05, 0.02), 1, walls=corridor).points
    rough, _ = match(points, corridor_submap, guess, 0.3, math.radians(20), (0.03, 0.03))
    refined = refine(points, corridor_submap, rough, guess, np.diag([1e3, 1e3, 1e3]))
    assert refined.degeneracy > 0.6
    assert abs(refined.pose.x - guess.x) < 0.05 and abs(refined.pose.y - 0.05) < 0.02
    room = Submap(PARAMS)
    room.insert(scan_at(HERE), Pose2D())
    assert refine(scan_at(HERE).points, room, Pose2D(), Pose2D(), np.zeros((3, 3))).degeneracy < 0.5


def test_a_loop_field_finds_a_scan_with_any_heading(submap: Submap) -> None:
    field = LoopField(submap.points[: submap.count], 0.1)
    truth = Pose2D(0.6, -0.4, 2.0)
    points = scan_at(HERE @ truth, 5).points
    pose, score = field.find(points[::3].copy(), Pose2D(), 2.0, math.pi, math.radians(1.2), 0.4)
    assert score > 0.6 and pose.distance(truth) < 0.2 and abs(pose.theta - truth.theta) < 0.05


def test_a_loop_field_agrees_with_looking_at_every_pose(submap: Submap) -> None:
    field = LoopField(submap.points[: submap.count], 0.1)
    points = scan_at(HERE @ Pose2D(0.2, 0.1, 0.05), 5).points[::9].copy()
    fine, best = field._fields[0], 0.0
    for a in range(-3, 4):
        cells = np.floor((Pose2D(0, 0, a * 0.02).transform(points) - field.origin) / 0.1).astype(int)
        for i in range(-9, 10):
            for j in range(-9, 10):
                rows, columns = cells[:, 1] + i, cells[:, 0] + j
                inside = (rows >= 0) & (columns >= 0) & (rows < fine.shape[0]) & (columns < fine.shape[1])
                best = max(best, fine[rows[inside], columns[inside]].sum() / 255 / len(points))
    assert math.isclose(field.find(points, Pose2D(), 0.9, 0.06, 0.02, 0.1)[1], best, abs_tol=1e-9)


def test_nothing_to_match_leaves_the_guess() -> None:
    empty, guess = Submap(PARAMS), Pose2D(1.0, 2.0, 0.3)
    points = scan_at(HERE).points
    assert match(points, empty, guess, 0.3, 0.3, (0.1, 0.1)) == (guess, 0.0)
    assert match(np.zeros((0, 2)), empty, guess, 0.3, 0.3, (0.1, 0.1)) == (guess, 0.0)
    assert refine(points, empty, guess, guess, np.zeros((3, 3))).pose == guess


def test_merged_points_are_averaged_and_a_restored_submap_is_the_same(submap: Submap) -> None:
    seen = sum(len(scan_at(HERE @ Pose2D(0.1 * k, 0, 0), k).points) for k in range(4))
    assert submap.count < 0.75 * seen
    copy = Submap(PARAMS)
    for k in range(4):
        copy.insert(scan_at(HERE @ Pose2D(0.1 * k, 0, 0), k), Pose2D(0.1 * k, 0.0, 0.0))
    copy.finish()
    assert not copy.nearest.size
    copy.restore()
    assert np.array_equal(copy.points[: copy.count], submap.points[: submap.count])
    refined = refine(scan_at(HERE).points, copy, Pose2D(), Pose2D(), np.zeros((3, 3)))
    assert refined.pose.distance(Pose2D()) < 0.01
