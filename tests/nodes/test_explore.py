"""explore_lite with nav2 and slam_toolbox in a room that nobody has seen, on the virtual clock."""

import numpy as np
import pytest
from nav_msgs.msg import OccupancyGrid
from scipy import ndimage
from visualization_msgs.msg import MarkerArray

from coursekit.cli.parser import run as run_cli
from coursekit.nodes.nav2.map_message import MAP_QOS, from_message
from tests.nodes.nav2_stage import ROBOT, Stage


@pytest.mark.slow
@pytest.mark.timeout(400)
def test_it_goes_on_until_the_room_is_seen(session, tmp_path):
    stage = Stage(session, tmp_path, "robot_world", ROBOT, "slam:=True")
    maps: list[OccupancyGrid] = []
    shown: list[MarkerArray] = []
    stage.node.create_subscription(OccupancyGrid, "map", lambda msg: (maps.clear(), maps.append(msg)), MAP_QOS)
    stage.node.create_subscription(MarkerArray, "explore/frontiers", shown.append, 10)
    words = ["launch", "explore_lite", "explore.launch.py"]
    process = session.start(lambda: run_cli(words), name="ros2", argv=words)
    for _ in range(60):
        stage.spin(5.0)
        if "Exploration stopped." in process.output:
            break
    assert "Connected to move_base nav2 server" in process.output and "stopping." in process.output
    assert seen(stage.map, from_message(maps[-1])) > 0.95
    assert shown[0].markers and not stage.touched
    stage.close()


def seen(truth, made):
    """Which part of the floor the map shows as free; walls are a cell thick."""
    floor = ndimage.binary_erosion(truth.cells == 0, iterations=2)
    rows, columns = np.nonzero(floor)
    x, y = (columns + 0.5) * truth.resolution + truth.origin[0], (rows + 0.5) * truth.resolution + truth.origin[1]
    i, j = ((y - made.origin[1]) / made.resolution).astype(int), ((x - made.origin[0]) / made.resolution).astype(int)
    inside = (i >= 0) & (j >= 0) & (i < made.cells.shape[0]) & (j < made.cells.shape[1])
    return (made.cells[i[inside], j[inside]] == 0).sum() / len(rows)


def test_a_frequency_that_cannot_be_is_said(run):
    explore = run("explore_lite", "explore", "--ros-args", "-p", "planner_frequency:=0.0")
    assert explore.wait(2) == -6
    assert "what():  planner_frequency is 0.0: give Hz, for example 0.25" in explore.output
