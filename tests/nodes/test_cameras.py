"""Drivers of cameras on the course's virtual camera, and pictures and films that are published."""

import cv2
import numpy as np
import pytest
import rclpy
from cv_bridge import CvBridge
from sensor_msgs.msg import CameraInfo, CompressedImage, Image

from coursekit.cli.parser import run as run_cli
from coursekit.view import highgui


@pytest.fixture
def heard(session, monkeypatch):
    """heard(Image, "image_raw", seconds=1.0): the messages of a topic in that time."""
    monkeypatch.setattr(highgui, "has_camera", lambda: False)
    highgui.install()
    context = rclpy.context.Context()
    rclpy.init(context=context)
    node = rclpy.create_node("viewer", context=context)
    executor = rclpy.executors.SingleThreadedExecutor(context=context)
    executor.add_node(node)

    def hear(kind, topic, seconds=1.0):
        messages = []
        subscription = node.create_subscription(kind, topic, messages.append, 100)
        until = session.clock.steady() + round(seconds * 1e9)
        while (left := until - session.clock.steady()) > 0:
            executor.spin_once(timeout_sec=left * 1e-9)
        node.destroy_subscription(subscription)
        return messages

    yield hear
    rclpy.shutdown(context=context)


def given(**parameters):
    return ["--ros-args", *(word for name, value in parameters.items() for word in ("-p", f"{name}:={value}"))]


def test_v4l2_camera_publishes_what_it_is_told_to(run, heard):
    camera = run("v4l2_camera", "v4l2_camera_node", *given(image_size="[320, 240]", time_per_frame="[1, 15]",
                                                           camera_frame_id="optical"))  # fmt: skip
    images = heard(Image, "image_raw", 2.0)
    assert 28 <= len(images) <= 32, camera.output
    assert (images[0].width, images[0].height, images[0].encoding) == (320, 240, "rgb8")
    assert images[0].header.frame_id == "optical"
    infos = heard(CameraInfo, "camera_info")
    assert (infos[0].width, infos[0].height, infos[0].k[0]) == (320, 240, 0.0)


def test_its_parameters_change_while_it_runs(run, heard, ros2):
    run("v4l2_camera", "v4l2_camera_node", *given(output_encoding="mono8"))
    assert heard(Image, "image_raw")[-1].encoding == "mono8"
    assert "successful" in ros2("param", "set", "v4l2_camera", "image_size", "[160, 120]")
    assert heard(Image, "image_raw")[-1].step == 160
    assert "one of bgr8" in ros2("param", "set", "v4l2_camera", "output_encoding", "purple")
    assert "read" in ros2("param", "set", "v4l2_camera", "video_device", "/dev/video1")


def test_without_a_device_it_says_so_and_goes_on(run, heard):
    camera = run("v4l2_camera", "v4l2_camera_node", *given(video_device="/dev/video9"))
    assert not heard(Image, "image_raw")
    assert "Failed opening device /dev/video9" in camera.output and camera.exit_code is None


def test_jpeg_is_the_same_picture(run, heard):
    run("v4l2_camera", "v4l2_camera_node")
    files = heard(CompressedImage, "image_raw/compressed", 0.5)
    assert files[0].format == "rgb8; jpeg compressed bgr8"
    picture = cv2.imdecode(np.frombuffer(files[0].data, np.uint8), cv2.IMREAD_COLOR)
    raw = CvBridge().imgmsg_to_cv2(heard(Image, "image_raw", 0.5)[-1], "bgr8")
    assert picture.shape == raw.shape and np.abs(picture.mean((0, 1)) - raw.mean((0, 1))).max() < 5


@pytest.mark.parametrize(("pixel_format", "encoding", "step"), [("yuyv", "yuv422_yuy2", 1280), ("mjpeg2rgb", "rgb8", 1920),
                                                                ("mono16", "mono16", 1280)])  # fmt: skip
def test_usb_cam_publishes_by_its_pixel_format(run, heard, pixel_format, encoding, step):
    camera = run("usb_cam", "usb_cam_node_exe", *given(pixel_format=pixel_format, framerate=10.0))
    images = heard(Image, "image_raw", 2.0)
    assert 19 <= len(images) <= 21, camera.output
    assert (images[0].encoding, images[0].step, images[0].header.frame_id) == (encoding, step, "default_cam")
    colours = CvBridge().imgmsg_to_cv2(images[0], "bgr8")
    assert colours.shape == (480, 640, 3) and colours.std() > 10


def test_usb_cam_pauses_and_sends_jpeg_alone(run, heard, ros2):
    run("usb_cam", "usb_cam_node_exe", *given(pixel_format="mjpeg"))
    assert not heard(Image, "image_raw", 0.5) and heard(CompressedImage, "image_raw/compressed", 0.5)[0].format == "jpeg"
    assert "Stop Capturing" in ros2("service", "call", "/set_capture", "std_srvs/srv/SetBool", "{data: false}")
    assert not heard(CompressedImage, "image_raw/compressed", 0.5)


@pytest.mark.parametrize(
    ("name", "value", "told"), [("pixel_format", "h264", "unsupported"), ("framerate", 0.0, "framerate")]
)
def test_usb_cam_refuses_what_no_camera_has(run, heard, name, value, told):
    camera = run("usb_cam", "usb_cam_node_exe", *given(**{name: value}))
    assert camera.wait(10) not in (0, None) and told in camera.output


def test_usb_cam_ends_without_its_device(run, heard):
    camera = run("usb_cam", "usb_cam_node_exe", *given(video_device="/dev/video9"))
    assert camera.wait(10) == 0 and "not a vaild V4L2 device: `/dev/video9`" in camera.output


def test_usb_cams_launch_file_has_a_calibrated_camera(session, heard):
    launched = session.start(lambda: run_cli(["launch", "usb_cam", "camera.launch.py"]), name="ros2", argv=["launch"])
    session.clock.sleep(1.0)
    infos = heard(CameraInfo, "camera1/camera_info")
    assert (infos[0].header.frame_id, infos[0].k[0]) == ("camera", 600.0), launched.output
    assert heard(Image, "camera1/image_raw", 0.5)[0].encoding == "rgb8"


@pytest.fixture
def picture(tmp_path):
    """A file that is red on the left, blue on the right, and darker below."""
    image = np.zeros((20, 40, 3), np.uint8)
    image[:, :20], image[:, 20:] = (0, 0, 200), (200, 0, 0)
    image[10:] //= 2
    cv2.imwrite(str(tmp_path / "two.png"), image)
    return tmp_path / "two.png"


def test_a_picture_is_published_again_and_again(run, heard, ros2, picture):
    publisher = run("image_publisher", "image_publisher_node", str(picture), *given(publish_rate=20.0, field_of_view=90.0))
    images = heard(Image, "image_raw")
    assert 19 <= len(images) <= 21, publisher.output
    assert images[0].encoding == "bgr8" and bytes(images[0].data[:3]) == b"\0\0\xc8"
    info = heard(CameraInfo, "camera_info")[0]
    assert list(info.k) == pytest.approx([20.0, 0.0, 20.0, 0.0, 20.0, 10.0, 0.0, 0.0, 1.0])
    ros2("param", "set", "/ImagePublisher", "flip_horizontal", "true")
    assert bytes(heard(Image, "image_raw")[-1].data[:3]) == b"\xc8\0\0"


def test_a_film_begins_again_at_its_end(run, heard, tmp_path):
    film = cv2.VideoWriter(str(tmp_path / "film.avi"), cv2.VideoWriter_fourcc(*"MJPG"), 10, (64, 48))
    for grey in (20, 120, 220):
        film.write(np.full((48, 64, 3), grey, np.uint8))
    film.release()
    run("image_publisher", "image_publisher_node", str(tmp_path / "film.avi"))
    greys = [CvBridge().imgmsg_to_cv2(message).mean() for message in heard(Image, "image_raw")]
    steps = np.diff([round(brightness / 100) for brightness in greys[:7]])
    assert len(greys) >= 9 and sorted(set(steps)) == [-2, 1], greys


def test_a_component_takes_its_file_from_a_parameter(session, run, heard, ros2, picture):
    run("rclcpp_components", "component_container")
    session.clock.sleep(0.2)
    loaded = ros2("component", "load", "/ComponentManager", "image_publisher", "image_publisher::ImagePublisher",
                  "-p", f"filename:={picture}")  # fmt: skip
    assert "Loaded component 1" in loaded
    assert heard(Image, "image_raw")[0].width == 40


def test_a_file_that_is_none_is_told(run, heard):
    publisher = run("image_publisher", "image_publisher_node", "nothing.png")
    assert not heard(Image, "image_raw", 0.5) and "Failed to load image (nothing.png)" in publisher.output
    empty = run("image_publisher", "image_publisher_node")
    assert empty.wait(10) == 1 and "requires filename" in empty.output
