"""image_proc and depth_image_proc: straight lines from a bent image, and points where a depth camera saw them."""

import math

import numpy as np
import pytest
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription, LaunchService
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image, PointCloud2
from sensor_msgs_py.point_cloud2 import read_points

WIDTH, HEIGHT, FOCUS = 8, 6, 4.0
CENTER = (3.5, 2.5)
SMALL = Image(height=2, width=2, step=2, encoding="mono8", data=bytes(4))


def info(distortion=(), focus=FOCUS):
    cx, cy = CENTER
    camera_info = CameraInfo(width=WIDTH, height=HEIGHT, distortion_model="plumb_bob", d=list(distortion))
    camera_info.k, camera_info.r = [focus, 0.0, cx, 0.0, focus, cy, 0.0, 0.0, 1.0], np.eye(3).ravel().tolist()
    camera_info.p = [focus, 0.0, cx, 0.0, 0.0, focus, cy, 0.0, 0.0, 0.0, 1.0, 0.0]
    return camera_info


def image(array, encoding):
    array = np.ascontiguousarray(array)
    return Image(height=HEIGHT, width=WIDTH, encoding=encoding, step=array.nbytes // HEIGHT, data=array.tobytes())


def send(friend, *pairs, seconds=2.0):
    """Publish messages on their topics, with the same new stamp each time."""
    outs = [(friend.node.create_publisher(type(msg), topic, qos_profile_sensor_data), msg) for topic, msg in pairs]

    def tell():
        for out, msg in outs:
            msg.header.stamp, msg.header.frame_id = friend.node.get_clock().now().to_msg(), "optical"
            out.publish(msg)

    friend.node.create_timer(0.2, tell)
    friend.spin(seconds)


def clouds(friend):
    heard = []
    friend.node.create_subscription(PointCloud2, "/points", heard.append, qos_profile_sensor_data)
    return heard


@pytest.mark.parametrize(("encoding", "scale"), [("16UC1", 1000), ("32FC1", 1)])
def test_points_lie_where_their_pixels_look(run, friend, encoding, scale):
    heard = clouds(friend)
    run("depth_image_proc", "point_cloud_xyz_node")
    depth = np.full((HEIGHT, WIDTH), 2 * scale, np.uint16 if scale > 1 else np.float32)
    depth[0, 0] = 0 if scale > 1 else np.inf
    send(friend, ("image_rect", image(depth, encoding)), ("camera_info", info()))
    cloud = heard[-1]
    assert (cloud.height, cloud.width, cloud.point_step, cloud.is_dense) == (HEIGHT, WIDTH, 16, False)
    points = read_points(cloud).reshape(HEIGHT, WIDTH)
    assert math.isnan(points[0, 0]["z"])
    corner = points[HEIGHT - 1, WIDTH - 1]
    wanted = [(WIDTH - 1 - CENTER[0]) * 2 / FOCUS, (HEIGHT - 1 - CENTER[1]) * 2 / FOCUS, 2.0]
    assert [float(corner[name]) for name in "xyz"] == pytest.approx(wanted)
    assert cloud.header.frame_id == "optical"


def test_a_component_colors_its_points(session, friend):
    heard = clouds(friend)
    node = ComposableNode(
        package="depth_image_proc",
        plugin="depth_image_proc::PointCloudXyzrgbNode",
        remappings=[
            ("rgb/image_rect_color", "color"),
            ("rgb/camera_info", "info"),
            ("depth_registered/image_rect", "depth"),
        ],
    )
    box = ComposableNodeContainer(
        name="box",
        namespace="",
        package="rclcpp_components",
        executable="component_container",
        composable_node_descriptions=[node],
    )

    def main():
        service = LaunchService()
        service.include_launch_description(LaunchDescription([box]))
        return service.run()

    launch = session.start(main, name="launch")
    color = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
    color[2, 3] = (200, 100, 50)
    depth = image(np.ones((HEIGHT, WIDTH), np.float32), "32FC1")
    send(friend, ("depth", depth), ("color", image(color, "rgb8")), ("info", info()))
    launch.interrupt()
    launch.wait(5.0)
    point = read_points(heard[-1]).reshape(HEIGHT, WIDTH)[2, 3]
    assert heard[-1].point_step == 32 and point["rgb"].view(np.uint32) == (200 << 16) | (100 << 8) | 50


@pytest.mark.parametrize(
    ("depth", "color", "said"),
    [
        (image(np.ones((HEIGHT, WIDTH, 3), np.uint8), "rgb8"), image(np.ones((HEIGHT, WIDTH), np.uint8), "mono8"),
         "Depth image has unsupported encoding [rgb8]"),
        (image(np.ones((HEIGHT, WIDTH), np.float32), "32FC1"), SMALL,
         "Depth resolution (8x6) does not match RGB resolution (2x2)"),
    ],
)  # fmt: skip
def test_images_that_do_not_fit_are_told(run, friend, depth, color, said):
    node = run("depth_image_proc", "point_cloud_xyzrgb_node")
    pairs = ("depth_registered/image_rect", depth), ("rgb/image_rect_color", color), ("rgb/camera_info", info())
    send(friend, *pairs, seconds=1.0)
    assert said in node.output


def test_a_bent_image_is_straightened_and_a_straight_one_passes(run, friend):
    heard = friend.hear(Image, "/image_rect")
    run("image_proc", "rectify_node")
    columns = np.tile(np.arange(WIDTH, dtype=np.uint8) * 30, (HEIGHT, 1))
    send(friend, ("image", image(columns, "mono8")), ("camera_info", info()))
    assert bytes(heard[-1].data) == columns.tobytes()
    before = len(heard)
    send(friend, ("image", image(columns, "mono8")), ("camera_info", info(distortion=(-0.3, 0.0, 0.0, 0.0, 0.0))))
    straight = np.frombuffer(bytes(heard[-1].data), np.uint8).reshape(HEIGHT, WIDTH)
    assert len(heard) > before and straight[2, 7] < 210, "its edge shows what the lens had pulled inwards"
    assert heard[-1].encoding == "mono8"


def test_a_camera_without_calibration_is_told(run, friend):
    friend.hear(Image, "/image_rect")
    node = run("image_proc", "rectify_node")
    send(friend, ("image", image(np.ones((HEIGHT, WIDTH), np.uint8), "mono8")), ("camera_info", info(focus=0.0)))
    assert "Rectified topic '/image_rect' requested but camera publishing '/camera_info' is uncalibrated" in node.output


def heard_of(friend, *topics):
    heard = {topic: [] for topic, _ in topics}
    for topic, kind in topics:
        friend.node.create_subscription(kind, topic, heard[topic].append, 10)
    return heard


RAMP = np.arange(WIDTH * HEIGHT, dtype=np.uint8).reshape(HEIGHT, WIDTH)


@pytest.mark.parametrize(
    ("words", "size", "scale"),
    [
        (["scale_width:=0.5", "scale_height:=0.5"], (4, 3), (0.5, 0.5)),
        (["use_scale:=false", "width:=16", "height:=6", "interpolation:=0"], (16, 6), (2.0, 1.0)),
    ],
)
def test_a_resized_image_has_its_cameras_numbers_resized(run, friend, words, size, scale):
    run("image_proc", "resize_node", "--ros-args", *(part for word in words for part in ("-p", word)))
    heard = heard_of(friend, ("/resize/image_raw", Image), ("/resize/camera_info", CameraInfo))
    send(friend, ("image/image_raw", image(RAMP, "mono8")), ("image/camera_info", info()))
    image_message, told = heard["/resize/image_raw"][-1], heard["/resize/camera_info"][-1]
    assert (image_message.width, image_message.height, image_message.encoding) == (*size, "mono8") and (
        told.width,
        told.height,
    ) == size
    assert told.header == image_message.header and told.header.frame_id == "optical"
    assert [told.k[0], told.k[2], told.k[4], told.k[5]] == [
        FOCUS * scale[0], CENTER[0] * scale[0], FOCUS * scale[1], CENTER[1] * scale[1],
    ]  # fmt: skip
    assert (told.p[0], told.p[6]) == (FOCUS * scale[0], CENTER[1] * scale[1])


def test_a_cropped_image_says_where_it_was_cut_out(run, friend):
    words = ["offset_x:=2", "offset_y:=1", "width:=4", "height:=100", "decimation_x:=2", "decimation_y:=1"]
    run("image_proc", "crop_decimate_node", "--ros-args", *(part for word in words for part in ("-p", word)))
    heard = heard_of(friend, ("/out/image_raw", Image), ("/out/camera_info", CameraInfo))
    send(friend, ("in/image_raw", image(RAMP, "mono8")), ("in/camera_info", info()))
    image_message, told = heard["/out/image_raw"][-1], heard["/out/camera_info"][-1]
    assert (
        np.frombuffer(image_message.data, np.uint8).reshape(image_message.height, image_message.width).tolist()
        == RAMP[1:, 2:6:2].tolist()
    )
    assert (told.binning_x, told.binning_y) == (2, 1) and told.k.tolist() == info().k.tolist()
    cut = told.roi
    assert (cut.x_offset, cut.y_offset, cut.width, cut.height, cut.do_rectify) == (2, 1, 4, HEIGHT - 1, True)


def test_colours_are_made_of_a_sensors_mosaic(run, friend):
    run("image_proc", "debayer_node")
    heard = heard_of(friend, ("/image_color", Image), ("/image_mono", Image))
    mosaic = np.zeros((HEIGHT, WIDTH), np.uint8)
    mosaic[0::2, 0::2] = 200  # red alone
    send(friend, ("image_raw", image(mosaic, "bayer_rggb8")))
    colour, grey = heard["/image_color"][-1], heard["/image_mono"][-1]
    assert (colour.encoding, grey.encoding) == ("bgr8", "mono8")
    assert np.frombuffer(colour.data, np.uint8).reshape(HEIGHT, WIDTH, 3)[3, 3].tolist() == [0, 0, 200]
    assert 50 < np.frombuffer(grey.data, np.uint8).reshape(HEIGHT, WIDTH)[3, 3] < 70


def test_a_grey_image_has_no_colours_and_that_is_told(run, friend):
    process = run("image_proc", "debayer_node")
    heard = heard_of(friend, ("/image_color", Image))
    send(friend, ("image_raw", image(RAMP, "mono8")))
    assert heard["/image_color"][-1].encoding == "mono8"
    assert "requested, but raw image data from topic '/image_raw' is grayscale" in process.output


def launched(session, *entities):
    """Start a launch of the entities; the process."""

    def main():
        service = LaunchService()
        service.include_launch_description(LaunchDescription(entities))
        return service.run()

    return session.start(main, name="launch")


def whole_pipeline(**words):
    place = get_package_share_directory("image_proc") + "/launch/image_proc.launch.py"
    return IncludeLaunchDescription(PythonLaunchDescriptionSource(place), launch_arguments=words.items())


@pytest.mark.parametrize("place", ["", "/left"])
def test_one_launch_file_takes_a_raw_image_to_straight_colours_and_greys(session, friend, place):
    launch = launched(session, whole_pipeline(namespace=place))
    topics = [f"{place}/image_rect", f"{place}/image_rect_color"]
    heard = heard_of(friend, *((topic, Image) for topic in topics))
    raw = image(np.full((HEIGHT, WIDTH, 3), 90, np.uint8), "rgb8")
    send(friend, (f"{place}/image_raw", raw), (f"{place}/camera_info", info()), seconds=4.0)
    names = friend.node.get_node_names()
    launch.interrupt()
    launch.wait(5.0)
    assert [heard[topic][-1].encoding for topic in topics] == ["mono8", "rgb8"]
    assert {"image_proc_container", "debayer_node", "rectify_mono_node", "rectify_color_node"} <= set(names)


def test_the_pipeline_goes_into_a_container_that_is_there(session, friend):
    box = Node(package="rclcpp_components", executable="component_container", name="box")
    launch = launched(session, box, whole_pipeline(container="box"))
    friend.spin(4.0)
    names = friend.node.get_node_names()
    launch.interrupt()
    launch.wait(5.0)
    assert {"box", "debayer_node", "rectify_color_node"} <= set(names) and "image_proc_container" not in names
