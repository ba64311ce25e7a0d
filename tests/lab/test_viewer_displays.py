"""The viewer's smaller displays: what each draws and says."""

import math

import numpy as np
import pytest
from geometry_msgs.msg import (
    AccelStamped,
    Point,
    Point32,
    PointStamped,
    PolygonStamped,
    PoseStamped,
    PoseWithCovarianceStamped,
    TransformStamped,
    TwistStamped,
    WrenchStamped,
)
from map_msgs.msg import OccupancyGridUpdate
from nav2_msgs.msg import Particle, ParticleCloud
from nav_msgs.msg import GridCells, OccupancyGrid, Odometry, Path
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import ChannelFloat32, LaserScan, PointCloud, Range, Temperature
from tf2_msgs.msg import TFMessage
from tf2_ros import TransformBroadcaster

from coursekit.lab.errors import BadArgument
from coursekit.lab.viewer import viewer
from coursekit.view.scene_shapes import Lines, Points, Triangles
from tests.lab.viewer_stage import scan_of, show


def test_axes_stand_in_their_frame_or_name_it(session, talker):
    panel = viewer(fixed_frame="map", displays=["Axes", {"type": "Axes", "name": "far", "reference_frame": "moon"}])
    assert "Transform OK" not in panel.status("far") and "[moon]" in panel.status("far")
    (thing,) = panel.stage.scene.things.values()
    ends = [shape.vertices.max(axis=0) for shape in thing.shapes]
    assert [int(np.argmax(end)) for end in ends] == [0, 1, 2] and max(ends[0]) == 1.0


def test_a_polygon_is_closed(session, talker):
    msg = PolygonStamped()
    msg.polygon.points = [Point32(x=0.0), Point32(x=1.0), Point32(x=1.0, y=1.0)]
    (line,), said, _ = show(session, talker, "Polygon", msg)
    assert isinstance(line, Lines) and len(line.points) == 6
    assert line.points[-1].tolist() == line.points[0].tolist() and said == "Ok: 1 message received; 3 points"


def test_a_polygon_without_numbers_is_refused(session, talker):
    msg = PolygonStamped()
    msg.polygon.points = [Point32(x=math.nan)]
    shapes, said, _ = show(session, talker, "Polygon", msg)
    assert not shapes and "invalid floating point values" in said


def test_cells_lie_about_their_points(session, talker):
    msg = GridCells(cell_width=0.5, cell_height=0.25, cells=[Point(), Point(x=2.0)])
    (shape,), said, _ = show(session, talker, "GridCells", msg)
    assert shape.vertices.min(axis=0)[:2].tolist() == [-0.25, -0.125]
    assert shape.vertices.max(axis=0)[:2].tolist() == [2.25, 0.125]
    assert "2 cells of 0.5 by 0.25 m" in said


def test_the_last_points_stay(session, talker):
    kind = {"type": "PointStamped", "history_length": 2, "radius": 0.5}
    _, _, things = show(session, talker, kind, *(PointStamped(point=Point(x=float(n))) for n in range(4)))
    assert [thing.pose[0] for thing in things] == [2.0, 3.0]
    assert things[0].shapes[0].vertices.max() == pytest.approx(0.5)


def test_a_range_is_a_cone_as_wide_as_the_sensor_sees(session, talker):
    msg = Range(field_of_view=math.pi / 2, min_range=0.1, max_range=4.0, range=2.0)
    (cone,), said, _ = show(session, talker, "Range", msg)
    assert cone.vertices.max(axis=0) == pytest.approx([2.0, 2.0, 2.0], abs=1e-6) and said.endswith("2 m")


@pytest.mark.parametrize("far", [math.inf, math.nan, 0.05, 5.0])
def test_a_range_out_of_reach_shows_nothing(session, talker, far):
    shapes, said, _ = show(session, talker, "Range", Range(field_of_view=0.5, min_range=0.1, max_range=4.0, range=far))
    assert not shapes and "Nothing between 0.1 and 4 m" in said


@pytest.mark.parametrize(
    ("kind", "type_", "part", "along", "about", "scale"),
    [
        ("Wrench", WrenchStamped, "wrench", "force", "torque", 2.0),
        ("TwistStamped", TwistStamped, "twist", "linear", "angular", 1.0),
        ("AccelStamped", AccelStamped, "accel", "linear", "angular", 1.0),
    ],
)
def test_a_screw_has_an_arrow_as_long_as_its_vector_and_a_ring_about_the_other(
    session, talker, kind, type_, part, along, about, scale
):
    msg = type_()
    getattr(getattr(msg, part), along).y = 1.5
    getattr(getattr(msg, part), about).z = 1.0
    shapes, said, _ = show(session, talker, kind, msg)
    arrow, axis, ring = shapes
    assert arrow.vertices[:, 1].max() == pytest.approx(1.5 * scale)
    assert axis.vertices[:, 2].max() == pytest.approx(scale)
    assert np.ptp(ring.vertices[:, 2]) < 0.1 * scale < np.ptp(ring.vertices[:, 0])
    assert f"{along} 1.5, {about} 1" in said
    getattr(getattr(msg, part), along).y = math.nan
    assert "invalid floating point values" in show(session, talker, kind, msg)[1]


def test_the_doubt_of_a_pose_is_an_ellipse_in_the_headers_frame(session, talker):
    msg = PoseWithCovarianceStamped()
    msg.pose.pose.orientation.z = msg.pose.pose.orientation.w = math.sqrt(0.5)
    msg.pose.covariance[0], msg.pose.covariance[7], msg.pose.covariance[35] = 4.0, 1.0, 0.25
    (_, ellipse, fan), _, (thing,) = show(session, talker, "PoseWithCovariance", msg)
    # In the pose's frame, turned by 90 degrees, what is long along the header's x lies along y.
    assert ellipse.vertices.max(axis=0) == pytest.approx([1.0, 2.0, 0.001], abs=0.01)
    assert thing.pose[5:] == pytest.approx((math.sqrt(0.5), math.sqrt(0.5)))
    assert np.degrees(np.arctan2(fan.vertices[1:, 1], fan.vertices[1:, 0])).max() == pytest.approx(np.degrees(0.5))
    without, _, _ = show(session, talker, {"type": "PoseWithCovariance", "covariance": False, "shape": "Axes"}, msg)
    assert len(without) == 3


def test_a_matrix_that_is_no_covariance_shows_the_pose_alone(session, talker):
    msg = PoseWithCovarianceStamped()
    msg.pose.covariance[0] = -1.0
    assert len(show(session, talker, "PoseWithCovariance", msg)[0]) == 1


def test_odometry_shows_its_doubt_when_asked(session, talker):
    msg = Odometry()
    msg.pose.covariance[0] = 1.0
    assert len(show(session, talker, "Odometry", msg)[0]) == 1
    assert len(show(session, talker, {"type": "Odometry", "covariance": True}, msg)[0]) == 2


def test_likelier_particles_have_longer_arrows(session, talker):
    cloud = ParticleCloud(particles=[Particle(weight=0.1), Particle(weight=1.0), Particle(weight=math.nan)])
    (shape,), said, _ = show(session, talker, "ParticleCloud", cloud)
    tips = shape.vertices.reshape(2, 7, 3)[:, 6, 0]
    assert tips.tolist() == pytest.approx([0.02 + 0.28 * 0.1, 0.3]) and "2 particles" in said


def test_an_old_cloud_is_coloured_by_its_intensity(session, talker):
    cloud = PointCloud(points=[Point32(), Point32(x=1.0)], channels=[ChannelFloat32(name="intensity", values=[0.0, 9.0])])
    (shape,), _, _ = show(session, talker, "PointCloud", cloud)
    assert isinstance(shape, Points) and shape.colours is not None
    assert shape.colours[0, 2] > shape.colours[0, 0] and shape.colours[1, 0] > shape.colours[1, 2]


def test_a_temperature_is_a_dot_from_blue_to_red(session, talker):
    for celsius, channel in ((0.0, 2), (100.0, 0)):
        (dot, label), said, _ = show(session, talker, "Temperature", Temperature(temperature=celsius))
        assert int(np.argmax(dot.colours[0])) == channel and label.text == f"{celsius:g} °C" and label.text in said


def test_scans_stay_as_long_as_decay_time_says(session, talker):
    panel = viewer(fixed_frame="map", displays=[{"type": "LaserScan", "decay_time": 1.0}])
    publisher = talker.create_publisher(LaserScan, "/scan", 10)
    counts = []
    for pause in (0.1, 0.1, 0.1, 1.5):
        publisher.publish(scan_of(1.0))
        session.clock.sleep(pause)
        panel.stage.update()
        counts.append(len(panel.stage.scene.things))
    assert counts == [1, 2, 3, 1], "the newest one stays"


def test_points_as_boxes(session, talker):
    (shape,), _, _ = show(session, talker, {"type": "LaserScan", "style": "Boxes", "size": 0.1}, scan_of(2.0))
    assert isinstance(shape, Triangles) and shape.vertices[:, 0].max() == pytest.approx(2.05)


def test_a_qos_that_does_not_fit_is_told(session, talker):
    quick = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    talker.create_publisher(LaserScan, "/scan", quick)
    panel = viewer(fixed_frame="map", displays=[{"type": "LaserScan", "reliability": "Reliable"}])
    assert "Best effort publisher and reliable subscription" in panel.status("LaserScan")


def test_the_qos_of_the_options_is_asked_for(session, talker):
    options = {"type": "Polygon", "reliability": "Reliable", "durability": "Transient Local", "depth": 1}
    quality = viewer(displays=[options]).stage.displays[0].quality
    assert (quality.reliability, quality.durability) == (ReliabilityPolicy.RELIABLE, DurabilityPolicy.TRANSIENT_LOCAL)
    assert quality.depth == 1
    with pytest.raises(ValueError, match="it is one of Reliable, Best Effort"):
        viewer(displays=[{"type": "Polygon", "reliability": "reliable"}])
    with pytest.raises(BadArgument, match="Grd"):
        viewer(displays=["Grd"])


def test_what_changes_in_a_map_is_painted(session, talker):
    grid = OccupancyGrid(data=[0] * 6)
    grid.header.frame_id, grid.info.width, grid.info.height, grid.info.resolution = "map", 3, 2, 0.5
    panel = viewer(fixed_frame="map", displays=["Map /costmap"])
    updates = talker.create_publisher(OccupancyGridUpdate, "/costmap_updates", 10)
    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    talker.create_publisher(OccupancyGrid, "/costmap", lasting).publish(grid)
    session.clock.sleep(0.1)
    panel.stage.update()
    updates.publish(OccupancyGridUpdate(x=1, y=1, width=2, height=1, data=[100, 50]))
    updates.publish(OccupancyGridUpdate(x=2, y=1, width=2, height=1, data=[1, 1]))
    session.clock.sleep(0.1)
    assert "2 x 1 cells at (2, 1) is outside" in panel.status("Map")
    ((picture,),) = [thing.shapes for thing in panel.stage.scene.things.values()]
    assert picture.image[0, :, 0].tolist() == [255, 0, 128], "the upper row"
    assert picture.image[1, :, 0].tolist() == [255, 255, 255]


def test_a_map_stands_where_its_frame_is_now(session, talker):
    """As in RViz, where the fixed frame is the robot's: the map goes with tf, whatever its stamp."""
    lasting = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    frames = talker.create_publisher(TFMessage, "/tf", 10)
    panel = viewer(fixed_frame="odom", displays=["Map"])

    def places():
        grid = OccupancyGrid(data=[0] * 4)
        grid.header.frame_id, grid.info.width, grid.info.height, grid.info.resolution = "map", 2, 2, 0.5
        grid.header.stamp.sec = 1  # long before the first transform
        talker.create_publisher(OccupancyGrid, "/map", lasting).publish(grid)
        for x in (1.0, 3.0):
            moved = TransformStamped(child_frame_id="odom")
            moved.header.frame_id, moved.header.stamp = "map", talker.get_clock().now().to_msg()
            moved.transform.translation.x = x
            frames.publish(TFMessage(transforms=[moved]))
            session.clock.sleep(0.5)
            panel.stage.update()
            (thing,) = [drawn for (key, name), drawn in panel.stage.scene.things.items() if name == "map"]
            yield round(thing.pose[0], 3)

    assert list(places()) == [-1.0, -3.0]


@pytest.mark.parametrize(
    "kind, length, msg",
    [
        ("Path", "buffer_length", Path(poses=[PoseStamped(), PoseStamped()])),
        ("Range", "buffer_length", Range(range=1.0, max_range=2.0, field_of_view=0.2)),
        ("Wrench", "history_length", WrenchStamped()),
        ("PointStamped", "history_length", PointStamped()),
    ],
)
def test_as_many_of_the_last_messages_stay_as_are_wanted(session, talker, kind, length, msg):
    _, _, things = show(session, talker, {"type": kind, length: 3}, *[msg] * 5)
    assert len(things) == 3
    _, _, things = show(session, talker, kind, *[msg] * 5)
    assert len(things) == 1


def test_a_frame_fades_when_it_has_not_changed_for_long_whatever_its_stamps_say(session, talker):
    """A simulation's stamps begin at 0, hours after the viewer's clock, and RViz counts from the last change."""
    session.clock.sleep(3600.0)
    broadcaster, moves = TransformBroadcaster(talker), TransformStamped(child_frame_id="base")
    moves.header.frame_id = "map"
    panel = viewer(fixed_frame="map", displays=["TF"])
    for second in range(1, 20):
        moves.header.stamp.sec = second
        broadcaster.sendTransform(moves)
        session.clock.sleep(1.0)
        assert panel.status("TF").startswith("Ok"), panel.status("TF")
    session.clock.sleep(14.0)
    assert "No new transform" not in panel.status("TF")
    session.clock.sleep(2.0)
    assert "No new transform for [base] for 15 s" in panel.status("TF")
