"""Particles find a robot in a building, follow it, and do the same each time."""

from __future__ import annotations

import math

import numpy as np
import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_file import GridMap
from coursekit.nav.particle_filter import FilterParameters, ParticleFilter
from coursekit.nav.particle_map import ParticleMap
from coursekit.nav.particle_motion import move_differential, move_omni
from coursekit.nav.particle_resampling import clusters, draw
from coursekit.slam.scan import Laser
from tests.slam.building import Wheels, drawn, drive, look, office

LASER = Laser(-math.pi, math.radians(6), range_max=10.0)
WALLS = office(3)
WAY = [(3.0, 5.0), (20.5, 5.0), (20.5, 9.0)]
OFFICE = ParticleMap(drawn(WALLS))


def ends(pose: Pose2D, rng: np.random.Generator) -> np.ndarray:
    """Where the beams end, in the robot's frame."""
    ranges, angles = look(WALLS, pose, LASER, 60, rng), LASER.angles(60)
    seen = np.isfinite(ranges)
    return np.column_stack([ranges * np.cos(angles), ranges * np.sin(angles)])[seen]


def follow(pf: ParticleFilter, way: list[Pose2D], seed: int = 0, every: int = 3) -> np.ndarray:
    """The errors of position and heading on a way."""
    rng, wheels, before = np.random.default_rng(seed), Wheels(np.random.default_rng(seed)), None
    errors = []
    for number, truth in enumerate(way):
        rolled = np.array(wheels.roll(truth))
        if number % every:
            continue
        if before is not None:
            pf.move(before, rolled)
        pf.update(ends(truth, rng), LASER.range_max)
        before, at = rolled, pf.estimate().pose
        errors.append([math.hypot(at[0] - truth.x, at[1] - truth.y), abs(math.remainder(at[2] - truth.theta, math.tau))])
    return np.array(errors)


@pytest.mark.parametrize("seed", range(3))
def test_a_wrong_guess_is_mended_and_the_robot_followed(seed: int) -> None:
    way = list(drive(WAY))
    pf = ParticleFilter(OFFICE, FilterParameters(seed=seed))
    pf.start(np.array(way[0]) + np.array([0.5, -0.4, 0.25]), np.diag([0.25, 0.25, 0.07]))
    errors = follow(pf, way, seed)
    assert errors[0, 0] > 0.1
    assert np.median(errors[10:, 0]) < 0.1 and errors[10:, 0].max() < 0.25 and errors[10:, 1].max() < 0.1


@pytest.mark.parametrize("seed", range(3))
def test_a_robot_anywhere_is_found(seed: int) -> None:
    pf = ParticleFilter(OFFICE, FilterParameters(seed=seed))
    pf.start_anywhere()
    errors = follow(pf, list(drive([(14.0, 11.0), (3.0, 11.0), (3.0, 6.0)])), seed)
    assert errors[0, 0] > 1 and errors[-5:, 0].max() < 0.25 and pf.estimate().share > 0.9


def test_few_particles_are_enough_once_the_robot_is_found() -> None:
    pf = ParticleFilter(OFFICE)
    pf.start_anywhere()
    many = len(pf.particles)
    follow(pf, list(drive([(14.0, 11.0), (3.0, 11.0), (3.0, 6.0)])))
    assert 500 <= len(pf.particles) < many / 5


def test_a_robot_that_was_carried_away_is_found_again_when_recovery_is_on() -> None:
    pf = ParticleFilter(OFFICE, FilterParameters(recovery_alpha_slow=0.01, recovery_alpha_fast=0.3, max_particles=5000))
    pf.start(np.array([3.0, 5.0, 0.0]), np.diag([0.01, 0.01, 0.01]))
    follow(pf, list(drive([(3.0, 5.0), (8.0, 5.0)])))
    errors = follow(pf, list(drive([(20.5, 10.0), (20.5, 5.0), (3.0, 5.0), (3.0, 11.0), (15.0, 11.0)])), every=2)
    assert errors[-5:, 0].max() < 0.3


def test_the_same_seed_gives_the_same_particles() -> None:
    def end(seed: int) -> bytes:
        pf = ParticleFilter(OFFICE, FilterParameters(seed=seed))
        pf.start_anywhere()
        follow(pf, list(drive([(3.0, 5.0), (6.0, 5.0)])))
        return pf.particles.tobytes()

    assert end(1) == end(1) != end(2)


def test_scans_of_nothing_and_poses_outside_do_no_harm() -> None:
    pf = ParticleFilter(OFFICE)
    pf.start(np.array([1e6, -1e6, 0.0]), np.eye(3))
    pf.update(np.zeros((0, 2)), 10.0)
    pf.update(np.array([[1e9, 0.0], [1.0, 1.0]]), 10.0)
    assert np.isfinite(pf.estimate().pose).all()


@pytest.mark.parametrize("move", [move_differential, move_omni])
def test_without_noise_particles_move_as_the_wheels_do(move) -> None:
    before, after = Pose2D(1.0, 2.0, 0.5), Pose2D(0.4, 2.6, -1.0)
    start = Pose2D(-3.0, 4.0, 2.0)
    moved = move(np.array([start]), np.array(before), np.array(after), (0.0,) * 5, np.random.default_rng(0))
    assert np.allclose(moved[0], start @ before.to(after))


def test_the_noise_of_motion_has_the_size_that_the_alphas_say() -> None:
    rng, many = np.random.default_rng(0), np.zeros((20000, 3))
    straight = move_differential(many, np.zeros(3), np.array([2.0, 0.0, 0.0]), (0.0, 0.0, 0.2, 0.0, 0.0), rng)
    assert straight[:, 0].std() == pytest.approx(2 * math.sqrt(0.2), rel=0.03) and straight[:, 1].std() < 1e-9
    turned = move_differential(many, np.zeros(3), np.array([0.0, 0.0, 1.0]), (0.1, 0.0, 0.0, 0.0, 0.0), rng)
    assert turned[:, 2].std() == pytest.approx(math.sqrt(0.1), rel=0.03)
    back = move_differential(many, np.zeros(3), np.array([-1.0, 0.0, 0.0]), (0.5, 0.0, 0.0, 0.0, 0.0), rng)
    assert back[:, 2].std() < 1e-6 and np.allclose(back[:, 0], -1.0)


def test_particles_are_drawn_by_their_weight() -> None:
    particles = np.array([[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0]])
    chosen = draw(np.array([0.5, 0.5, 0.0]), particles, 4000, 5000, 0.05, 0.99, np.random.default_rng(0))
    counts = np.bincount(chosen, minlength=3) / len(chosen)
    assert counts[2] == 0 and counts[0] == pytest.approx(0.5, abs=0.03)


def test_clusters_are_what_hangs_together_also_across_the_half_turn() -> None:
    rng = np.random.default_rng(0)
    here = rng.normal(0, 0.2, (200, 3)) + np.array([0, 0, math.pi])
    there = rng.normal(0, 0.2, (100, 3)) + np.array([8, 0, 0])
    label = clusters(np.vstack([here, there]))
    assert len(set(label[:200])) == 1 and len(set(label[200:])) == 1 and label[0] != label[-1]


@pytest.mark.parametrize(("cells", "says"), [(np.zeros((5, 5)), "no walls"), (np.full((5, 5), 100), "no free floor")])
def test_maps_without_walls_or_floor_are_refused(cells: np.ndarray, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        ParticleMap(GridMap(cells.astype(np.int8), 0.05))


def test_parameters_that_cannot_work_are_refused() -> None:
    with pytest.raises(ValueError, match="min_particles 500, max_particles 100"):
        FilterParameters(max_particles=100)
