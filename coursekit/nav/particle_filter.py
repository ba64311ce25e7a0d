"""Adaptive Monte Carlo localisation: particles move with the odometry and are weighted by the likelihood of the scans."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coursekit.geometry.plane import wrap
from coursekit.nav.particle_kernels import scan_likelihoods
from coursekit.nav.particle_map import ParticleMap
from coursekit.nav.particle_motion import move_differential, move_omni
from coursekit.nav.particle_resampling import clusters, draw

CROWD = 10
"""Factor for `max_particles` while the robot may be anywhere; dropped for good once fewer particles suffice."""
SEEDS, SHARP = 10, 4
"""Factor for the number of poses from which the first scan then chooses, and the exponent of their likelihood."""


@dataclass(frozen=True)
class FilterParameters:
    """The parameters of nav2's amcl, with its names and defaults."""

    min_particles: int = 500
    max_particles: int = 2000
    pf_err: float = 0.05
    pf_z: float = 0.99
    alphas: tuple[float, ...] = (0.2, 0.2, 0.2, 0.2, 0.2)
    omni: bool = False
    z_hit: float = 0.5
    z_rand: float = 0.5
    sigma_hit: float = 0.2
    recovery_alpha_slow: float = 0.0
    recovery_alpha_fast: float = 0.0
    resample_interval: int = 1
    seed: int = 0

    def __post_init__(self) -> None:
        """Reject invalid values."""
        if not 0 < self.min_particles <= self.max_particles:
            raise ValueError(f"min_particles {self.min_particles}, max_particles {self.max_particles}: 0 < min <= max")
        for name in ("pf_err", "sigma_hit", "resample_interval"):
            if not getattr(self, name) > 0:
                raise ValueError(f"{name} must be above 0, not {getattr(self, name)}")


@dataclass(frozen=True)
class Estimate:
    """Mean and covariance of the heaviest cluster, and its share of the total weight."""

    pose: np.ndarray
    covariance: np.ndarray
    share: float


class ParticleFilter:
    """The particle filter. In ROS 2: the core of nav2_amcl.

    >>> from coursekit.nav.map_file import GridMap
    >>> cells = np.zeros((60, 80), np.int8)
    >>> cells[0] = cells[:, 0] = 100  # two walls: along y = 0 and along x = 0
    >>> amcl = ParticleFilter(ParticleMap(GridMap(cells, 0.05)), FilterParameters(seed=1))
    >>> amcl.start(np.array([1.2, 1.6, 0.0]), np.diag([0.04, 0.04, 0.01]))  # in truth it is at (1.0, 1.5)
    >>> along = np.linspace(-0.9, 2.0, 60)
    >>> ends = np.concatenate([np.column_stack([along, along * 0 - 1.475]), np.column_stack([along * 0 - 0.975, along])])
    >>> for _ in range(20):
    ...     _ = amcl.update(ends, 10.0)
    >>> amcl.estimate().pose[:2].round(1).tolist()
    [1.0, 1.5]
    """

    def __init__(self, where: ParticleMap, params: FilterParameters | None = None) -> None:
        self.map, self.params = where, params or FilterParameters()
        self._rng = np.random.default_rng(self.params.seed)
        self._slow = self._fast = 0.0
        self._updates = 0
        self.start(np.zeros(3), np.diag([0.25, 0.25, 0.07]))

    def start(self, pose: np.ndarray, covariance: np.ndarray) -> None:
        """Scatter the particles around a pose [m, m, rad]."""
        values, axes = np.linalg.eigh(0.5 * (covariance + covariance.T))
        scatter = self._rng.normal(size=(self.params.max_particles, 3)) * np.sqrt(np.maximum(values, 0.0))
        self._set(np.asarray(pose, float) + scatter @ axes.T)
        self._most, self._seeds = self.params.max_particles, 0

    def start_anywhere(self) -> None:
        """Scatter the particles over all free floor."""
        self._most = CROWD * self.params.max_particles
        self._seeds = SEEDS * self._most
        self._set(self.map.anywhere(self._most, self._rng))

    def _set(self, particles: np.ndarray) -> None:
        particles[:, 2] = wrap(particles[:, 2])
        self.particles, self.weights = particles, np.full(len(particles), 1 / len(particles))
        self._slow = self._fast = 0.0
        self._updates = 0

    def move(self, before: np.ndarray, after: np.ndarray) -> None:
        """Move the particles by the odometry's motion from one pose to another.

        >>> from coursekit.nav.map_file import GridMap
        >>> where = ParticleMap(GridMap(np.array([[0, 100]], np.int8), 0.5))
        >>> amcl = ParticleFilter(where, FilterParameters(alphas=(0.0,) * 5))  # no noise
        >>> amcl.start(np.array([1.0, 1.0, np.pi / 2]), np.zeros((3, 3)))
        >>> amcl.move(np.array([0.0, 0.0, 0.0]), np.array([0.5, 0.0, 0.0]))  # half a metre ahead
        >>> amcl.particles[0].round(3).tolist()
        [1.0, 1.5, 1.571]
        """
        kind = move_omni if self.params.omni else move_differential
        self.particles = kind(self.particles, before, after, self.params.alphas, self._rng)

    def update(self, ends: np.ndarray, range_max: float) -> bool:
        """Weight the particles by a scan, its ends (m, 2) in the robot's frame; return whether they were resampled."""
        p = self.params
        if self._seeds and len(ends):
            self._choose_seeds(ends, range_max)
        likely = self._likelihoods(self.particles, ends, range_max)
        self._remember(float((self.weights * likely).sum()))
        self.weights = self.weights * likely
        self.weights /= self.weights.sum()
        self._updates += 1
        if self._updates % p.resample_interval:
            return False
        self._resample()
        return True

    def _likelihoods(self, particles: np.ndarray, ends: np.ndarray, range_max: float) -> np.ndarray:
        """Return (n,) the likelihood of a scan for each particle."""
        p, m = self.params, self.map
        likelihoods: np.ndarray = scan_likelihoods(
            particles, np.ascontiguousarray(ends, dtype=np.float64), m.distances, m.x, m.y, m.cell, m.farthest,
            p.z_hit, p.z_rand, p.sigma_hit, range_max,
        )  # fmt: skip
        return likelihoods

    def _choose_seeds(self, ends: np.ndarray, range_max: float) -> None:
        """Start with the poses that best explain the first scan, out of very many."""
        seeds, self._seeds = self.map.anywhere(self._seeds, self._rng), 0
        total = np.cumsum(self._likelihoods(seeds, ends, range_max) ** SHARP)
        chosen = np.searchsorted(total, self._rng.random(self._most) * total[-1]).clip(0, len(seeds) - 1)
        self.particles = seeds[chosen]
        self.weights = np.full(len(chosen), 1 / len(chosen))

    def _remember(self, average: float) -> None:
        """Update the slow and fast averages of the scan likelihood."""
        p = self.params
        self._slow = average if self._slow == 0.0 else self._slow + p.recovery_alpha_slow * (average - self._slow)
        self._fast = average if self._fast == 0.0 else self._fast + p.recovery_alpha_fast * (average - self._fast)

    def _resample(self) -> None:
        """Resample particles by weight; when the scan likelihood has dropped, some from anywhere."""
        p = self.params
        lost = max(0.0, 1.0 - self._fast / self._slow) if self._slow > 0 else 0.0
        chosen = draw(self.weights, self.particles, p.min_particles, self._most, p.pf_err, p.pf_z, self._rng)
        self._most = max(len(chosen), p.max_particles)
        self.particles = self.particles[chosen]
        strays = self._rng.random(len(chosen)) < lost
        if strays.any():
            self.particles[strays] = self.map.anywhere(int(strays.sum()), self._rng)
            self._slow = self._fast = 0.0
        self.weights = np.full(len(chosen), 1 / len(chosen))

    def estimate(self) -> Estimate:
        """Return the heaviest cluster."""
        label = clusters(self.particles)
        weight = np.bincount(label, self.weights)
        inside = label == int(weight.argmax())
        share = float(weight.max())
        return mean_of(self.particles[inside], self.weights[inside], share)


def mean_of(particles: np.ndarray, weights: np.ndarray, share: float = 1.0) -> Estimate:
    """Return weighted mean and covariance; headings are averaged on the circle.

    >>> mean_of(np.array([[0.0, 0.0, 3.1], [2.0, 0.0, -3.1]]), np.array([1.0, 1.0])).pose.round(2).tolist()
    [1.0, 0.0, -3.14]
    """
    part = weights / weights.sum()
    heading = math.atan2(float(part @ np.sin(particles[:, 2])), float(part @ np.cos(particles[:, 2])))
    pose = np.array([*(part @ particles[:, :2]), wrap(np.array(heading))])
    off = np.column_stack([particles[:, :2] - pose[:2], wrap(particles[:, 2] - heading)])
    return Estimate(pose, (off * part[:, None]).T @ off, share)
