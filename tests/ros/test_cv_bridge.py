"""Images between OpenCV and ROS."""

import cv2
import cv_bridge
import numpy as np
import pytest
from cv_bridge import CvBridge, CvBridgeError
from cv_bridge.boost import cv_bridge_boost
from cv_bridge.encodings import DTYPES, NAMED
from hypothesis import given
from hypothesis import strategies as st
from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import Header

BRIDGE = CvBridge()
RNG = np.random.default_rng(5)
PLAIN = [f"{depth}C{channels}" for depth in DTYPES for channels in (1, 2, 3, 4)]


def image_of(encoding, height=6, width=8):
    dtype, channels = BRIDGE.encoding_to_dtype_with_channels(encoding)
    shape = (height, width) if channels == 1 else (height, width, channels)
    return (RNG.random(shape) * 100).astype(dtype)


@pytest.mark.parametrize("encoding", [*NAMED, *PLAIN])
def test_every_encoding_comes_back_as_it_went(encoding):
    image = image_of(encoding)
    msg = BRIDGE.cv2_to_imgmsg(image, encoding)
    assert (msg.height, msg.width, msg.encoding) == (6, 8, encoding)
    assert msg.step == image.nbytes // 6
    for desired in ("passthrough", encoding):
        back = BRIDGE.imgmsg_to_cv2(msg, desired)
        assert back.dtype == image.dtype and np.array_equal(back, image)


@pytest.mark.parametrize(("dtype", "name"), [(np.uint8, "8UC3"), (np.float32, "32FC3"), (np.int16, "16SC3")])
def test_passthrough_names_the_type(dtype, name):
    assert BRIDGE.cv2_to_imgmsg(np.zeros((2, 3, 3), dtype)).encoding == name


@pytest.mark.parametrize(
    ("source", "target", "code"),
    [
        ("bgr8", "rgb8", cv2.COLOR_BGR2RGB),
        ("bgr8", "mono8", cv2.COLOR_BGR2GRAY),
        ("rgba8", "bgr8", cv2.COLOR_RGBA2BGR),
        ("mono8", "bgr8", cv2.COLOR_GRAY2BGR),
        ("rgb16", "bgr16", cv2.COLOR_RGB2BGR),
        ("bayer_rggb8", "bgr8", cv2.COLOR_BayerBG2BGR),
        ("yuv422", "bgr8", cv2.COLOR_YUV2BGR_UYVY),
        ("yuv422_yuy2", "mono8", cv2.COLOR_YUV2GRAY_YUY2),
    ],
)
def test_colours_are_converted_as_opencv_does(source, target, code):
    image = image_of(source)
    back = BRIDGE.imgmsg_to_cv2(BRIDGE.cv2_to_imgmsg(image, source), target)
    assert np.array_equal(back, cv2.cvtColor(image, code))


def test_eight_and_sixteen_bits_are_scaled_to_each_other():
    image = np.array([[0, 128, 255]], np.uint8)
    deep = BRIDGE.imgmsg_to_cv2(BRIDGE.cv2_to_imgmsg(image, "mono8"), "mono16")
    assert deep.tolist() == [[0, 128 * 257, 65535]] and deep.dtype == np.uint16
    assert np.array_equal(BRIDGE.imgmsg_to_cv2(BRIDGE.cv2_to_imgmsg(deep, "mono16"), "mono8"), image)


@pytest.mark.parametrize(
    ("source", "target", "text"),
    [
        ("32FC1", "mono8", "[32FC1] is not a color format. but [mono8] is. The conversion does not make sense"),
        ("8UC3", "8UC1", "[8UC3] and [8UC1] do not have the same number of channel"),
        ("bgr8", "8UC1", "[bgr8] is a color format but [8UC1] is not so they must have the same OpenCV type"),
        ("bayer_rggb8", "rgba8", "Unsupported conversion from [bayer_rggb8] to [rgba8]"),
        ("bgr8", "blue", "Unrecognized image encoding [blue]"),
    ],
)
def test_what_makes_no_sense_says_why(source, target, text):
    with pytest.raises(CvBridgeError) as error:
        BRIDGE.imgmsg_to_cv2(BRIDGE.cv2_to_imgmsg(image_of(source), source), target)
    assert text in str(error.value)


def test_an_array_that_does_not_fit_the_encoding_is_refused():
    with pytest.raises(CvBridgeError, match="encoding specified as mono8, but image has incompatible type 8UC3"):
        BRIDGE.cv2_to_imgmsg(np.zeros((2, 2, 3), np.uint8), "mono8")
    with pytest.raises(TypeError, match="Your input type is not a numpy array"):
        BRIDGE.cv2_to_imgmsg([[1, 2]])
    with pytest.raises(CvBridgeError, match="int64"):
        BRIDGE.cv2_to_imgmsg(np.zeros((2, 2), np.int64))


def test_rows_may_be_longer_than_the_picture():
    data = np.arange(20, dtype=np.uint8)
    msg = Image(height=2, width=7, step=10, encoding="mono8", data=data.tobytes())
    assert BRIDGE.imgmsg_to_cv2(msg).tolist() == [list(range(7)), list(range(10, 17))]


def test_big_endian_numbers_are_turned():
    values = np.array([[1, 258]], ">u2")
    msg = BRIDGE.cv2_to_imgmsg(values, "mono16")
    assert msg.is_bigendian == 1
    assert BRIDGE.imgmsg_to_cv2(msg).tolist() == [[1, 258]]


@pytest.mark.parametrize(("step", "size", "text"), [(5, 12, "step < width"), (6, 11, "height * step != size")])
def test_a_message_that_is_too_short_is_refused(step, size, text):
    msg = Image(height=2, width=2, step=step, encoding="bgr8", data=bytes(size))
    with pytest.raises(CvBridgeError) as error:
        BRIDGE.imgmsg_to_cv2(msg)
    assert text in str(error.value)


def test_a_header_is_taken_along():
    assert BRIDGE.cv2_to_imgmsg(np.zeros((1, 1), np.uint8), header=Header(frame_id="cam")).header.frame_id == "cam"


def test_a_slice_of_an_image_is_packed():
    image = image_of("bgr8", 10, 10)
    back = BRIDGE.imgmsg_to_cv2(BRIDGE.cv2_to_imgmsg(image[2:5, 3:9], "bgr8"))
    assert np.array_equal(back, image[2:5, 3:9])


@given(st.integers(1, 30), st.integers(1, 30))
def test_png_keeps_every_pixel(height, width):
    image = image_of("bgr8", height, width)
    msg = BRIDGE.cv2_to_compressed_imgmsg(image, "png")
    assert msg.format == "png"
    assert np.array_equal(BRIDGE.compressed_imgmsg_to_cv2(msg), image)
    assert np.array_equal(BRIDGE.compressed_imgmsg_to_cv2(msg, "rgb8"), image[:, :, ::-1])


def test_jpeg_is_near():
    image = cv2.GaussianBlur(image_of("bgr8", 40, 40), (9, 9), 4)
    back = BRIDGE.compressed_imgmsg_to_cv2(BRIDGE.cv2_to_compressed_imgmsg(image))
    assert np.abs(back.astype(int) - image).max() < 12


def test_bytes_that_are_no_picture_and_formats_that_are_none_are_refused():
    with pytest.raises(CvBridgeError, match="no picture"):
        BRIDGE.compressed_imgmsg_to_cv2(CompressedImage(format="jpeg", data=b"abc"))
    with pytest.raises(CvBridgeError, match="xyz"):
        BRIDGE.cv2_to_compressed_imgmsg(np.zeros((2, 2), np.uint8), "xyz")


def test_types_have_opencvs_numbers():
    assert cv_bridge.getCvType("bgr8") == cv2.CV_8UC3
    depth_type = cv_bridge_boost.getCvType("32FC1")
    assert cv_bridge_boost.CV_MAT_DEPTHWrap(depth_type) == cv2.CV_32F
    assert cv_bridge_boost.CV_MAT_CNWrap(cv_bridge_boost.getCvType("16UC4")) == 4
    with pytest.raises(CvBridgeError):
        cv_bridge.getCvType("nothing")


@pytest.mark.parametrize(("encoding", "dtype"), [("32SC1", np.int32), ("16UC1", np.uint16), ("32FC1", np.float32)])
def test_numbers_are_shown_between_their_own_limits_where_that_is_asked(encoding, dtype):
    image = np.arange(3, 15, dtype=dtype).reshape(3, 4)
    shown = cv_bridge.cvtColorForDisplay(image, encoding, "rgb8", do_dynamic_scaling=True)
    assert (shown.dtype, shown.shape, shown.min(), shown.max()) == (np.uint8, (3, 4, 3), 0, 255)


def test_what_is_not_finite_is_black_and_sets_no_limits():
    depths = np.array([[50, 100, 150, -np.inf, np.inf, np.nan]], np.float32)
    shown = cv_bridge.cvtColorForDisplay(depths, "32FC1", "mono8", do_dynamic_scaling=True)
    assert shown.tolist() == [[0, 128, 255, 0, 0, 0]]


def test_labels_have_a_colour_each_on_a_black_background():
    labels = np.arange(-1, 11, dtype=np.int32).reshape(3, 4)
    shown = cv_bridge.cvtColorForDisplay(labels, "32SC1", "bgr8")
    assert (shown.dtype, shown.shape, shown.min(), shown.max()) == (np.uint8, (3, 4, 3), 0, 255)
    assert shown[0].tolist() == [[0, 0, 0], [0, 0, 255], [72, 255, 0], [255, 0, 144]]
    assert len({tuple(colour) for colour in shown.reshape(-1, 3).tolist()}) == labels.size
    assert np.array_equal(cv_bridge.cvtColorForDisplay(labels, "32SC1", do_dynamic_scaling=True), shown)
    assert cv_bridge.cvtColorForDisplay(np.full((1, 1), -2, np.int32), "32SC1").max() == 255


def test_without_limits_only_depths_in_millimetres_have_shades():
    image = np.array([[0, 257, 65535]], np.uint16)
    assert cv_bridge.cvtColorForDisplay(image, "16UC1", "mono8").tolist() == [[0, 1, 255]]
    for encoding, dtype in (("32SC1", np.int32), ("32FC1", np.float32), ("8UC1", np.uint8)):
        with pytest.raises(CvBridgeError, match="does not make sense|not a colo"):
            cv_bridge.cvtColorForDisplay(image.astype(dtype), encoding, "mono8")


def test_an_even_image_between_its_own_limits_is_grey():
    image = np.full((2, 3), 4.0, np.float32)
    for wanted, shape in (("mono8", (2, 3)), ("", (2, 3, 3))):
        assert np.array_equal(cv_bridge.cvtColorForDisplay(image, "32FC1", wanted, True), np.full(shape, 128, np.uint8))


def test_shades_of_grey_are_spread_between_limits_too():
    image = np.array([[10, 20, 30]], np.uint8)
    assert cv_bridge.cvtColorForDisplay(image, "mono8", "mono8").tolist() == [[10, 20, 30]]
    assert cv_bridge.cvtColorForDisplay(image, "mono8", "mono8", True).tolist() == [[0, 128, 255]]


def test_limits_and_colours_of_a_depth_image_can_be_given():
    image = np.array([[0.0, 1.0, 5.0, np.nan, np.inf]], np.float32)
    shades = cv_bridge.cvtColorForDisplay(image, "32FC1", "mono8", False, 0.0, 2.0)
    assert shades.tolist() == [[0, 128, 255, 0, 0]]
    colours = cv_bridge.cvtColorForDisplay(image, "32FC1", "rgb8", min_image_value=0.0, max_image_value=2.0, colormap=2)
    wanted = cv2.applyColorMap(shades, 2)
    wanted[0, 3] = 0  # no depth is black, also where the map's first colour is not
    assert np.array_equal(colours[..., ::-1], wanted)


@pytest.mark.parametrize(
    ("encoding", "wanted", "scaled", "reason"),
    [
        ("bgr8", "mono16", False, "has no images of"),
        ("bgr8", "8UC3", False, "has no images of"),
        ("64FC1", "", False, "chooses no encoding"),
        ("32FC3", "", False, "chooses no encoding"),
        ("8UC3", "", False, "8UC3"),
        ("bgr8", "bgr8", True, "one channel only"),
    ],
)
def test_what_cannot_be_shown_is_refused(encoding, wanted, scaled, reason):
    with pytest.raises(CvBridgeError, match=reason):
        cv_bridge.cvtColorForDisplay(image_of(encoding), encoding, wanted, scaled)


def test_what_has_colours_keeps_them_for_display():
    image = image_of("bgr8")
    assert np.array_equal(cv_bridge.cvtColorForDisplay(image, "bgr8", "rgb8"), image[..., ::-1])
    assert np.array_equal(cv_bridge.cvtColorForDisplay(image, "bgr8"), image)
    assert np.array_equal(cv_bridge_boost.cvtColor2(image, "bgr8", "rgb8"), image[..., ::-1])
