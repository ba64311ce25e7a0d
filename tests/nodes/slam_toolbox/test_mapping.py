"""The mapping node on the virtual clock: a drive through a building gives its map, whatever the laser's seat."""

from __future__ import annotations

import math

import numpy as np
import pytest
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import MapMetaData
from nav_msgs.srv import GetMap
from sensor_msgs.msg import LaserScan
from slam_toolbox.srv import Pause, Reset, SaveMap, SerializePoseGraph
from std_msgs.msg import String
from visualization_msgs.msg import MarkerArray

from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_file import load_map
from coursekit.nodes.nav2.map_message import MAP_QOS, from_message
from tests.slam.building import drive
from tests.slam.robot import PERIOD, wall_gaps

SHORT = [(3.0, 5.0), (8.0, 5.0), (8.0, 4.4)]


def start_of(corners):
    return next(iter(drive(corners)))


@pytest.mark.parametrize("node", ["async_slam_toolbox_node", "sync_slam_toolbox_node"])
def test_a_drive_gives_the_map_of_the_building_and_the_way_home(robot, slam, node):
    process, rover = slam(node=node), robot()
    sizes, poses = [], []
    rover.node.create_subscription(MapMetaData, "map_metadata", sizes.append, MAP_QOS)
    rover.node.create_subscription(PoseWithCovarianceStamped, "pose", poses.append, 10)
    end, start = rover.go(SHORT), start_of(SHORT)
    rover.spin(1.0)
    gaps = wall_gaps(rover.maps[-1], start)
    assert len(gaps) > 300 and (gaps < 0.075).mean() > 0.97
    assert rover.maps[-1].header.frame_id == "map" and sizes[-1] == rover.maps[-1].info
    assert len(rover.maps) > 5  # it grew while the robot drove
    assert (from_message(rover.maps[0]).cells >= 0).sum() < (from_message(rover.maps[-1]).cells >= 0).sum()
    assert rover.where().distance(start.to(end)) < 0.05 < rover.wheels.pose.distance(start.to(end))
    last = poses[-1].pose
    assert math.hypot(last.pose.position.x - start.to(end).x, last.pose.position.y - start.to(end).y) < 0.05
    assert 0 < last.covariance[0] < 0.01 and 0 < last.covariance[35] < 0.01
    process.interrupt()
    assert process.wait(5.0) == 0


@pytest.mark.parametrize(
    ("seat", "flipped"), [(Pose2D(0.3, -0.2, 0.7), False), (Pose2D(-0.2, 0.1, math.pi), True)], ids=["turned", "upside down"]
)
def test_the_lasers_seat_comes_from_tf(robot, slam, seat, flipped):
    slam()
    rover = robot(seat, flipped)
    way = [(3.0, 5.0), (5.0, 5.0), (5.0, 4.4)]
    end, start = rover.go(way), start_of(way)
    rover.spin(1.0)
    assert (wall_gaps(rover.maps[-1], start) < 0.075).mean() > 0.96
    assert rover.where().distance(start.to(end)) < 0.05


def test_a_scan_without_transform_says_what_is_missing(robot, slam):
    process, rover = slam(), robot(odometry=False)
    for _ in range(4):
        rover.tell(Pose2D(3.0, 5.0, 0.0))
    out = process.output
    assert "Message Filter dropping message: frame 'laser' at time 1700000001" in out
    assert "for reason 'discarding message because the queue is full'" in out
    assert "No transform 'odom' -> 'laser'" in out and "ros2 run tf2_ros tf2_echo odom laser" in out
    assert not rover.maps


def test_a_wrong_base_frame_is_named(robot, slam):
    process, rover = slam("-p", "base_frame:=base_link"), robot()
    rover.tell(Pose2D(3.0, 5.0, 0.0))
    assert "Failed to compute laser pose" in process.output and "base_link" in process.output


def test_scans_that_cannot_be_used_are_told_and_the_map_goes_on(robot, slam):
    process, rover = slam(), robot()
    way = list(drive([(3.0, 5.0), (5.0, 5.0)], step=0.1))
    for number, pose in enumerate(way):
        msg = rover.scan(pose)
        if number == 3:
            msg.ranges = []
        elif number == 5:
            msg.angle_increment = 0.0
        elif number == 7:
            msg.ranges = msg.ranges[:100]
        elif number == 9:
            msg.ranges = [math.nan] * len(msg.ranges)
        elif number > 9:
            msg.ranges[::7] = type(msg.ranges)("f", [math.nan] * len(msg.ranges[::7]))
        rover.tell(pose, msg)
    rover.spin(0.6)
    assert "it has no ranges" in process.output and "angle_increment is 0" in process.output
    assert "LaserRangeScan contains 100 range readings, expected 180" in process.output
    assert process.state == "running"
    assert (wall_gaps(rover.maps[-1], way[0]) < 0.075).mean() > 0.97
    assert rover.where().distance(way[0].to(way[-1])) < 0.05


def test_save_map_writes_what_nav2_reads(robot, slam, tmp_path):
    process, rover = slam(), robot()
    assert rover.ask(SaveMap, "slam_toolbox/save_map").result == SaveMap.Response.RESULT_NO_MAP_RECEIEVD
    assert "Map Saver: Cannot save map, no map yet received on topic /map." in process.output
    rover.tell(Pose2D(3.0, 5.0, 0.0))
    answer = rover.ask(SaveMap, "slam_toolbox/save_map", name=String(data=str(tmp_path / "office")))
    assert answer.result == SaveMap.Response.RESULT_SUCCESS
    saved = load_map(tmp_path / "office.yaml")
    cells = from_message(rover.maps[-1]).cells
    assert np.array_equal(saved.cells, np.where(cells < 0, 0, cells)), "what is unknown loads as free"
    shown = rover.ask(GetMap, "slam_toolbox/dynamic_map").map
    assert np.array_equal(from_message(shown).cells, cells)
    gone = rover.ask(SaveMap, "slam_toolbox/save_map", name=String(data=str(tmp_path / "none" / "map")))
    assert gone.result == SaveMap.Response.RESULT_UNDEFINED_FAILURE


def test_pausing_leaves_scans_aside_and_reset_begins_anew(robot, slam):
    process, rover = slam(), robot()
    rover.go([(3.0, 5.0), (4.0, 5.0)])
    assert rover.ask(Pause, "slam_toolbox/pause_new_measurements").status
    assert "SlamToolbox: Toggled to pause taking new measurements." in process.output
    rover.spin(0.6)
    before = from_message(rover.maps[-1]).cells
    rover.go([(4.0, 5.0), (5.5, 5.0)])
    rover.spin(0.6)
    assert np.array_equal(from_message(rover.maps[-1]).cells, before)
    assert rover.ask(Reset, "slam_toolbox/reset").result == Reset.Response.RESULT_SUCCESS
    rover.tell(Pose2D(5.5, 5.0, 0.0))
    rover.spin(0.6)
    assert rover.where().distance(rover.wheels.pose) < 0.01 < rover.wheels.pose.distance(Pose2D())  # map is odom again


def test_the_graph_and_the_last_match_are_shown(robot, slam):
    slam()
    rover, seen = robot(), []
    rover.node.create_subscription(MarkerArray, "slam_toolbox/graph_visualization", seen.append, 10)
    rover.go([(3.0, 5.0), (5.0, 5.0)])
    rover.spin(0.6)
    marks = {marker.ns: marker for marker in seen[-1].markers}
    assert set(marks) == {"slam_toolbox", "slam_toolbox_edges", "loops_accepted", "loops_rejected", "status"}
    assert len(marks["slam_toolbox"].points) > 3
    assert len(marks["slam_toolbox_edges"].points) == 2 * (len(marks["slam_toolbox"].points) - 1)
    assert "match" in marks["status"].text and "loops: 0 accepted, 0 rejected" in marks["status"].text


def test_without_matching_the_map_is_as_wrong_as_the_odometry(robot, slam):
    slam("-p", "use_scan_matching:=false")
    rover = robot()
    end = rover.go(SHORT)
    assert rover.where().distance(rover.wheels.pose) < 1e-6 < 0.1 < rover.where().distance(start_of(SHORT).to(end))


def test_bad_parameters_fall_back_with_a_word(robot, slam):
    process = slam("-p", "resolution:=-1.0", "-p", "throttle_scans:=0", "-p", "max_laser_range:=12")
    assert "resolution should be a number, at least 0.001, not -1.0: 0.05 is used" in process.output
    assert "You've set throttle_scans to be 0" in process.output
    rover = robot()
    rover.tell(Pose2D(3.0, 5.0, 0.0))
    rover.spin(0.6)
    assert rover.maps[-1].info.resolution == pytest.approx(0.05)


def test_serializing_needs_a_name_and_a_place(robot, slam, tmp_path):
    slam()
    rover, failed = robot(), SerializePoseGraph.Response.RESULT_FAILED_TO_WRITE_FILE
    rover.tell(Pose2D(3.0, 5.0, 0.0))
    assert rover.ask(SerializePoseGraph, "slam_toolbox/serialize_map", filename="").result == failed
    nowhere = str(tmp_path / "none" / "a")
    assert rover.ask(SerializePoseGraph, "slam_toolbox/serialize_map", filename=nowhere).result == failed


def test_scans_come_through_best_effort_and_with_late_odometry(robot, slam, session):
    slam()
    rover = robot()
    scan: LaserScan = rover.scan(Pose2D(3.0, 5.0, 0.0))
    rover._scans.publish(scan)  # the odometry of its time comes half a period later
    rover.spin(PERIOD / 2)
    stamped = rover._transform("odom", "base_footprint", Pose2D())
    before = rover._transform("odom", "base_footprint", Pose2D())
    before.header.stamp = scan.header.stamp
    rover._moving.sendTransform([before, stamped])
    rover.spin(1.0)
    assert rover.maps
