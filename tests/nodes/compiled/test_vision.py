"""OpenCV, cv_bridge and image_transport of compiled programs: Mat is theirs, cv2 answers the rest."""

from __future__ import annotations

import re

import cv2
import numpy as np
import pytest

from coursekit.nodes.compiled import vision
from coursekit.nodes.compiled.frames import FrameError, Unpacker, packed
from coursekit.processes.executables import make_process
from coursekit.view.desk import desk
from tests.nodes.compiled.conftest import ROOM, program


def test_constants_are_those_of_cv2():
    text = (ROOM / "opencv/opencv2/core/constants.hpp").read_text()
    pairs = re.findall(r"(\w+) = (-?\d+)", text)
    assert len(pairs) > 400
    assert {name: int(value) for name, value in pairs if getattr(cv2, name) != int(value)} == {}


def drawn():
    """What the program draws, by Python's cv2."""
    image = np.full((60, 80, 3), (10, 20, 30), np.uint8)
    cv2.rectangle(image, (10, 10, 30, 20), (0, 0, 255), cv2.FILLED)
    cv2.circle(image, (60, 40), 8, (255, 0, 0), -1)
    cv2.line(image, (0, 59), (79, 59), (0, 255, 0))
    return image


def test_mat_is_memory_and_functions_do_what_cv2_does(said, tmp_path):
    lines = said("pictures")
    assert lines[:8] == [
        "177011 [3 x 2]5[  7,   1,   1,   1,   7] 1120",
        "[2.5, 4.5, 400.5]162114 3346",
        "[1, 2, 3;",
        " 4, 5, 6]6[1, 0;",
        " 0, 1]3",
        "[0.3333333333333333, 0.6666666666666666, 1][0.40000001, 0.40000001][0.1, 2]0.3333333333",
        "104 12552",
        "refused -215",
    ]
    image = drawn()
    grey = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    edges = cv2.Canny(grey, 50, 150)
    assert lines[8] == f"{image[..., 2].sum()} {cv2.countNonZero(edges)} [40 x 30]{cv2.mean(grey)[0]:.10g}"
    limit = cv2.threshold(grey, 0, 255, cv2.THRESH_BINARY | cv2.THRESH_OTSU)[0]
    assert lines[9] == f"{limit:g} 11[30 x 20 from (10, 10)]551 24.5"
    red = cv2.inRange(image, (0, 0, 200), (50, 50, 255))
    contours, _ = cv2.findContours(red, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    cv2.drawContours(image, contours, -1, (255, 255, 255), 2)
    low, high, _, (x, y) = cv2.minMaxLoc(image[..., 0])
    assert lines[10] == f"0{low:g}{high:g}[{x}, {y}] 255"
    assert lines[11] == f"11111{cv2.GaussianBlur(image, (5, 5), 1.5)[..., 0].sum()}"
    assert (tmp_path / "small.png").is_file()  # in the program's folder, not in the session's
    (width, height), base = cv2.getTextSize("Vera", cv2.FONT_HERSHEY_SIMPLEX, 1.0, 2)
    assert lines[12:14] == [f"[{width} x {height}]{base}", "refused 1"]
    assert lines[14:] == ["20[6 x 4 from (0, 0)]31020 [9, 0, 7][50, 60, 70]"]  # a stamp on a page, by a mask


def test_a_window_s_sliders_and_mouse_are_told_while_the_program_waits_for_a_key(session, build):
    tuner = session.launch(make_process(session, build("tuner", program("tuner.cpp")), name="tuner"))
    session.clock.sleep(0.1)
    desk().windows["tuner"].slide("low", 90)
    desk().windows["tuner"].slide("width", 12)
    desk().windows["tuner"].mouse(cv2.EVENT_LBUTTONDOWN, 3, 4, cv2.EVENT_FLAG_LBUTTON)
    session.clock.sleep(1.0)
    desk().windows["tuner"].slide("width", 50)
    session.clock.sleep(0.1)
    desk().press("q")
    assert tuner.wait(5.0) == 0, tuner.output
    assert tuner.output.splitlines() == [
        "low 90",
        "mouse 1 3 4 1",
        "-1 500 90 12 12",
        "low 33",
        "q 50",
        "-1",
        "There is no window 'none'. There are: tuner. Make it: cv2.namedWindow('none')",
    ]


def test_numbers_become_images_to_look_at(said):
    assert said("displays") == [
        "bgr8[  0,   0,   0,   0,   0, 255,  72, 255,   0, 255,   0, 144]",
        "bgr8[255,  72,   0,   0,   0, 255,   0,   0,   0, 255,   0, 144]",
        "[32SC1] is not a color format. but [mono8] is. The conversion does not make sense",
        "mono8[  0,  85, 170, 255]",
        "mono8[  0,   1, 255]",
        "bgr8[  0,   0,   0,   1,   1,   1, 255, 255, 255]",
        "mono8[  0,   1, 255]",
        "[32FC1] is not a color format. but [bgr8] is. The conversion does not make sense",
        "mono8[  0, 128, 255,   0,   0]",
        "mono8[  0, 128, 255,   0,   0,   0]",
        "rgb8[  0,   0, 128, 130, 255, 126, 128,   0,   0,   0,   0,   0,   0,   0, 128]",
        "mono8[128, 128]",
        "bgr8[128, 128, 128, 128, 128, 128]",
        "mono8[  0, 255]",
        "cvtColorForDisplay chooses no encoding for [64FC1]: name one, for example bgr8",
        "cvtColorForDisplay has no images of [mono16]: ask for bgr8, rgb8 or mono8",
        "[8UC1] is not a color format. but [mono8] is. The conversion does not make sense",
        "rgb8[  3,   2,   1]",
        "cvtColorForDisplay scales images of one channel only, not of [bgr8]",
        "cvtColorForDisplay needs an image, and got a null pointer",
        "1",
    ]


def test_images_go_over_the_bridge_and_over_topics(said):
    assert said("bridge") == [
        "329bgr8018eye",
        "1[30, 20, 10]rgb8 22 [2570, 5140, 7710]",
        "25813",
        "png[10, 20, 30]",
        "[8UC3] is not a color format. but [bgr8] is. The conversion does not make sense",
        "[8UC3] and [8UC1] do not have the same number of channel",
        "Unknown encoding odd",
        "Image is wrongly formed: step < width * byte_depth * num_channels  or  2 != 3 * 1 * 3",
        "/front/image /front/camera_info 2raw",
        "theora",
        "image 640 with 6401",
    ]


def test_a_film_is_written_lit_pixels_are_found_and_a_pair_of_cameras_sees_depth(said, tmp_path):
    assert said("films") == [
        "01",
        "10",
        "3 15 [64 x 48]1",
        "0[5, 2;",
        " 1, 4][5 x 3 from (1, 2)]",
        "1 [0.04, 0.01, 2] 10000 -200",
        "[2 x 2 from (6, 1)][1 x 2 from (1, 1)]",
    ]
    assert (tmp_path / "film.avi").stat().st_size > 1000  # in the program's folder, not in the session's


def test_a_matrix_is_published_as_it_is_and_heard_as_an_image_or_a_matrix(said):
    assert said("matrices") == [
        "empty: 10 0x0",
        "shown: 012 yuv422 unsupported encoding type",
        "Unsupported encoding type",
        "unique_sensor_msgs_image cannot be nullptr",
        "copied: 011",
        "within: the same 9 lens",
        "between: another 9 lens, and an image mono8 2x3 9",
    ]


TRANSPORT = """
#include "image_transport/image_transport.hpp"
#include "image_transport/publisher_plugin.hpp"
#include "image_transport/simple_publisher_plugin.hpp"
#include "image_transport/simple_subscriber_plugin.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "std_msgs/msg/string.hpp"
using sensor_msgs::msg::Image;
using std_msgs::msg::String;
struct WordsOut : image_transport::SimplePublisherPlugin<String>
{
  std::string getTransportName() const override {return "words";}

protected:
  void publish(const Image & image, const PublishFn & publish_fn) const override
  {
    publish_fn(String().set__data(image.encoding));
  }
};
struct WordsIn : image_transport::SimpleSubscriberPlugin<String>
{
  std::string getTransportName() const override {return "words";}

protected:
  void internalCallback(const String::ConstSharedPtr & message, const Callback & user_cb) override
  {
    auto image = std::make_shared<Image>();
    image->encoding = message->data + " again";
    user_cb(image);
  }
};
PLUGINLIB_EXPORT_CLASS(WordsOut, image_transport::PublisherPlugin)
PLUGINLIB_EXPORT_CLASS(WordsIn, image_transport::SubscriberPlugin)
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("eye");
  WordsOut out;
  WordsIn in;
  out.advertise(node.get(), "front");
  in.subscribe(node.get(), "front", [](const Image::ConstSharedPtr & image) {std::cout << image->encoding << std::endl;});
  std::cout << out.getTopic() << " " << in.getTopic() << " " << out.getNumSubscribers() << in.getNumPublishers() << " "
            << WordsOut::getLookupName("words") << std::endl;
  image_transport::PublisherPlugin & sender = out;
  sender.publish(Image().set__encoding("mono8"));
  rclcpp::sleep_for(std::chrono::milliseconds(50));
  rclcpp::spin_some(node);
  out.shutdown();
  sender.publish(Image());
  std::cout << out.getNumSubscribers() << std::endl;

  const std::string key = "eye.image.enable_pub_plugins";
  auto open = rclcpp::Node::make_shared("open", "left");
  image_transport::create_publisher(open.get(), "eye/image");
  std::cout << open->get_parameter(key).value_to_string() << std::endl;
  auto none = rclcpp::NodeOptions().append_parameter_override(key, std::vector<std::string>{"image_transport/theora"});
  auto shut = rclcpp::Node::make_shared("shut", "left", none);
  try {
    image_transport::create_publisher(shut.get(), "eye/image");
  } catch (const image_transport::Exception & error) {
    std::cout << error.what() << std::endl;
  }
}
"""


def test_a_transport_of_one_s_own_sends_and_hears_and_a_parameter_names_those_of_a_topic(session, build):
    process = session.launch(make_process(session, build("transport", TRANSPORT), name="transport"))
    assert process.wait(20.0) == 0, process.output
    assert process.output.splitlines() == [
        "/front/words /front/words 11 image_transport/words_pub",
        "mono8 again",
        "0",
        "[image_transport/raw]",
        "No plugins found! Does `rospack plugins --attrib=plugin image_transport` find any packages?",
    ]


@pytest.mark.parametrize(
    "value", [None, 7, -0.5, "text", (1, 2.0, "x"), np.arange(24, dtype="f4").reshape(2, 4, 3), np.zeros((3, 2), bool)]
)
def test_what_is_answered_is_read_again(value):
    again = vision._argument(Unpacker(vision.answer(value)))
    assert np.array_equal(again, value) if isinstance(value, np.ndarray) else again == value


@pytest.mark.parametrize("data", [packed(99), packed(vision.MAT, 1, 1, 9, 1, b""), packed(vision.TUPLE, 5), b"\0"])
def test_an_argument_that_is_none_is_refused(data):
    with pytest.raises(FrameError):
        vision._argument(Unpacker(data))


def board(squares_x, squares_y, side):
    """The image of a chessboard, with a white border."""
    inner = np.indices((squares_y, squares_x)).sum(axis=0) % 2 * 255
    return np.pad(np.kron(inner, np.ones((side, side))), 2 * side, constant_values=255).astype(np.uint8)


def test_markers_codes_corners_and_what_moves_are_found(said, tmp_path):
    code = cv2.QRCodeEncoder.create().encode("ROS 2")
    cv2.imwrite(str(tmp_path / "code.png"), np.pad(np.kron(code, np.ones((6, 6), np.uint8)), 30, constant_values=255))
    cv2.imwrite(str(tmp_path / "board.png"), board(7, 5, 30))
    lines = said("sights")
    assert lines[:4] == ["1 7 4 4", "33 300 100", "1", "00"]
    assert lines[4] == "0.3-0.2 0.1 0.6 107"
    assert "".join(lines[5:7]) == "[3, 0; 0, 3]58 7 967509983"
    assert lines[7:10] == [f"{followed()[0]:.6g} {followed()[1]:.6g}", "4 3 2 1", "400[28, 37]1"]
    assert lines[10:] == ["9600 400", "0100", "[ROS 2] 4", "1 24 30", "132 2 0 23", "3111"]


def test_settings_are_written_and_read_and_pixels_are_iterated(said, tmp_path):
    (tmp_path / "plain.yaml").write_text("a: 1\n")  # without OpenCV's first line
    lines = said("settings")
    assert lines == [
        "0",
        "1640 0.25 front camera 300.5 0.55",
        "12 a.png b.png 12.5",
        "[3, 4.5]8[4 x 3]4Vera0 1111",
        "001 0 6",
        "15 [  0,   1,   2;",
        "   3,   4,   5]236",
    ]
    file = cv2.FileStorage(str(tmp_path / "camera.yaml"), cv2.FILE_STORAGE_READ)
    assert file.getNode("camera_matrix").mat().tolist() == [[300, 0, 160], [0, 300.5, 120], [0, 0, 1]]
    assert file.getNode("corners").at(1).at(1).real() == 4.5


def followed():
    """Where the program's KalmanFilter is at its end, by Python's."""
    kalman = cv2.KalmanFilter(2, 1)
    kalman.transitionMatrix = np.array([[1, 1], [0, 1]], np.float32)
    kalman.measurementMatrix = np.eye(1, 2, dtype=np.float32)
    kalman.processNoiseCov = np.eye(2, dtype=np.float32) * np.float32(1e-4)
    kalman.measurementNoiseCov = np.full((1, 1), 0.1, np.float32)
    kalman.errorCovPost = np.eye(2, dtype=np.float32)
    for seen in range(1, 6):
        kalman.predict()
        kalman.correct(np.full((1, 1), seen, np.float32))
    return kalman.statePost.ravel()
