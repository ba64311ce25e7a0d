"""Grid update and scan matching, by ours, numpy and OpenCV in one run; prints JSON (microseconds)."""

import json
import math
import sys
import timeit
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np

from coursekit.geometry.plane import Pose2D, rotation
from coursekit.slam.grid import OccupancyGrid
from coursekit.slam.matcher import match, sample
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.refine import refine
from coursekit.slam.scan import Laser, Scan
from coursekit.slam.submap import Submap

sys.path.insert(0, str(Path(__file__).parents[2]))  # it is run from a folder where nothing is found by accident
from tests.slam.building import look, office

PARAMS = SlamParameters()
LASER = Laser(-math.pi, math.radians(1), range_max=12.0)
HERE, GUESS = Pose2D(3.0, 5.0, 0.4), Pose2D(0.1, -0.1, 0.1)
DISTANCE, ANGLE = 0.3, math.radians(20)
CELL = PARAMS.cell


def best(function: Callable[[], object]) -> float:
    """The time of one call [µs]."""
    timer = timeit.Timer(function)
    count = max(1, timer.autorange()[0] // 4)
    return min(timer.repeat(5, count)) / count * 1e6


def seen(pose: Pose2D, seed: int) -> Scan:
    """A scan of the office."""
    ranges = look(office(3), pose, LASER, 360, np.random.default_rng(seed))
    return Scan.from_ranges(ranges, LASER, PARAMS)


def numpy_grid(scan: Scan, grid: np.ndarray, corner: np.ndarray) -> None:
    """The same update with arrays: cells of all beams at once."""
    ends = (scan.hits - corner) / CELL
    start = (np.zeros(2) - corner) / CELL
    steps = int(np.ceil(np.abs(ends - start).max()))
    parts = np.arange(steps) / steps
    cells = (start + parts[:, None, None] * (ends - start)).reshape(-1, 2).astype(int)
    free = np.zeros(grid.shape, dtype=bool)
    free[cells[:, 1], cells[:, 0]] = True
    last = ends.astype(int)
    free[last[:, 1], last[:, 0]] = False
    grid[free] = np.maximum(grid[free] + PARAMS.miss_odds, -PARAMS.odds_limit)
    walls = np.zeros(grid.shape, dtype=bool)
    walls[last[:, 1], last[:, 0]] = True
    grid[walls] = np.minimum(grid[walls] + PARAMS.hit_odds, PARAMS.odds_limit)


def opencv_grid(scan: Scan, grid: np.ndarray, corner: np.ndarray) -> None:
    """The same with a filled polygon."""
    ends = ((scan.hits - corner) / CELL).astype(np.int32)
    mask = np.zeros(grid.shape, dtype=np.uint8)
    cv2.fillPoly(mask, [ends.reshape(-1, 1, 2)], 1)
    mask[ends[:, 1], ends[:, 0]] = 2
    cv2.add(grid, PARAMS.miss_odds, grid, mask=(mask == 1).astype(np.uint8))
    cv2.add(grid, PARAMS.hit_odds, grid, mask=(mask == 2).astype(np.uint8))
    np.clip(grid, -PARAMS.odds_limit, PARAMS.odds_limit, out=grid)


def numpy_match(points: np.ndarray, submap: Submap) -> float:
    """The best score of all poses of the window."""
    reach, steps, top = round(DISTANCE / CELL), round(ANGLE / PARAMS.angle_step), 0.0
    shifts = np.stack(np.meshgrid(*[np.arange(-reach, reach + 1)] * 2), axis=-1).reshape(-1, 1, 2)
    for step in range(-steps, steps + 1):
        moved = points @ rotation(GUESS.theta + step * PARAMS.angle_step).T + np.array([GUESS.x, GUESS.y])
        cells = ((moved - submap.origin) / CELL).astype(int)[None] + shifts
        top = max(top, float(submap.likelihood[cells[..., 1], cells[..., 0]].sum(axis=1).max()))
    return top


def opencv_match(points: np.ndarray, submap: Submap) -> float:
    """The same by correlation of pictures, one for each angle."""
    reach, steps, top = round(DISTANCE / CELL), round(ANGLE / PARAMS.angle_step), 0.0
    field = submap.likelihood
    for step in range(-steps, steps + 1):
        moved = points @ rotation(GUESS.theta + step * PARAMS.angle_step).T + np.array([GUESS.x, GUESS.y])
        cells = ((moved - submap.origin) / CELL).astype(int)
        low, high = cells.min(axis=0), cells.max(axis=0)
        shape = np.zeros((high - low + 1)[::-1], dtype=np.uint8)
        shape[cells[:, 1] - low[1], cells[:, 0] - low[0]] = 1
        (x1, y1), (x2, y2) = np.maximum(low - reach, 0), high + reach + 1
        top = max(top, float(cv2.matchTemplate(field[y1:y2, x1:x2], shape, cv2.TM_CCORR).max()))
    return top


def main() -> None:
    """Measure and print."""
    scan, submap = seen(HERE, 0), Submap(PARAMS)
    for k in range(4):
        submap.insert(seen(HERE @ Pose2D(0.1 * k, 0.0, 0.0), k), Pose2D(0.1 * k, 0.0, 0.0))
    grid, size = OccupancyGrid(PARAMS), np.full(2, 13.0)
    plain = np.zeros((520, 520), dtype=np.float32)
    points = seen(HERE, 9).points
    few, sigmas = sample(points, 120), (0.3, 0.3)
    result = {
        "grid update, 360 beams at 5 cm": {
            "ours": best(lambda: grid.insert(scan, Pose2D())),
            "numpy": best(lambda: numpy_grid(scan, plain, -size)),
            "OpenCV": best(lambda: opencv_grid(scan, plain, -size)),
            "goal": "≤ 75 µs",
        },
        "matching ±0.3 m ±20°": {
            "ours": best(lambda: match(points, submap, GUESS, DISTANCE, ANGLE, sigmas)),
            "numpy": best(lambda: numpy_match(few, submap)),
            "OpenCV": best(lambda: opencv_match(few, submap)),
            "goal": "≤ 150 µs",
        },
        "refinement of a match": {
            "ours": best(lambda: refine(points, submap, Pose2D(0.02, 0.01, 0.01), Pose2D(), np.zeros((3, 3)))),
            "numpy": None,
            "OpenCV": None,
            "goal": "",
        },
    }
    print(json.dumps(result))


if __name__ == "__main__":
    main()
