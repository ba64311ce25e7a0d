"""A map made with a student's inverse sensor model."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from coursekit.grade.plain import called, number

if TYPE_CHECKING:
    import numpy as np

    from coursekit.nav.map_file import GridMap

CELL = 0.05
PLACES = [(0.0, 0.0), (2.4, -0.4), (4.2, 0.6), (3.6, 2.4), (2.2, 3.4), (0.6, 2.4)]
"""Positions in robot_world from which it is mapped."""


def added(model: Any, r: float, z: float) -> float:
    """Return the model's increment for a cell at r metres when a beam ended at z metres; Wrong when it is no number."""
    told = f"inverse_sensor_model({r:g}, {z:g})"
    return number(called(model, r, z, told=told), f"a finite number from {told}")


def mapped(model: Any, cut: Any, seed: int) -> GridMap:
    """Return the map of a world's cut, as seen from PLACES."""
    import numpy as np

    from coursekit.geometry.plane import Pose2D
    from coursekit.nav.map_file import GridMap
    from coursekit.sim import Lidar

    odds, corner, chance = np.zeros((160, 180)), (-2.0, -2.0, 0.0), np.random.default_rng(seed)
    lidar = Lidar(noise=0.01)
    for x, y in PLACES:
        place = Pose2D(x, y, 0.0)
        for k, z in enumerate(lidar.measure(lidar.look(cut, place), chance)):
            _add_beam(model, odds, (x - corner[0], y - corner[1]), k * lidar.step, float(z))
    return GridMap(np.where(odds > 0.4, 100, np.where(odds < -0.4, 0, -1)).astype(np.int8), CELL, corner)


def _add_beam(model: Any, odds: np.ndarray, start: tuple[float, float], angle: float, z: float) -> None:
    """Apply the model to each cell that a beam crosses, and to some cells behind its end."""
    c, s, seen = math.cos(angle), math.sin(angle), set()
    for step in range(int((min(z, 6.0) + 0.3) / 0.025)):
        at = (int((start[1] + step * 0.025 * s) // CELL), int((start[0] + step * 0.025 * c) // CELL))
        if at in seen or not (0 <= at[0] < odds.shape[0] and 0 <= at[1] < odds.shape[1]):
            continue
        seen.add(at)
        along = ((at[1] + 0.5) * CELL - start[0]) * c + ((at[0] + 0.5) * CELL - start[1]) * s
        odds[at] += added(model, along, z)
