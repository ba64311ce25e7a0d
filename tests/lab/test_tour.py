"""Driving along points and looking at maps, on the virtual clock."""

import math
from pathlib import Path

import numpy as np
import pytest
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid
from tf2_ros import StaticTransformBroadcaster

from coursekit.cli.parser import run as run_cli
from coursekit.lab.map_view import map_view
from coursekit.lab.panel_node import HiddenNode
from coursekit.lab.tour import drive_along
from coursekit.nav.map_file import GridMap, save_map
from coursekit.processes.executables import find
from coursekit.processes.patching import patch_manager
from coursekit.processes.session import Session

CART = Path(__file__).parents[2] / "robots" / "urdf" / "robot_lidar.urdf"


@pytest.fixture
def session(monkeypatch):
    monkeypatch.setenv("ROS_DOMAIN_ID", "0")
    with Session(virtual=True).use() as virtual_session:
        patch_manager.renew()
        yield virtual_session


def start(session, package, executable, *argv):
    return session.start_executable(find(package, executable), argv, name=executable)


@pytest.fixture
def cart(session):
    """A cart in robot_world, with slam_toolbox."""
    start(session, "gazebo_ros", "gzserver", "robot_world")
    start(session, "robot_state_publisher", "robot_state_publisher", str(CART), "--ros-args", "-p", "use_sim_time:=true")
    start(session, "gazebo_ros", "spawn_entity.py", "-entity", "cart", "-file", str(CART), "-x", "0.5").wait(20.0)
    argv = ["launch", "slam_toolbox", "online_async_launch.py"]
    session.start(lambda: run_cli(argv), name="ros2", argv=argv)
    session.clock.sleep(1.0)


def test_a_tour_reaches_its_points_and_knows_who_was_how_wrong(session, cart):
    tour = drive_along([(2.2, 0.3), (2.4, -0.5), (0.5, -0.3)], speed=0.5)
    x, y, _ = tour.tracks["truth"][-1]
    assert math.hypot(x - 0.0, y + 0.3) < 0.4, "seen from its start, the last point is at (0, -0.3)"
    assert 3.0 < tour.length < 6.0 and tour.error("SLAM") < 0.05 < tour.error("odometry")
    assert repr(tour).startswith(f"drove {tour.length:.1f} m in {tour.seconds:.0f} s; at the end off by: odometry")
    shown = map_view(truth=True, tour=tour)
    assert shown.comparison is not None and shown.comparison.false < 0.05 and shown.comparison.iou > 0.6
    assert "free" in repr(shown) and shown.png().startswith(b"\x89PNG")


def test_it_waits_for_the_first_scan_of_who_makes_a_map(session):
    start(session, "gazebo_ros", "gzserver", "robot_world")
    start(session, "robot_state_publisher", "robot_state_publisher", str(CART), "--ros-args", "-p", "use_sim_time:=true")
    start(session, "gazebo_ros", "spawn_entity.py", "-entity", "cart", "-file", str(CART), "-x", "0.5").wait(20.0)
    hidden = HiddenNode("slow_slam")
    hidden.node.create_publisher(OccupancyGrid, "/map", 1)
    broadcaster = StaticTransformBroadcaster(hidden.node)
    map_to_odom = TransformStamped(child_frame_id="odom")
    map_to_odom.header.frame_id, map_to_odom.transform.rotation.w = "map", 1.0
    hidden.node.create_timer(4.0, lambda: broadcaster.sendTransform(map_to_odom))
    tour = drive_along([(2.2, 0.3)], speed=0.5)
    assert not np.isnan(tour.errors("SLAM")).any()
    hidden.close()


def test_a_wall_in_the_way_is_told(session, cart):
    with pytest.raises(RuntimeError, match=r"stuck at \(\d.\d, .* on the way to \(9, 0\)"):
        drive_along([(9.0, 0.0)], speed=1.0)
    assert not [node for node in session.graph(0).nodes if "tour" in node.name], "it has let go"


def test_without_a_simulator_or_a_robot_it_says_what_to_type(session):
    with pytest.raises(LookupError, match="No simulator runs. Start one: %ros2 launch gazebo_ros"):
        drive_along([(1.0, 0.0)])
    start(session, "gazebo_ros", "gzserver", "robot_world")
    session.clock.sleep(0.5)
    with pytest.raises(LookupError, match="No robot yet. Spawn one"):
        drive_along([(1.0, 0.0)])


def test_a_map_file_is_shown_without_any_node(session, tmp_path):
    cells = np.full((4, 5), -1, np.int8)
    cells[1, 1:3], cells[2, 1] = 0, 100
    file, _ = save_map(tmp_path / "small", GridMap(cells, 0.1))
    assert repr(map_view(file)) == "map of 5 x 4 cells of 0.1 m: 1 walls, 2 free, 17 unknown"
    with pytest.raises(LookupError, match="There is no topic /mpa in the graph"):
        map_view("/mpa")


@pytest.mark.parametrize("lag", [0.4, 0.8, 2.0])
def test_a_slow_computer_drives_as_far_and_does_not_turn_for_ever(session, cart, monkeypatch, lag):
    """Who looks up seldom turns by no more than what was missing at the last look."""
    monkeypatch.setattr("coursekit.lab.tour.BEAT_SECONDS", lag)
    monkeypatch.setattr("coursekit.lab.drive.SILENCE_SECONDS", 2 * lag)  # the stop comes late, too
    tour = drive_along([(2.2, 0.3), (2.4, -0.5), (0.5, -0.3)], speed=0.5)
    x, y, _ = tour.tracks["truth"][-1]
    assert math.hypot(x, y + 0.3) < 0.6 and tour.length < 7.0 and tour.seconds < 120
