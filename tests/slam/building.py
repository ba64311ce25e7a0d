"""A building of straight walls, a laser that sees it, and a robot that drives through it with drifting odometry."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_file import GridMap
from coursekit.slam.scan import Laser


def rectangle(x: float, y: float, width: float, height: float) -> list[list[float]]:
    """Four walls."""
    a, b = x + width, y + height
    return [[x, y, a, y], [a, y, a, b], [a, b, x, b], [x, b, x, y]]


def office(seed: int = 0) -> np.ndarray:
    """(n, 4) walls: a ring of corridors around a core, with offices of different width outside and furniture in them."""
    rng = np.random.default_rng(seed)
    walls = rectangle(0, 0, 24, 16) + rectangle(6, 6, 12, 4)
    for y, room in ((3.5, 0.0), (12.5, 16.0)):
        x = 0.0
        while x < 24:
            width = rng.uniform(2.5, 4.5)
            door = x + rng.uniform(0.4, width - 1.4)
            walls.append([x, y, min(door, 24), y])
            walls.append([min(door + 0.9, 24), y, min(x + width, 24), y])
            walls.append([min(x + width, 24), y, min(x + width, 24), room])
            x += width
    for _ in range(40):
        x, y = rng.uniform(0.5, 23), rng.choice([rng.uniform(0.3, 2.5), rng.uniform(13.2, 15.4)])
        walls += rectangle(x, y, rng.uniform(0.2, 0.6), rng.uniform(0.2, 0.6))
    for _ in range(12):  # cupboards and pillars of the corridors
        side = rng.integers(4)
        x, y = (
            (rng.uniform(1, 22), 3.5),
            (rng.uniform(1, 22), 12.2),
            (0.0, rng.uniform(4, 11)),
            (23.7, rng.uniform(4, 11)),
        )[side]
        walls += rectangle(x, y, 0.3, 0.3)
    return np.array(walls)


def cast(walls: np.ndarray, origin: Pose2D, angles: np.ndarray) -> np.ndarray:
    """(n,) exact distances to the nearest wall in each direction [rad, the world's]; inf where there is none."""
    dx, dy = np.cos(angles)[:, None], np.sin(angles)[:, None]
    ex, ey = walls[:, 2] - walls[:, 0], walls[:, 3] - walls[:, 1]
    ax, ay = walls[:, 0] - origin.x, walls[:, 1] - origin.y
    cross = dx * ey - dy * ex
    with np.errstate(divide="ignore", invalid="ignore"):
        away = (ax * ey - ay * ex) / cross
        part = (ax * dy - ay * dx) / cross
    hit = (np.abs(cross) > 1e-12) & (away > 0) & (part >= 0) & (part <= 1)
    return np.where(hit, away, np.inf).min(axis=1)


def drawn(walls: np.ndarray, cell: float = 0.05) -> GridMap:
    """Walls as a map: cells that a wall runs through."""
    size = (np.ceil(walls[:, [1, 3]].max() / cell) + 20, np.ceil(walls[:, [0, 2]].max() / cell) + 20)
    cells = np.zeros([int(length) for length in size], dtype=np.int8)
    for x1, y1, x2, y2 in walls:
        parts = np.linspace(0, 1, 2 + int(math.hypot(x2 - x1, y2 - y1) / cell * 3))
        columns, rows = ((a + parts * (b - a)) / cell + 10 for a, b in ((x1, x2), (y1, y2)))
        cells[rows.astype(int), columns.astype(int)] = 100
    return GridMap(cells, cell, (-10 * cell, -10 * cell, 0.0))


def look(
    walls: np.ndarray, robot: Pose2D, laser: Laser, beams: int, rng: np.random.Generator, noise: float = 0.01
) -> np.ndarray:
    """Ranges of one scan; inf beyond the laser's reach."""
    seat = robot @ laser.offset
    ranges = cast(walls, seat, seat.theta + laser.angles(beams)) + rng.normal(0, noise, beams)
    return np.where(ranges < laser.range_max, ranges, np.inf)


def drive(corners: list[tuple[float, float]], step: float = 0.1, turn: float = 0.15) -> Iterator[Pose2D]:
    """Poses along a way from corner to corner, turning on the spot."""
    (x, y), heading = corners[0], None
    for a, b in corners[1:]:
        goal = math.atan2(b - y, a - x)
        if heading is not None:
            change = (goal - heading + math.pi) % (2 * math.pi) - math.pi
            for k in range(1, int(abs(change) / turn) + 1):
                yield Pose2D.of((x, y, heading + k * math.copysign(turn, change)))
        length = math.hypot(a - x, b - y)
        for k in range(int(length / step)):
            yield Pose2D.of((x + k * step * math.cos(goal), y + k * step * math.sin(goal), goal))
        (x, y), heading = (a, b), goal


ROUND = [(3.0, 5.0), (20.5, 5.0), (20.5, 11.0), (3.0, 11.0), (3.0, 5.0), (20.0, 5.0), (20.5, 9.0)]
"""Once around the core of the office, and on."""


class Wheels:
    """Odometry that drifts: wrong scale, a pull to one side, and noise."""

    def __init__(
        self, rng: np.random.Generator, scale: float = 1.03, pull: float = 0.02, noise: float = 0.05
    ) -> None:
        self.pose = Pose2D()
        self._rng, self._scale, self._pull, self._noise = rng, scale, pull, noise
        self._last: Pose2D | None = None

    def roll(self, truth: Pose2D) -> Pose2D:
        """The odometry once the robot has come to `truth`."""
        if self._last is not None:
            motion = self._last.to(truth)
            way, turn = math.hypot(motion.x, motion.y), abs(motion.theta)
            noise = self._rng.normal(0, self._noise, 3) * np.array([way, way / 2, turn + 0.1 * way])
            self.pose = self.pose @ Pose2D(
                motion.x * self._scale + noise[0],
                motion.y + noise[1],
                motion.theta + self._pull * way + noise[2],
            )
        self._last = truth
        return self.pose
