"""Scans with known true poses and inaccurate guesses, for testing a scan matcher."""

from __future__ import annotations

import functools
import math
from pathlib import Path

import numpy as np

from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_compare import outline_points
from coursekit.sim import Cut, Lidar
from coursekit.sim.world_file import read_world, world_text
from coursekit.slam.wall_field import WallField

Pose = tuple[float, float, float]
CLEAR = 0.35
"""The minimum distance of a robot from walls [m]."""
HEIGHT = 0.2
"""The height of the LiDAR above the floor [m]."""


@functools.lru_cache(maxsize=8)
def _building(text: str, file: str) -> tuple[Pose2D, Cut, np.ndarray, WallField]:
    """Return a world's start, walls, wall points and distance field, from its file's text; cached for all puzzles."""
    world = read_world(text, file)
    cut = world.cut(HEIGHT)
    outline = outline_points(cut.edges, cut.circles)
    return world.start, cut, outline, WallField(outline)


class Puzzle:
    """One scan: `points` (n, 2) [m] in the robot's frame, `gap` to the true walls, `guess`, and `truth` [m, m, rad].

    The same `number` makes the same puzzle; the judge's numbers are random and secret.
    """

    def __init__(self, world: Path, number: int = 0, off: float = 0.3, turned: float = 0.15) -> None:
        start, cut, outline, self.gap = _building(world_text(world), str(world))
        chance = np.random.default_rng(800 + number)
        lidar = Lidar(range_max=6.0, noise=0.01)
        place = start
        while not self._good(lidar.look(cut, place)) or place == start:
            x, y = chance.uniform(outline.min(axis=0), outline.max(axis=0))
            place = Pose2D(round(float(x), 2), round(float(y), 2), round(float(chance.uniform(-3, 3)), 2))
        ranges = lidar.measure(lidar.look(cut, place), chance)
        angles = lidar.angle_min + lidar.step * np.arange(lidar.beams)
        hit = np.isfinite(ranges)
        self.points = np.column_stack([ranges[hit] * np.cos(angles[hit]), ranges[hit] * np.sin(angles[hit])])
        self.truth: Pose = (place.x, place.y, place.theta)
        far, way = chance.uniform(0.6, 0.95) * off, chance.uniform(-math.pi, math.pi)
        spin = chance.choice([-1, 1]) * chance.uniform(0.5, 0.95) * turned
        guess = (place.x + far * math.cos(way), place.y + far * math.sin(way), place.theta + spin)
        self.guess: Pose = (round(float(guess[0]), 2), round(float(guess[1]), 2), round(float(guess[2]), 2))

    def _good(self, ranges: np.ndarray) -> bool:
        """Whether a place is inside a room with enough clearance, where most beams hit different walls."""
        seen = np.isfinite(ranges)
        return bool(seen.mean() > 0.9 and ranges.min() > CLEAR)

    def misfit(self, pose: Pose) -> float:
        """Return the mean distance between the scan's points at a pose and the nearest walls [m]."""
        return float(self.gap(Pose2D(*pose).transform(self.points)).mean())
