"""Images on topics: compressed, passed on, watched."""

import cv2
import numpy as np
import pytest
from cv_bridge import CvBridge, CvBridgeError
from sensor_msgs.msg import Image

from coursekit.nodes.images.transport import compress, decompress, to_bgr
from coursekit.sim.camera import Scene
from coursekit.view import highgui

BRIDGE = CvBridge()
PICTURE = Scene().render(1.0, 160, 120)


def message(encoding):
    image = PICTURE if encoding in ("bgr8", "rgb8") else cv2.cvtColor(PICTURE, cv2.COLOR_BGR2GRAY)
    if encoding.endswith("16"):
        image = image.astype(np.uint16) * 257
    return BRIDGE.cv2_to_imgmsg(image, encoding)


@pytest.mark.parametrize(
    ("encoding", "format_", "text"),
    [
        ("bgr8", "jpeg", "bgr8; jpeg compressed bgr8"),
        ("rgb8", "jpeg", "rgb8; jpeg compressed bgr8"),
        ("mono8", "jpeg", "mono8; jpeg compressed "),
        ("rgb8", "png", "rgb8; png compressed bgr8"),
        ("mono16", "png", "mono16; png compressed "),
    ],
)
def test_the_format_says_what_it_was_and_is(encoding, format_, text):
    original = message(encoding)
    small = compress(original, format_)
    assert small.format == text
    back = decompress(small)
    assert (back.encoding, back.width, back.height) == (encoding, 160, 120)
    difference = BRIDGE.imgmsg_to_cv2(back).astype(float) - BRIDGE.imgmsg_to_cv2(original)
    assert np.abs(difference).mean() < (0.001 if format_ == "png" else 3.0)


def test_numbers_without_colours_are_not_compressed():
    with pytest.raises(CvBridgeError, match="32FC1"):
        compress(BRIDGE.cv2_to_imgmsg(np.zeros((3, 3), np.float32)))


@pytest.mark.parametrize("encoding", ["bgr8", "mono16", "bayer_rggb8", "yuv422", "32FC1", "8UC3", "16UC1"])
def test_every_image_can_be_looked_at(encoding):
    dtype, channels = BRIDGE.encoding_to_dtype_with_channels(encoding)
    image = np.ones((8, 8) if channels == 1 else (8, 8, channels), dtype)
    assert to_bgr(BRIDGE.cv2_to_imgmsg(image, encoding)).shape == (8, 8, 3)


CAMERA = """
import rclpy, cv2
from cv_bridge import CvBridge
from sensor_msgs.msg import Image

def main():
    rclpy.init()
    node = rclpy.create_node("camera")
    publisher = node.create_publisher(Image, "camera/image_raw", 1)
    camera = cv2.VideoCapture(0)
    def send():
        publisher.publish(CvBridge().cv2_to_imgmsg(camera.read()[1], "bgr8"))
    node.create_timer(0.1, send)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
"""


@pytest.fixture
def camera(session, monkeypatch):
    monkeypatch.setattr(highgui, "has_camera", lambda: False)
    monkeypatch.setattr(highgui, "has_display", lambda: False)
    highgui.install()
    names = {}
    exec(CAMERA, names)
    return session.start(names["main"], name="camera")


def test_republish_compresses_and_back(camera, run, session, ros2):
    run(
        "image_transport",
        "republish",
        "raw",
        "compressed",
        "--ros-args",
        "-r",
        "in:=/camera/image_raw",
        "-r",
        "out/compressed:=/small/compressed",
    )
    run(
        "image_transport",
        "republish",
        "compressed",
        "raw",
        "--ros-args",
        "-r",
        "in/compressed:=/small/compressed",
        "-r",
        "out:=/again",
    )
    session.clock.sleep(0.5)
    assert "sensor_msgs/msg/CompressedImage" in ros2("topic", "info", "/small/compressed")
    assert "format: bgr8; jpeg compressed bgr8" in ros2("topic", "echo", "/small/compressed", "--once", "--no-arr")
    assert "encoding: bgr8" in ros2("topic", "echo", "/again", "--once", "--no-arr")


def test_republish_says_how_it_is_used(run):
    process = run("image_transport", "republish", "raw", "theora")
    assert process.wait(2.0) == 1 and "Usage: republish" in process.output


def test_list_transports_lists_them(run):
    process = run("image_transport", "list_transports")
    assert process.wait(2.0) == 0
    assert "image_transport/compressed" in process.output and "image_transport/raw" in process.output


@pytest.mark.parametrize("argv", [("/camera/image_raw",), ()])
def test_rqt_image_view_opens_a_window_and_closes_it(camera, run, session, argv):
    viewer = run("rqt_image_view", "rqt_image_view", *argv)
    session.clock.sleep(1.0)
    assert highgui.desk().windows["/camera/image_raw"].image.shape == (480, 640, 3)
    viewer.interrupt()
    assert viewer.wait(2.0) == 0
    assert highgui.desk().windows == {}
    assert Image._TYPE_NAME == "sensor_msgs/msg/Image"
