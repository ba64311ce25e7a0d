"""apriltag_node: tags that are drawn where they are known to be."""

from pathlib import Path

import cv2
import numpy as np
import pytest
from ament_index_python.packages import get_package_share_directory
from apriltag_msgs.msg import AprilTagDetectionArray
from cv_bridge import CvBridge
from rclpy.time import Time
from scipy.spatial.transform import Rotation
from sensor_msgs.msg import CameraInfo, CompressedImage
from tf2_ros import Buffer, TransformListener

from coursekit.nodes.apriltag.detector import Detector

CAMERA = np.array([[500.0, 0.0, 320.0], [0.0, 500.0, 240.0], [0.0, 0.0, 1.0]])
FIRST_36H11 = 0xD5D628584
"""The first code of the AprilTag library's family 36h11, row by row from the upper left, 1 for white."""


def drawn(number, flipped=()):
    """A tag as the AprilTag library prints it, 10 pixels a cell, with a white margin of a cell; some bits are wrong."""
    codes = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)
    tag = cv2.rotate(cv2.aruco.generateImageMarker(codes, number, 80), cv2.ROTATE_180)
    for row, column in flipped:
        cell = tag[10 + 10 * row : 20 + 10 * row, 10 + 10 * column : 20 + 10 * column]
        cell[:] = 255 - cell
    return np.pad(tag, 10, constant_values=255)


def seen(number, turn, place, size=0.16, flipped=()):
    """The image of a tag: its x to the right, y up, z out of it."""
    corners = np.array([[-1, 1, 0], [1, 1, 0], [1, -1, 0], [-1, -1, 0]]) * size / 2 * 100 / 80  # with its margin
    at = (CAMERA @ (Rotation.from_rotvec(turn).apply(corners) + place).T).T
    page = np.array([[0, 0], [100, 0], [100, 100], [0, 100]], np.float32) - 0.5
    turned = cv2.getPerspectiveTransform(page, (at[:, :2] / at[:, 2:]).astype(np.float32))
    return cv2.warpPerspective(drawn(number, flipped), turned, (640, 480), borderValue=128)


FACING, PLACE = np.array([np.pi, 0.0, 0.0]), np.array([0.1, -0.05, 0.6])
TILTED = (Rotation.from_rotvec(FACING) * Rotation.from_euler("xyz", [0.4, -0.3, 0.5])).as_rotvec()


def test_the_library_s_first_tag_is_number_0_and_begins_at_its_lower_left():
    bits = np.array([int(bit) for bit in f"{FIRST_36H11:036b}"], np.uint8).reshape(6, 6) * 255
    page = np.kron(np.pad(np.pad(bits, 1), 2, constant_values=255), np.ones((20, 20), np.uint8))
    (tag,) = Detector("36h11").find(page)
    assert (tag.id, tag.hamming) == (0, 0) and tag.margin > 100
    assert tag.corners == pytest.approx(np.array([[40, 200], [200, 200], [200, 40], [40, 40]]) - 0.5, abs=1.0)
    assert tag.centre == pytest.approx([119.5, 119.5], abs=1.0)


@pytest.mark.parametrize("turn", [FACING, TILTED])
def test_a_tag_is_where_it_is(turn):
    (tag,) = Detector("36h11").find(seen(7, turn, PLACE))
    rotation, place = tag.pose(0.16, CAMERA)
    assert tag.id == 7 and place == pytest.approx(PLACE, abs=0.006)
    assert (Rotation.from_rotvec(rotation).inv() * Rotation.from_rotvec(turn)).magnitude() < 0.06
    middle = tag.homography @ [0.0, 0.0, 1.0]
    assert middle[:2] / middle[2] == pytest.approx((CAMERA @ PLACE)[:2] / PLACE[2], abs=1.5)


def test_wrong_bits_are_counted_and_only_so_many_allowed():
    image = seen(7, FACING, PLACE, flipped=((0, 0), (3, 2)))
    assert Detector("36h11").find(image) == [] == Detector("36h11").find(image, most=1)
    (tag,) = Detector("36h11").find(image, most=2)
    assert (tag.id, tag.hamming) == (7, 2)


@pytest.fixture
def look(run, friend):
    """look(image, parameter=value) gives the detections of an image, and where tf has its frames."""
    buffer = Buffer()
    TransformListener(buffer, friend.node)

    def show(image, *words, compressed=False, **given):
        given = [word for name, value in given.items() for word in ("-p", f"{name.replace('__', '.')}:={value}")]
        process = run("apriltag_ros", "apriltag_node", "--ros-args", *given, *words)
        heard = friend.hear(AprilTagDetectionArray, "detections")
        friend.spin(0.3)
        info = CameraInfo(width=640, height=480, p=np.pad(CAMERA, ((0, 0), (0, 1))).ravel())
        msg = CvBridge().cv2_to_imgmsg(image, "mono8")
        if compressed:
            msg = CvBridge().cv2_to_compressed_imgmsg(image, "png")
        msg.header.frame_id = info.header.frame_id = "camera"
        msg.header.stamp = info.header.stamp = friend.node.get_clock().now().to_msg()
        topic = "image_rect/compressed" if isinstance(msg, CompressedImage) else "image_rect"
        for _ in range(2):
            friend.say(topic, msg)
            friend.say("camera_info", info)
            friend.spin(0.3)
        assert heard, process.output
        return heard[-1], buffer

    return show


@pytest.mark.parametrize("compressed", [False, True])
def test_a_tag_is_published_and_has_a_frame(look, compressed):
    transport = {"image_transport": "compressed"} if compressed else {}
    detections, buffer = look(seen(7, TILTED, PLACE), compressed=compressed, size=0.16, **transport)
    (tag,) = detections.detections
    assert (tag.family, tag.id, tag.hamming, detections.header.frame_id) == ("tag36h11", 7, 0, "camera")
    assert (tag.centre.x, tag.centre.y) == pytest.approx((403.3, 198.3), abs=2.0)
    moved = buffer.lookup_transform("camera", "tag36h11:7", Time()).transform.translation
    assert (moved.x, moved.y, moved.z) == pytest.approx(PLACE, abs=0.006)


def test_the_example_s_file_takes_its_tags_alone(look):
    file = Path(get_package_share_directory("apriltag_ros")) / "cfg" / "tags_36h11.yaml"
    both = np.minimum(seen(9, FACING, np.array([-0.15, 0.0, 0.8]), 0.162), seen(7, FACING, np.array([0.15, 0.0, 0.8])))
    detections, buffer = look(both, "--params-file", str(file))
    assert [detection.id for detection in detections.detections] == [9]
    assert buffer.lookup_transform("camera", "base", Time()).transform.translation.z == pytest.approx(0.8, abs=0.01)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("family:=41h12",), "Unsupported tag family: 41h12"),
        (("tag.ids:=[1, 2]", "tag.frames:=[a]"), r"ids (2) and frames (1) mismatch"),
    ],
)
def test_what_cannot_be_ends_it(run, words, told):  # fmt: skip
    process = run("apriltag_ros", "apriltag_node", "--ros-args", *(part for word in words for part in ("-p", word)))
    assert process.wait(10) != 0 and told in process.output
