"""The grid is what a slow walk along every beam gives; it grows, and draws what it is told."""

from __future__ import annotations

import math

import numpy as np
import pytest

from coursekit.cli.slam import write_map
from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_cells import picture_of
from coursekit.slam.grid import OccupancyGrid
from coursekit.slam.keyframe import Keyframe
from coursekit.slam.map_drawing import MapDrawing
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Laser, Scan
from tests.slam.building import look, office, rectangle

PARAMS = SlamParameters(clear_no_return=2.0)
LASER = Laser(-math.pi, math.radians(1), range_max=6.0)


def scan_at(pose: Pose2D, seed: int = 0) -> Scan:
    """What is seen of the office."""
    rng = np.random.default_rng(seed)
    return Scan.from_ranges(look(office(3), pose, LASER, 360, rng), LASER, PARAMS)


def slow_grid(shots: list[tuple[Scan, Pose2D]]) -> dict[tuple[int, int], float]:
    """Log-odds by cell, written for clarity."""
    odds: dict[tuple[int, int], float] = {}
    r = PARAMS.resolution
    for scan, pose in shots:
        centre = pose @ scan.origin
        hits, misses = pose.transform(scan.hits), pose.transform(scan.misses)
        ends = {(math.floor(y / r), math.floor(x / r)) for x, y in hits}
        crossed = set()
        for x, y in [*hits, *misses]:
            steps = math.ceil(max(abs(x - centre.x), abs(y - centre.y)) / r)
            for k in range(steps):
                part = (k + 0.5) / steps
                a, b = centre.x + part * (x - centre.x), centre.y + part * (y - centre.y)
                crossed.add((math.floor(b / r), math.floor(a / r)))
        for cell in ends:
            odds[cell] = min(odds.get(cell, 0.0) + PARAMS.hit_odds, PARAMS.odds_limit)
        for cell in crossed - ends:
            odds[cell] = max(odds.get(cell, 0.0) + PARAMS.miss_odds, -PARAMS.odds_limit)
    return odds


def test_the_fast_grid_is_the_slow_one() -> None:
    poses = [Pose2D(3.0, 5.0, 0.3), Pose2D(3.21, 5.13, 0.9), Pose2D(8.0, 4.7, -2.0)]
    shots = [(scan_at(pose, k), pose) for k, pose in enumerate(poses * 4)]
    grid = OccupancyGrid(PARAMS)
    for scan, pose in shots:
        grid.insert(scan, pose)
    expected = np.zeros_like(grid.log_odds)
    row, column = (round(value / PARAMS.resolution) for value in reversed(grid.origin))
    for (i, j), value in slow_grid(shots).items():
        expected[i - row, j - column] = value
    # a beam through a corner of four cells may be rounded to either side
    assert (np.abs(expected - grid.log_odds) > 1e-4).mean() < 1e-4


def test_walls_are_walls_free_is_free_and_beyond_is_unknown() -> None:
    room = np.array(rectangle(-2.02, -1.52, 4.04, 3.04))
    grid = OccupancyGrid(PARAMS)
    laser = Laser(-math.pi, math.radians(0.5), range_max=10.0)
    ranges = look(room, Pose2D(), laser, 720, np.random.default_rng(0), noise=0.0)
    grid.insert(Scan.from_ranges(ranges, laser, PARAMS), Pose2D())
    assert grid.value_at(2.02, 0.3) > 65
    assert grid.value_at(0.5, 0.5) < 45
    assert grid.value_at(3.0, 0.0) == -1
    assert grid.value_at(1000.0, 0.0) == -1


def test_the_grid_grows_and_keeps_what_it_has() -> None:
    grid = OccupancyGrid(PARAMS)
    grid.insert(scan_at(Pose2D(3.0, 5.0, 0.0)), Pose2D(3.0, 5.0, 0.0))
    before = {p: grid.value_at(*p) for p in [(3.02 + 0.1 * k, 4.02 + 0.05 * k) for k in range(30)]}
    far = Pose2D(-60.0, -41.0, 0.0)
    grid.insert(scan_at(Pose2D(3.0, 5.0, 0.0)), far)
    assert {p: grid.value_at(*p) for p in before} == before
    assert grid.value_at(-59.5, -41.0) >= 0
    assert all(abs(value / grid.resolution - round(value / grid.resolution)) < 1e-6 for value in grid.origin)


def test_a_scan_from_the_end_of_the_world_is_left_out() -> None:
    grid = OccupancyGrid(PARAMS)
    grid.insert(scan_at(Pose2D(3.0, 5.0, 0.0)), Pose2D())
    cells = grid.log_odds.copy()
    grid.insert(scan_at(Pose2D(3.0, 5.0, 0.0)), Pose2D(1e6, 0.0, 0.0))
    assert np.array_equal(cells, grid.log_odds)


def test_drawing_adds_new_scans_and_redraws_when_poses_moved() -> None:
    poses = np.array([[3.0, 5.0, 0.0], [4.0, 5.0, 0.3], [5.0, 5.0, 0.1]])
    frames = [Keyframe(k, scan_at(Pose2D.of(pose), k)) for k, pose in enumerate(poses)]
    drawing = MapDrawing(PARAMS)
    first = drawing.draw(frames[:2], poses[:2])
    assert drawing.draw(frames, poses) is first
    moved = poses + np.array([0.5, 0.0, 0.0])
    again, whole = drawing.draw(frames, moved), OccupancyGrid(PARAMS)
    for frame, pose in zip(frames, moved, strict=True):
        whole.insert(frame.scan, Pose2D.of(pose))
    assert again is not first and np.array_equal(again.log_odds, whole.log_odds)


def test_a_written_map_is_nav2s(tmp_path) -> None:
    grid = OccupancyGrid(PARAMS)
    grid.insert(scan_at(Pose2D(3.0, 5.0, 0.0)), Pose2D(3.0, 5.0, 0.0))
    yaml, pgm = write_map(tmp_path / "office.yaml", grid)
    lines = dict(line.split(": ", 1) for line in yaml.read_text().splitlines())
    assert lines["image"] == "office.pgm" and lines["resolution"] == "0.05" and lines["negate"] == "0"
    assert lines["occupied_thresh"] == "0.65" and lines["free_thresh"] == "0.196"
    assert lines["origin"] == f"[{grid.origin[0]:.6g}, {grid.origin[1]:.6g}, 0]"
    magic, size, depth, data = pgm.read_bytes().split(b"\n", 3)
    rows, columns = grid.log_odds.shape
    assert (magic, size, depth) == (b"P5", f"{columns} {rows}".encode(), b"255")
    shades = np.frombuffer(data, np.uint8).reshape(rows, columns)
    drawn = picture_of(grid.trinary()[::-1], mode="trinary", occupied_thresh=0.65, free_thresh=0.196)
    assert set(np.unique(shades)) == {0, 205, 254} and np.array_equal(shades, drawn)
    i, j = np.argwhere(grid.cells() == grid.cells().max())[0]
    assert shades[rows - 1 - i, j] == 0


def test_an_empty_map_is_not_written(tmp_path) -> None:
    with pytest.raises(ValueError, match="the map is empty"):
        write_map(tmp_path / "empty.yaml", OccupancyGrid(PARAMS))
