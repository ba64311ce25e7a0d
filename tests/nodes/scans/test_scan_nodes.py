"""Nodes that make and filter scans, on the virtual clock."""

import math

import numpy as np
import pytest
from cv_bridge import CvBridge
from geometry_msgs.msg import TransformStamped
from laser_geometry import LaserProjection
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, LaserScan, PointCloud2
from sensor_msgs_py.point_cloud2 import create_cloud_xyz32, read_points
from std_msgs.msg import Header
from tf2_ros import StaticTransformBroadcaster


def scan(ranges, **more):
    msg = LaserScan(angle_min=-1.0, angle_increment=2.0 / (len(ranges) - 1), angle_max=1.0, range_max=10.0, ranges=ranges)
    msg.header.frame_id = more.pop("frame", "laser")
    return msg


def mount(friend, parent, child, x=0.0, z=0.0):
    msg = TransformStamped(child_frame_id=child)
    msg.header.frame_id, msg.transform.translation.x, msg.transform.translation.z = parent, x, z
    friend.tf = StaticTransformBroadcaster(friend.node)
    friend.tf.sendTransform(msg)


def filtered(friend, run, tmp_path, text, msg):
    file = tmp_path / "filters.yaml"
    file.write_text("scan_to_scan_filter_chain:\n  ros__parameters:\n" + text)
    process = run("laser_filters", "scan_to_scan_filter_chain", "--ros-args", "--params-file", str(file))
    heard = friend.hear(LaserScan, "scan_filtered")
    friend.spin(0.2)
    friend.say("scan", msg)
    friend.spin(0.2)
    return heard[0] if heard else process.output


def test_a_cloud_becomes_a_scan_in_another_frame_while_somebody_listens(friend, run):
    mount(friend, "base_link", "camera", x=1.0, z=0.5)
    options = ["target_frame:=base_link", "min_height:=0.2", "max_height:=1.0", "range_max:=20.0", "range_min:=0.1"]
    words = [word for option in options for word in ("-p", option)]
    process = run("pointcloud_to_laserscan", "pointcloud_to_laserscan_node", "--ros-args", *words)
    friend.spin(0.3)
    assert friend.node.count_subscribers("cloud_in") == 0
    heard = friend.hear(LaserScan, "scan", qos_profile_sensor_data)
    friend.spin(0.3)
    assert "Got a subscriber to laserscan, starting pointcloud subscriber" in process.output
    friend.say("cloud_in", create_cloud_xyz32(Header(frame_id="camera"), [[2.0, 0.01, 0.0], [1.0, 0.01, -1.0]]))
    friend.spin(0.2)
    seen = np.asarray(heard[0].ranges)
    assert heard[0].header.frame_id == "base_link" and len(seen) == 360
    assert seen[180] == pytest.approx(3.0, abs=0.01) and np.isinf(np.delete(seen, 180)).all()


def test_a_scan_becomes_a_cloud(friend, run):
    run("pointcloud_to_laserscan", "laserscan_to_pointcloud_node")
    heard = friend.hear(PointCloud2, "cloud", qos_profile_sensor_data)
    friend.spin(0.4)
    friend.say("scan_in", scan([2.0, 3.0, math.inf]))
    friend.spin(0.2)
    points = read_points(heard[0], ["x", "y"])
    assert [tuple(map(float, point)) for point in points][1] == pytest.approx((3.0, 0.0)) and len(points) == 2


@pytest.mark.parametrize("encoding, wall", [("32FC1", 2.0), ("16UC1", 2000)])
def test_a_depth_image_becomes_a_scan(friend, run, encoding, wall):
    run("depthimage_to_laserscan", "depthimage_to_laserscan_node", "--ros-args", "-p", "output_frame:=camera_link")
    heard = friend.hear(LaserScan, "scan")
    friend.spin(0.2)
    image = np.full((24, 32), wall, np.float32 if encoding == "32FC1" else np.uint16)
    info = CameraInfo(k=[30.0, 0.0, 15.5, 0.0, 30.0, 11.5, 0.0, 0.0, 1.0])
    friend.say("depth", CvBridge().cv2_to_imgmsg(image, encoding))
    friend.spin(0.1)
    assert not heard
    friend.say("depth_camera_info", info)
    friend.spin(0.1)
    friend.say("depth", CvBridge().cv2_to_imgmsg(image, encoding))
    friend.spin(0.1)
    assert heard[0].header.frame_id == "camera_link" and np.nanmin(heard[0].ranges) == pytest.approx(2.0, abs=0.01)


def test_a_chain_of_filters_works_in_its_order(friend, run, tmp_path):
    text = """
    filter1: {name: near, type: laser_filters/LaserScanRangeFilter, params: {lower_threshold: 0.5, upper_threshold: 5.0}}
    filter2: {name: front, type: laser_filters/LaserScanAngularBoundsFilter, params: {lower_angle: -0.6, upper_angle: 0.6}}
"""
    filtered_scan = filtered(friend, run, tmp_path, text, scan([1.0, 0.1, 2.0, 7.0, 3.0]))
    assert filtered_scan.angle_min == pytest.approx(-0.5) and filtered_scan.angle_max == pytest.approx(0.5)
    assert np.isnan(filtered_scan.ranges).tolist() == [True, False, True] and filtered_scan.ranges[1] == 2.0


def test_the_robot_itself_is_cut_out_by_a_box(friend, run, tmp_path):
    mount(friend, "base_link", "laser", x=0.2)
    text = """
    filter1:
      name: robot
      type: laser_filters/LaserScanBoxFilter
      params: {box_frame: base_link, min_x: -0.5, max_x: 0.8, min_y: -0.5, max_y: 0.5, min_z: -1.0, max_z: 1.0}
"""
    filtered_scan = filtered(friend, run, tmp_path, text, scan([2.0, 0.5, 0.7]))
    assert np.isnan(filtered_scan.ranges).tolist() == [False, True, False]


@pytest.mark.parametrize(
    "text, told",
    [("    filter1: {name: a, type: laser_filters/Magic}\n", "of type 'laser_filters/Magic'"),
     ("    filter1: {name: a, type: laser_filters/LaserScanBoxFilter}\n", "was not given box_frame, min_x")],
)  # fmt: skip
def test_filters_that_cannot_work_are_told(friend, run, tmp_path, text, told):
    assert told in filtered(friend, run, tmp_path, text, scan([1.0, 2.0]))


def test_the_projection_has_the_channels_that_are_asked_for():
    msg = scan([2.0, 3.0])
    msg.intensities = [7.0, 8.0]
    option = LaserProjection.ChannelOption
    cloud = LaserProjection().projectLaser(msg, channel_options=option.INTENSITY | option.DISTANCE | option.INDEX)
    assert [field.name for field in cloud.fields] == ["x", "y", "z", "intensity", "index", "distances"]
    assert [tuple(point) for point in read_points(cloud, ["intensity", "distances"])] == [(7.0, 2.0), (8.0, 3.0)]
