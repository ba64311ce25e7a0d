"""Messages, maps, markers and scans in the viewer."""

import math

import numpy as np
import pytest
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Point, Pose, PoseArray, PoseStamped
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from sensor_msgs.msg import Image, LaserScan, PointCloud2, PointField
from std_msgs.msg import ColorRGBA, Header
from visualization_msgs.msg import Marker, MarkerArray

from coursekit.lab.viewer import viewer
from tests.lab.viewer_stage import frame, said, shapes
from tests.urdf.oracle import ROBOTS


def test_messages_become_shapes(session, talker):
    kinds = ["LaserScan", "Path", "Pose", "PoseArray", "Odometry", "Map", "PointCloud2", "Image"]
    panel = viewer(fixed_frame="map", displays=kinds)
    said(talker, LaserScan, "/scan", ranges=[1.0, 2.0, math.inf, math.nan], range_max=5.0, angle_increment=0.1)
    said(talker, Path, "/plan", poses=[PoseStamped(), PoseStamped(pose=Pose(position=Point(x=1.0)))])
    said(talker, PoseStamped, "/goal_pose")
    said(talker, PoseArray, "/particlecloud", poses=[Pose(), Pose()])
    said(talker, Odometry, "/odom")
    grid = OccupancyGrid(data=[0, 100, -1, 50])
    grid.header.frame_id, grid.info.width, grid.info.height, grid.info.resolution = "map", 2, 2, 0.5
    talker.create_publisher(OccupancyGrid, "/map", 1).publish(grid)
    fields = [PointField(name=axis, offset=4 * i, datatype=7, count=1) for i, axis in enumerate("xyz")]
    cloud = np.array([[0, 0, 1], [np.nan, 0, 0], [1, 1, 0]], "<f4")
    said(talker, PointCloud2, "/points", height=1, width=3, fields=fields, point_step=12, row_step=36, data=cloud.tobytes())
    said(talker, Image, "/image", height=2, width=2, encoding="mono8", step=2, data=bytes(4))
    session.clock.sleep(0.2)
    panel.switch("Map", False)
    panel.stage.find("Map").config.options["alpha"] = 1.0
    assert [len(shape.points) for shape in shapes(panel, "LaserScan")] == [2]
    assert [len(shape.faces) for shape in shapes(panel, "Path")] == [2]
    assert len(shapes(panel, "Pose")) == len(shapes(panel, "Odometry")) == 1
    assert panel.status("PoseArray").endswith("2 poses")
    assert [len(shape.points) for shape in shapes(panel, "PointCloud2")] == [2]
    assert panel.status("Image").endswith("2x2 mono8")


def test_a_map_that_came_before_is_shown(session, talker):
    from rclpy.qos import DurabilityPolicy, QoSProfile

    grid = OccupancyGrid(data=[0, 100, -1, 50])
    grid.header.frame_id, grid.info.width, grid.info.height, grid.info.resolution = "map", 2, 2, 0.5
    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    talker.create_publisher(OccupancyGrid, "/map", lasting).publish(grid)
    panel = viewer(fixed_frame="map", displays=["Map"])
    (picture,) = shapes(panel, "Map")
    assert (picture.width, picture.height) == (1.0, 1.0)
    assert picture.image[1, :, 0].tolist() == [255, 0], "the lower row: free, occupied"
    grid.data = [0]
    talker.create_publisher(OccupancyGrid, "/map", lasting).publish(grid)
    session.clock.sleep(0.1)
    assert not shapes(panel, "Map") and "1 numbers in data" in panel.status("Map")


def marker(**fields):
    new_marker = Marker(color=ColorRGBA(r=1.0, a=1.0), **fields)
    new_marker.scale.x = new_marker.scale.y = new_marker.scale.z = 0.2
    new_marker.header.frame_id = "map"
    return new_marker


def test_all_types_of_markers_are_shown_and_live_as_long_as_they_say(session, talker):
    panel = viewer(fixed_frame="map", displays=["MarkerArray"])
    points = [Point(), Point(x=1.0), Point(y=1.0)]
    flat = [marker(ns="a", id=kind, type=kind, points=points if kind in (4, 6, 7, 8, 11) else []) for kind in range(4)]
    lists = [marker(ns="a", id=kind, type=kind, points=points) for kind in (4, 6, 7, 8, 11)]
    others = [marker(ns="a", id=5, type=5, points=points[:2]), marker(ns="b", id=9, type=9, text="hello")]
    mesh = marker(ns="b", id=10, type=10, mesh_resource=(ROBOTS.parent / "meshes" / "finger.stl").as_uri())
    publisher = talker.create_publisher(MarkerArray, "/visualization_marker_array", 1)
    publisher.publish(MarkerArray(markers=[*flat, *lists, *others, mesh]))
    session.clock.sleep(0.1)
    assert len(shapes(panel, "MarkerArray")) == 12 and panel.status("MarkerArray") == "Ok: 1 message received; 12 markers"

    brief = marker(ns="c", id=1, type=1)
    brief.lifetime.sec = 1
    publisher.publish(MarkerArray(markers=[marker(ns="a", id=1, action=2), marker(ns="b", action=3), brief]))
    session.clock.sleep(0.1)
    assert len(shapes(panel, "MarkerArray")) == 10
    session.clock.sleep(1.0)
    assert len(shapes(panel, "MarkerArray")) == 9


def test_a_bad_marker_is_named_and_the_others_stay(session, talker):
    panel = viewer(fixed_frame="map", displays=["MarkerArray"])
    bad = [marker(ns="odd", id=7, type=5, points=[Point()]), marker(ns="good", type=1)]
    talker.create_publisher(MarkerArray, "/visualization_marker_array", 1).publish(MarkerArray(markers=bad))
    session.clock.sleep(0.1)
    assert "odd/7: 1 points, not a multiple of 2" in panel.status("MarkerArray")
    assert len(shapes(panel, "MarkerArray")) == 1


@pytest.fixture
def scans(session, talker):
    """A viewer of scans, in `odom`; its laser is at 0, now. Gives the viewer, and what sends a scan of now."""
    panel = viewer(fixed_frame="odom", displays=["LaserScan"])
    frame(talker, "odom", "laser", 0.0, static=False)
    session.clock.sleep(0.1)
    publisher = talker.create_publisher(LaserScan, "/scan", 5)

    def scan():
        msg = LaserScan(ranges=[1.0], range_max=5.0)
        msg.header.frame_id, msg.header.stamp = "laser", talker.get_clock().now().to_msg()
        publisher.publish(msg)
        session.clock.sleep(0.1)

    return panel, scan


def test_a_scan_waits_for_its_transform_and_is_shown_where_it_was_taken(session, talker, scans):
    panel, scan = scans
    scan()
    assert panel.status("LaserScan").startswith("Warn") and "extrapolation" in panel.status("LaserScan")
    frame(talker, "odom", "laser", 2.0, static=False)
    session.clock.sleep(0.1)
    panel.stage.update()
    (thing,) = panel.stage.scene.things.values()
    assert thing.pose[0] == pytest.approx(1.0), "half way, when the scan was taken"
    assert panel.status("LaserScan").startswith("Ok")


def test_a_scan_that_came_before_its_transform_is_no_fault_where_one_is_shown(session, talker, scans):
    panel, scan = scans
    scan()
    frame(talker, "odom", "laser", static=False)
    scan()
    assert panel.status("LaserScan").startswith("Ok"), "the first is shown, the second waits"


def test_transforms_that_come_no_more_are_an_error(session, talker, scans):
    panel, scan = scans
    scan()
    frame(talker, "odom", "laser", static=False)
    for _ in range(6):
        scan()
    assert panel.status("LaserScan").startswith("Error") and "extrapolation" in panel.status("LaserScan")


def test_a_scan_from_before_all_transforms_is_an_error(session, talker, scans):
    panel = scans[0]
    for _ in range(2):
        session.clock.sleep(0.1)
        frame(talker, "odom", "laser", static=False)
    said(talker, LaserScan, "/scan", "laser", header=Header(stamp=Time(sec=1)))
    session.clock.sleep(0.1)
    assert panel.status("LaserScan").startswith("Error") and "into the past" in panel.status("LaserScan")
