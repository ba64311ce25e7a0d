"""Worlds from occupancy grids."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from coursekit.geometry.plane import Pose2D
from coursekit.sim import Disc, Lidar, RobotModel, Simulation, WorldError
from coursekit.sim.world_map import world_from_grid


def test_cells_become_walls_of_their_size_at_their_place():
    grid = np.zeros((20, 30), np.int8)
    grid[0], grid[-1], grid[:, 0], grid[:, -1] = 100, 100, 100, 100
    world = world_from_grid(grid, 0.1, (-1.0, -1.0, 0.0))
    seen = Lidar(beams=4, angle_max=1.5 * math.pi).look(world.cut(0.2), Pose2D(0.0, 0.0))
    assert seen.tolist() == pytest.approx([1.9, 0.9, 0.9, 0.9])
    assert len(world.thing("map").parts) == 4


def test_unknown_and_free_cells_are_no_walls_and_a_robot_begins_in_the_open():
    grid = np.full((40, 40), -1, np.int8)
    grid[5:35, 5:35] = 0
    grid[5:35, 20] = 100
    world = world_from_grid(grid, 0.1)
    Simulation(world).spawn(RobotModel("r", (Disc(0.0, 0.0, 0.3),)))
    assert grid[int(world.start.y / 0.1), int(world.start.x / 0.1)] == 0


@settings(max_examples=40, deadline=None, derandomize=True)
@given(arrays(np.int8, st.tuples(st.integers(1, 12), st.integers(1, 12)), elements=st.sampled_from([-1, 0, 100])))
def test_blocks_cover_each_occupied_cell_once(grid):
    world = world_from_grid(grid, 1.0)
    covered = np.zeros(grid.shape, int)
    for thing in world.things:
        for part in thing.parts:
            (x0, y0), (x1, y1) = np.min(part.points, axis=0).astype(int), np.max(part.points, axis=0).astype(int)
            covered[y0:y1, x0:x1] += 1
    assert np.array_equal(covered, (grid == 100).astype(int))


def test_what_is_no_grid_is_refused():
    for cells, size in ((np.zeros(3, np.int8), 0.1), (np.zeros((2, 2), np.int8), 0.0)):
        with pytest.raises(WorldError, match="is no grid"):
            world_from_grid(cells, size)
