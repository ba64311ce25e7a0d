"""The viewer without a browser: what it shows, what it says, what it would send."""

import math

import numpy as np
import pytest
from geometry_msgs.msg import Point, PointStamped, Pose, PoseArray, PoseStamped, PoseWithCovarianceStamped, TransformStamped
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from sensor_msgs.msg import Image, LaserScan, PointCloud2, PointField
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

from coursekit.core.executables import find
from coursekit.core.session import Session
from coursekit.lab.hidden import HiddenNode
from coursekit.lab.panel import close_panels
from coursekit.lab.viewer import viewer
from tests.urdf.oracle import ROBOTS


@pytest.fixture
def session():
    with Session(virtual=True).use() as made:
        yield made
        close_panels()


@pytest.fixture
def talker(session):
    hidden = HiddenNode("talker")
    yield hidden.node
    hidden.close()


def robot(session, name="rdk_x3_robot", *more):
    file = str(ROBOTS / f"{name}.urdf")
    for package, arguments in (("robot_state_publisher", [file, *more]), ("joint_state_publisher", more)):
        session.start_executable(find(package, package), list(arguments), name=package)
    session.clock.sleep(0.5)


def frame(node, parent, child, x=0.0, static=True):
    from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster

    msg = TransformStamped(child_frame_id=child)
    msg.header.frame_id, msg.header.stamp = parent, node.get_clock().now().to_msg()
    msg.transform.translation.x = x
    (StaticTransformBroadcaster if static else TransformBroadcaster)(node).sendTransform(msg)


def said(node, type_, topic, frame_id="map", **fields):
    msg = type_(**fields)
    if hasattr(msg, "header"):
        msg.header.frame_id = frame_id
    node.create_publisher(type_, topic, 1).publish(msg)
    return msg


def shapes(panel, name):
    key = panel.stage.find(name).key
    panel.stage.update()
    return [shape for (one, _), thing in panel.stage.scene.things.items() if one == key for shape in thing.shapes]


def test_bare_it_shows_the_robot_and_its_frames_and_says_the_same_every_time():
    texts = []
    for _ in range(2):
        with Session(virtual=True).use() as session:
            robot(session)
            texts.append(viewer().text())
            close_panels()
    assert texts[0] == texts[1]
    lines = texts[0].splitlines()
    assert lines[0] == "viewer: fixed frame base_footprint (guessed)"
    assert lines[2].startswith("[x] RobotModel /robot_description  Ok") and "13 of 13 links placed" in lines[2]
    assert lines[3].endswith("13 frames")


def test_a_robot_of_one_link_stands_without_frames(session):
    robot(session, "sphere")
    lines = viewer().text().splitlines()
    assert lines[0] == "viewer: fixed frame base_link (guessed)"
    assert lines[3].endswith("sphere_robot: 1 of 1 links placed")


def test_the_notebook_gets_a_widget_a_picture_and_a_text(session):
    panel = viewer(displays=["Grid"])
    bundle = panel._repr_mimebundle_()
    data = bundle[0] if isinstance(bundle, tuple) else bundle
    assert {"application/vnd.jupyter.widget-view+json", "image/png", "text/plain"} <= set(data)
    assert panel.png() == panel.png()


def test_a_missing_frame_is_named_with_what_there_is(session, talker):
    robot(session)
    panel = viewer(fixed_frame="base_lnk", displays=["RobotModel"])
    assert "frame [base_lnk] does not exist. There are: base_footprint" in panel.text().splitlines()[1]
    assert "Did you mean [base_link]?" in panel.status("RobotModel")
    panel.fixed_frame = "base_link"
    session.clock.sleep(0.5)
    assert panel.status("RobotModel").startswith("Ok")


def test_two_trees_are_told_apart(session, talker):
    frame(talker, "map", "a")
    frame(talker, "moon", "b")
    said(talker, LaserScan, "/scan", "b")
    panel = viewer(fixed_frame="map", displays=["LaserScan", "TF"])
    said(talker, LaserScan, "/scan", "b")
    session.clock.sleep(0.1)
    assert "two trees, under [moon] and [map]" in panel.status("LaserScan")
    assert "No transform from [b], [moon] to [map]" in panel.status("TF")


def test_of_messages_that_cannot_be_placed_the_newest_is_explained(session, talker):
    frame(talker, "map", "a")
    panel = viewer(fixed_frame="map", displays=["LaserScan"])
    for name in ("", "moon"):
        said(talker, LaserScan, "/scan", name)
        session.clock.sleep(0.1)
        panel.status("LaserScan")
    assert "frame [moon] does not exist" in panel.status("LaserScan")


def test_a_topic_without_messages_says_why(session, talker):
    talker.create_publisher(LaserScan, "/front", 1)
    talker.create_publisher(Path, "/strange", 1)
    panel = viewer(displays=["LaserScan /scan", {"type": "LaserScan", "topic": "/strange", "name": "other"}])
    assert "Nobody publishes /scan. There is: /front" in panel.status("LaserScan")
    assert "/strange has the type nav_msgs/msg/Path, not sensor_msgs/msg/LaserScan" in panel.status("other")


def test_robots_are_shown_by_namespace(session):
    for number in (1, 2):
        robot(session, "rdk_x3_robot", "--ros-args", "-r", f"__ns:=/r{number}", "-p", f"frame_prefix:=r{number}/")
    panel = viewer()
    assert panel.displays == ["Grid", "r1", "r2", "TF"]
    for name in ("r1", "r2"):
        links = panel.stage.find(name)
        panel.stage.update()
        assert links.prefix(panel.stage) == f"{name}/"
    assert panel.status("r1").startswith("Ok")
    assert "another tree" in panel.status("TF")


def test_switching_off_empties_and_on_shows_again(session):
    robot(session)
    panel = viewer(displays=["RobotModel", "TF"])
    assert shapes(panel, "RobotModel")
    panel.switch("RobotModel", False)
    assert not shapes(panel, "RobotModel") and "[ ] RobotModel /robot_description  Off" in panel.text()
    panel.switch("RobotModel", True)
    session.clock.sleep(0.1)
    assert shapes(panel, "RobotModel")


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
    made = Marker(color=ColorRGBA(r=1.0, a=1.0), **fields)
    made.scale.x = made.scale.y = made.scale.z = 0.2
    made.header.frame_id = "map"
    return made


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


def test_a_scan_waits_for_its_transform_and_is_shown_where_it_was_taken(session, talker):
    panel = viewer(fixed_frame="odom", displays=["LaserScan"])
    frame(talker, "odom", "laser", 0.0, static=False)
    session.clock.sleep(0.1)
    msg = LaserScan(ranges=[1.0], range_max=5.0)
    msg.header.frame_id, msg.header.stamp = "laser", talker.get_clock().now().to_msg()
    talker.create_publisher(LaserScan, "/scan", 1).publish(msg)
    session.clock.sleep(0.1)
    assert panel.status("LaserScan").startswith("Error") and "extrapolation" in panel.status("LaserScan")
    frame(talker, "odom", "laser", 2.0, static=False)
    session.clock.sleep(0.1)
    panel.stage.update()
    (thing,) = panel.stage.scene.things.values()
    assert thing.pose[0] == pytest.approx(1.0), "half way, when the scan was taken"


def test_the_tools_publish_in_the_fixed_frame(session, talker):
    heard = []
    kinds = ((PoseStamped, "/goal_pose"), (PoseWithCovarianceStamped, "/initialpose"), (PointStamped, "/clicked_point"))
    for kind, topic in kinds:
        talker.create_subscription(kind, topic, heard.append, 1)
    panel = viewer(fixed_frame="map", displays=["Grid"])
    panel._hear(panel, {"type": "tool", "tool": "goal", "x": 1.0, "y": 2.0, "yaw": math.pi}, [])
    panel.pose_estimate(1, 2, math.pi / 2)
    panel.publish_point(1, 2)
    panel._hear(panel, {"type": "tool", "tool": "goal", "x": "far", "y": 2.0}, [])
    session.clock.sleep(0.1)
    goal, estimate, point = heard
    assert goal.header.frame_id == "map" and goal.pose.orientation.z == pytest.approx(1.0)
    assert estimate.pose.covariance[0] == 0.25 and estimate.pose.covariance[35] == pytest.approx(0.0685389)
    assert (point.point.x, point.point.y) == (1.0, 2.0)


def test_the_browser_gets_batches_and_nothing_while_it_draws(session, monkeypatch):
    robot(session)
    panel = viewer(displays=["RobotModel", "TF"])
    sent = []
    monkeypatch.setattr(panel, "send", lambda message, buffers=None: sent.append(message))
    session.clock.sleep(1.0)
    assert not sent, "no page, no messages"
    panel._hear(panel, {"type": "open"}, [])
    session.clock.sleep(1.0)
    scenes = [one for one in sent if one["type"] == "scene"]
    assert len(scenes) == 1 and scenes[0]["whole"] and scenes[0]["view"]
    panel.stage.fix("laser_link")
    session.clock.sleep(1.0)
    assert len([one for one in sent if one["type"] == "scene"]) == 1, "the page has not drawn the first"
    panel._hear(panel, {"type": "drawn", "n": 1}, [])
    session.clock.sleep(1.0)
    assert len([one for one in sent if one["type"] == "scene"]) == 2
    panel._hear(panel, {"type": "open"}, [])
    session.clock.sleep(0.1)
    assert sent[-1]["whole"] or sent[-2]["whole"], "a page that was loaded again gets all"


def test_it_is_saved_and_read_again(session, tmp_path):
    panel = viewer(fixed_frame="odom", displays=["Grid", "LaserScan /front"])
    panel.switch("Grid", False)
    panel.save(tmp_path / "mine.yaml")
    assert viewer(tmp_path / "mine.yaml").text() == panel.text()


def test_a_bad_description_is_told(session, talker):
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    talker.create_publisher(String, "/robot_description", lasting).publish(String(data="<robot name='x'>"))
    assert viewer(displays=["RobotModel"]).status("RobotModel").startswith("Error: URDF:")


def test_a_topic_that_cannot_be_is_told_and_may_be_mended(session, talker):
    panel = viewer(fixed_frame="map", displays=["LaserScan /front scan"])
    panel._hear(panel, {"type": "topic", "row": 0, "topic": "/front-scan"}, [])
    assert "Error subscribing: Invalid topic name" in panel.status("LaserScan")
    panel._hear(panel, {"type": "topic", "row": 0, "topic": "/front"}, [])
    said(talker, LaserScan, "/front", ranges=[1.0], range_max=5.0)
    session.clock.sleep(0.1)
    assert panel.status("LaserScan").startswith("Ok")
