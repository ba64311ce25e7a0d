"""image_view: a window for a topic, and images that go to files."""

import cv2
import numpy as np
import pytest
from cv_bridge import CvBridge
from sensor_msgs.msg import CameraInfo, Image
from std_srvs.srv import Empty, Trigger

from coursekit.view import highgui
from coursekit.view.desk import desk
from tests.nodes.friend import Friend

RED = np.full((30, 40, 3), (0, 0, 255), np.uint8)


@pytest.fixture
def friend(session, monkeypatch):
    monkeypatch.setattr(highgui, "has_display", lambda: False)
    highgui.install()
    return Friend(session)


@pytest.fixture
def start(session, tmp_path):
    """start("image_saver", "-p", "encoding:=bgr8") runs it on /camera/image, in a folder of its own."""
    from coursekit.processes.executables import find

    def started(name, *words):
        argv = ["--ros-args", "-r", "image:=/camera/image", *words]
        return session.start_executable(find("image_view", name), argv, name=name, cwd=str(tmp_path))

    return started


def show(friend, array=RED, encoding="bgr8", topic="/camera/image", seconds=1.0, info=None):
    """Publish an image now and then, with a camera's info of the same stamp if there is one."""
    out = friend.node.create_publisher(Image, topic, 10)
    told = friend.node.create_publisher(CameraInfo, "/camera/camera_info", 10) if info is not None else None

    def tell():
        msg = CvBridge().cv2_to_imgmsg(array, encoding)
        msg.header.stamp = friend.node.get_clock().now().to_msg()
        out.publish(msg)
        if told is not None:
            info.header.stamp = msg.header.stamp
            told.publish(info)

    timer = friend.node.create_timer(0.2, tell)
    friend.spin(seconds)
    timer.cancel()


def test_a_topic_has_a_window_that_closes_with_its_program(friend, start):
    viewer = start("image_view", "-p", "window_name:=front")
    show(friend)
    assert np.array_equal(desk().windows["front"].image, RED)
    viewer.interrupt()
    assert viewer.wait(2.0) == 0 and desk().windows == {}
    assert '[image_view_node]: Using transport "raw"' in viewer.output and "remapped" not in viewer.output


def test_the_windows_name_is_the_topics_and_compressed_images_are_shown(friend, start, run):
    republish = ["raw", "compressed", "--ros-args", "-r", "in:=/raw", "-r", "out/compressed:=/camera/image/compressed"]
    run("image_transport", "republish", *republish)
    start("image_view", "-p", "image_transport:=compressed")
    show(friend, topic="/raw")
    assert np.abs(desk().windows["/camera/image"].image.astype(int) - RED).max() < 8


def test_a_topic_that_nobody_has_named_is_told(run):
    viewer = run("image_view", "image_view")
    viewer.wait(0.5)
    assert "Topic 'image' has not been remapped!" in viewer.output and "-r image:=<image topic>" in viewer.output


def test_depths_are_grey_by_their_distance_or_coloured(friend, start, ros2):
    start("image_view", "-p", "window_name:=depth", "-p", "max_image_value:=4000", "-p", "min_image_value:=2000")
    depths = np.full((30, 40), 3000, np.uint16)
    depths[0, 0], depths[0, 1] = 500, 9000
    show(friend, depths, "16UC1")
    image = desk().windows["depth"].image
    assert image[0, 0].tolist() == [0, 0, 0] and image[0, 1].tolist() == [255, 255, 255] and 125 < image[5, 5, 0] < 130
    ros2("param", "set", "/image_view_node", "colormap", str(cv2.COLORMAP_JET))
    show(friend, depths, "16UC1")
    assert len(set(desk().windows["depth"].image[5, 5].tolist())) > 1


def test_the_right_button_saves_what_is_shown(friend, start, tmp_path):
    viewer = start("image_view", "-p", "window_name:=front", "-p", "filename_format:=shot%02i.png")
    show(friend)
    desk().windows["front"].click(3, 4)
    desk().windows["front"].click(3, 4, cv2.EVENT_RBUTTONDOWN)
    friend.spin(0.5)
    assert np.array_equal(cv2.imread(str(tmp_path / "shot00.png")), RED)
    assert "Left-clicking no longer saves images. Right-click instead." in viewer.output
    assert "Saved image shot00.png" in viewer.output


def test_every_image_goes_to_a_file(friend, start, tmp_path):
    saver = start("image_saver")
    show(friend, seconds=0.9)
    assert [path.name for path in sorted(tmp_path.iterdir())] == [f"left000{k}.jpg" for k in range(4)]
    assert "[image_saver_node]: Saved image left0000.jpg" in saver.output
    assert cv2.imread(str(tmp_path / "left0003.jpg")).shape == (30, 40, 3)


def test_a_camera_that_tells_of_itself_has_its_calibration_saved_beside(friend, start, tmp_path):
    start("image_saver", "-p", "filename_format:=a%i.%s")
    info = CameraInfo(width=40, height=30, distortion_model="plumb_bob", d=[0.1, 0.0, 0.0, 0.0, 0.0])
    info.k = [20.0, 0.0, 19.5, 0.0, 20.0, 14.5, 0.0, 0.0, 1.0]
    show(friend, info=info, seconds=0.5)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a0.ini", "a0.jpg", "a1.ini", "a1.jpg"]
    told = (tmp_path / "a0.ini").read_text().split()
    assert told[told.index("width") + 1] == "40" and "[camera]" in told
    matrix = told[told.index("matrix") + 1 : told.index("distortion")]
    assert [float(number) for number in matrix] == info.k.tolist()


def test_one_image_is_saved_when_it_is_asked_for(friend, start, tmp_path):
    start("image_saver", "-p", "save_all_image:=false")
    show(friend)
    assert not list(tmp_path.iterdir())
    friend.ask(Empty, "/save")
    show(friend)
    assert [path.name for path in tmp_path.iterdir()] == ["left0000.jpg"]


def test_images_between_start_and_end_are_saved(friend, start, tmp_path):
    start("image_saver", "-p", "request_start_end:=true")
    show(friend)
    assert not list(tmp_path.iterdir())
    assert friend.ask(Trigger, "/start").success
    show(friend, seconds=0.5)
    assert friend.ask(Trigger, "/end").success
    count = len(list(tmp_path.iterdir()))
    show(friend)
    assert count == len(list(tmp_path.iterdir())) == 2


def test_a_place_that_takes_no_file_is_told(friend, start):
    saver = start("image_saver", "-p", "filename_format:=nowhere/%i.jpg")
    show(friend, seconds=0.5)
    assert "Failed to save image to path nowhere/0.jpg" in saver.output
