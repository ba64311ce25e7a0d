"""What the viewer says of a thing that was clicked; no browser is needed."""

import math

import numpy as np
import pytest
from geometry_msgs.msg import PolygonStamped, Pose, PoseStamped
from nav_msgs.msg import OccupancyGrid, Odometry
from visualization_msgs.msg import Marker

from coursekit.lab.viewer import viewer
from tests.lab.viewer_stage import frame, said, scan


def clicked(panel, does, display, at, name=None):
    """What is said of a thing of a display that was clicked at a place of the fixed frame."""
    panel.stage.update()
    key, things = panel.stage.find(display).key, panel.stage.scene.things.items()
    number = next(thing.number for (display_key, of), thing in things if display_key == key and name in (None, of))
    does("pick", number=number, at=list(at))
    picked = panel.shown()["picked"]
    return dict(picked["facts"]), picked


def test_a_dot_of_a_scan_says_which_beam_it_is_and_how_far(session, talker, page):
    panel = viewer(fixed_frame="map", displays=["LaserScan"])
    scan(talker, intensities=[10.0, 20.0])
    session.clock.sleep(0.1)
    place = 2 * np.array([math.cos(0.5), math.sin(0.5), 0.0])
    facts, picked = clicked(panel, page(panel), "LaserScan", place * 1.01)
    assert (picked["name"], facts["Topic"], facts["Frame"]) == ("LaserScan", "/scan", "map")
    assert (facts["Beam"], facts["Range"], facts["Angle"], facts["Intensity"]) == ("1", "2.000 m", "28.6 deg", "20")
    assert picked["at"] == pytest.approx(place.tolist(), abs=1e-3), "the ring is on the dot"


def test_what_has_just_been_replaced_can_still_be_clicked(session, talker, page):
    panel = viewer(fixed_frame="map", displays=["LaserScan"])
    does = page(panel)
    scan(talker)
    session.clock.sleep(0.1)
    (number,) = [thing.number for thing in panel.stage.update().things.values()]
    scan(talker)
    session.clock.sleep(0.1)
    panel.stage.update()
    does("pick", number=number, at=[1.0, 0.0, 0.0])
    assert dict(panel.shown()["picked"]["facts"])["Range"] == "1.000 m"


def test_the_page_knows_the_number_of_what_was_clicked_also_when_it_is_replaced(session, talker, page):
    panel = viewer(fixed_frame="map", displays=["LaserScan"])
    does = page(panel)

    def marked():
        session.clock.sleep(0.2)
        scenes = [message for message in does.heard if message["type"] == "scene"]
        does("drawn", n=scenes[-1]["n"])
        return scenes[-1]["marked"]

    scan(talker)
    does("open")
    assert marked() is None
    clicked(panel, does, "LaserScan", (1.0, 0.0, 0.0))
    first = marked()
    scan(talker)
    session.clock.sleep(0.1)
    assert marked() > first
    does("pick", number=None, at=None)
    assert marked() is None


def test_a_cell_of_a_map_says_its_value(session, talker, page):
    panel = viewer(fixed_frame="map", displays=[{"type": "Map", "durability": "Volatile"}])
    grid = OccupancyGrid(data=[0, 100, -1, 50])
    grid.info.width, grid.info.height, grid.info.resolution = 2, 2, 0.5
    said(talker, OccupancyGrid, "/map", info=grid.info, data=grid.data)
    session.clock.sleep(0.1)
    does = page(panel)
    assert clicked(panel, does, "Map", (0.7, 0.2, 0.0))[0]["Value"] == "100 (occupied)"
    facts, _ = clicked(panel, does, "Map", (0.2, 0.7, 0.0))
    assert (facts["Cell"], facts["Value"]) == ("column 0, row 1", "-1 (unknown)")


def test_poses_markers_and_frames_say_what_they_are(session, talker, page):
    panel = viewer(fixed_frame="map", displays=["Pose", "Marker", "TF", "Polygon", "Odometry"])
    does = page(panel)
    frame(talker, "map", "robot", 2.0)
    turned = Pose()
    turned.position.x, turned.orientation.z, turned.orientation.w = 1.5, math.sqrt(0.5), math.sqrt(0.5)
    said(talker, PoseStamped, "/goal_pose", pose=turned)
    mark = Marker(ns="shop", id=7, type=Marker.SPHERE)
    mark.scale.x = mark.scale.y = mark.scale.z = mark.color.a = 1.0
    said(talker, Marker, "/visualization_marker", ns="shop", id=7, type=Marker.SPHERE, scale=mark.scale, color=mark.color)
    said(talker, PolygonStamped, "/footprint")
    drive = Odometry()
    drive.twist.twist.linear.x = 0.25
    said(talker, Odometry, "/odom", twist=drive.twist)
    session.clock.sleep(0.1)
    pose, _ = clicked(panel, does, "Pose", (1.5, 0.0, 0.0))
    assert (pose["Position"], pose["Orientation"]) == ("1.50, 0.00, 0.00 m", "roll 0, pitch 0, yaw 90 deg")
    marker, _ = clicked(panel, does, "Marker", (0.0, 0.0, 0.5))
    assert (marker["Namespace"], marker["Id"], marker["Type"]) == ("shop", "7", "SPHERE")
    robot, _ = clicked(panel, does, "TF", (2.0, 0.0, 0.0), "axes robot")
    assert (robot["Frame"], robot["Parent"], robot["Position"]) == ("robot", "map", "2.00, 0.00, 0.00 m")
    assert robot["Age"] == "static"
    assert clicked(panel, does, "Polygon", (0.5, 0.0, 0.0))[0]["Clicked"] == "0.50, 0.00, 0.00 m"
    assert clicked(panel, does, "Odometry", (0.0, 0.0, 0.0))[0]["Velocity"] == "0.25 m/s, 0.00 rad/s"
    does("pick", number=None, at=None)
    assert panel.shown()["picked"] is None


def test_a_link_of_a_robot_says_its_joint(session, talker, page):
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    box = "<visual><geometry><box size='1 1 1'/></geometry></visual>"
    joint = "<joint name='neck' type='fixed'><parent link='base'/><child link='head'/></joint>"
    text = f"<robot name='x'><link name='base'/><link name='head'>{box}</link>{joint}</robot>"
    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    talker.create_publisher(String, "/robot_description", lasting).publish(String(data=text))
    frame(talker, "map", "base")
    frame(talker, "base", "head", 1.0)
    panel = viewer(fixed_frame="map", displays=["RobotModel"])
    facts, _ = clicked(panel, page(panel), "RobotModel", (1.0, 0.0, 0.5), "head")
    assert (facts["Link"], facts["Joint"], facts["Position"]) == ("head", "neck (fixed)", "1.00, 0.00, 0.00 m")
    panel.remove("RobotModel")
    assert panel.shown()["picked"] is None, "what is gone says nothing"


def test_a_frame_that_moves_says_how_long_ago_it_did(session, talker, page):
    panel = viewer(fixed_frame="map", displays=["TF"])
    does = page(panel)
    frame(talker, "map", "robot", 2.0, static=False)
    session.clock.sleep(0.1)
    panel.stage.update()
    session.clock.sleep(3.0)
    robot, _ = clicked(panel, does, "TF", (2.0, 0.0, 0.0), "axes robot")
    assert robot["Age"] == "3.0 s"
