"""Kept sessions and maps: gone on with, and localised in."""

from __future__ import annotations

import math

import numpy as np
import pytest
from geometry_msgs.msg import Pose2D, PoseWithCovarianceStamped
from slam_toolbox.srv import DeserializePoseGraph, SaveMap, SerializePoseGraph
from std_msgs.msg import String
from std_srvs.srv import SetBool

from coursekit.nodes.nav2.map_message import from_message
from coursekit.nodes.slam_toolbox.geometry import to_pose
from coursekit.slam.pose import Pose2
from tests.slam.building import drive
from tests.slam.robot import Robot

WAY = [(3.0, 5.0), (10.0, 5.0)]
START = next(iter(drive(WAY)))


def at(x: float, y: float, heading: float) -> Pose2:
    """A place of the building, in the map that began at START."""
    return START.to(Pose2(x, y, heading))


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """A pose graph and a map of the way, by name without ending."""
    from coursekit.processes.executables import find
    from coursekit.processes.session import Session

    name = str(tmp_path_factory.mktemp("kept") / "office")
    with Session(virtual=True).use() as session:
        session.start_executable(find("slam_toolbox", "async_slam_toolbox_node"), [], name="slam")
        session.clock.sleep(1.0)
        rover = Robot(session)
        rover.go(WAY)
        rover.ask(SerializePoseGraph, "slam_toolbox/serialize_map", filename=name)
        rover.ask(SaveMap, "slam_toolbox/save_map", name=String(data=name))
        rover.close()
    return name


def start_pose(pose: Pose2) -> tuple[str, str]:
    return "-p", f"map_start_pose:=[{pose.x}, {pose.y}, {pose.theta}]"


def tell_pose(rover: Robot, pose: Pose2, frame: str = "map") -> None:
    publisher = rover.node.create_publisher(PoseWithCovarianceStamped, "initialpose", 1)
    msg = PoseWithCovarianceStamped()
    msg.header.frame_id, msg.pose.pose = frame, to_pose(pose)
    publisher.publish(msg)
    rover.spin(0.1)


@pytest.mark.parametrize("ending", ["", ".posegraph", ".yaml"])
def test_a_robot_finds_itself_in_a_kept_map_and_leaves_it_as_it_is(kept, robot, slam, ending):
    wrong = at(6.5, 5.2, 0.2)
    argv = ("-p", f"map_file_name:={kept}{ending}", *start_pose(wrong))
    slam(*argv, node="localization_slam_toolbox_node")
    rover = robot()
    end = rover.go([(6.0, 5.0), (8.5, 5.0), (8.5, 4.5)])
    assert rover.where_is(START.to(end)) < 0.07
    rover.spin(0.6)
    maps = [from_message(msg).cells for msg in rover.maps]
    assert all(np.array_equal(cells, maps[0]) for cells in maps)


def test_without_a_start_the_whole_map_is_searched(kept, robot, slam):
    process = slam("-p", f"map_file_name:={kept}", node="localization_slam_toolbox_node")
    assert "Map starting pose not specified" in process.output
    rover = robot()
    end = rover.go([(8.5, 5.0), (6.0, 5.0), (6.0, 4.5)])
    assert rover.where_is(START.to(end)) < 0.07


def test_initialpose_moves_a_lost_robot(kept, robot, slam):
    argv = ("-p", f"map_file_name:={kept}", *start_pose(at(3.0, 5.0, 0.0)))
    process = slam(*argv, node="localization_slam_toolbox_node")
    rover = robot()
    truth = Pose2(8.5, 5.0, math.pi)
    rover.tell(truth)
    assert rover.where_is(START.to(truth)) > 1
    tell_pose(rover, at(8.2, 5.1, math.pi - 0.2), frame="odom")
    assert "'odom', it must be 'map'" in process.output
    tell_pose(rover, at(8.2, 5.1, math.pi - 0.2))
    assert "LocalizePoseCallback: Localizing to: " in process.output
    rover.tell(truth)
    rover.tell(truth)
    assert rover.where_is(START.to(truth)) < 0.07


@pytest.mark.parametrize("kind", ["first", "given"])
def test_mapping_goes_on_in_a_kept_session(kept, robot, slam, kind):
    slam()
    rover, request = robot(), DeserializePoseGraph.Request
    begin = (3.0, 5.0) if kind == "first" else (9.0, 5.0)
    pose = at(*begin, 0.0)
    match = request.START_AT_FIRST_NODE if kind == "first" else request.START_AT_GIVEN_POSE
    where = Pose2D(x=pose.x, y=pose.y, theta=pose.theta)
    rover.ask(DeserializePoseGraph, "slam_toolbox/deserialize_map", filename=kept, match_type=match, initial_pose=where)
    rover.spin(0.6)
    before = (from_message(rover.maps[-1]).cells >= 0).sum()
    end = rover.go([begin, (12.5, 5.0), (12.5, 4.6)])
    rover.spin(0.6)
    assert rover.where_is(START.to(end)) < 0.07
    assert (from_message(rover.maps[-1]).cells >= 0).sum() > 1.1 * before


def test_files_that_are_none_are_told(robot, slam, tmp_path):
    (tmp_path / "bad.posegraph").write_bytes(b"22 serialization::archive")
    process, rover = slam(), robot()
    first = DeserializePoseGraph.Request.START_AT_FIRST_NODE
    for name in ("", "gone", "bad"):
        file = str(tmp_path / name) if name else ""
        rover.ask(DeserializePoseGraph, "slam_toolbox/deserialize_map", filename=file, match_type=first)
    assert process.output.count("DeserializePoseGraph: Failed to read file") == 3
    assert "no file" in process.output and "is no saved SLAM session" in process.output
    rover.tell(Pose2(3.0, 5.0, 0.0))
    rover.spin(0.6)
    assert rover.maps


def test_a_node_changes_between_mapping_and_localising(robot, slam):
    slam(node="map_and_localization_slam_toolbox_node")
    rover = robot()
    switch = "slam_toolbox/set_localization_mode"
    assert not rover.ask(SetBool, switch, data=True).success
    rover.go([(3.0, 5.0), (6.0, 5.0)])
    assert rover.ask(SetBool, switch, data=True).success
    rover.spin(0.6)
    still = from_message(rover.maps[-1]).cells
    rover.go([(6.0, 5.0), (8.0, 5.0)])
    rover.spin(0.6)
    assert np.array_equal(from_message(rover.maps[-1]).cells, still)
    assert rover.ask(SetBool, switch, data=False).success
    end = rover.go([(8.0, 5.0), (10.0, 5.0)])
    rover.spin(0.6)
    assert from_message(rover.maps[-1]).cells.size > still.size
    assert rover.where_is(START.to(end)) < 0.07
