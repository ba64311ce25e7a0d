"""Pads, windows and views without a browser, on the virtual clock."""

import numpy as np
import pytest
from geometry_msgs.msg import Twist
from sensor_msgs.msg import Image

from coursekit.core.qos import Qos
from coursekit.lab.drive import SILENCE_SECONDS, Driver, meaning
from coursekit.lab.image_view import image_view
from coursekit.lab.teleop_pad import pad
from coursekit.lab.turtle import NONE_RUNS, turtlesim_window
from coursekit.lab.windows import NO_WINDOWS, WindowPicture, windows
from coursekit.processes.executables import find
from coursekit.processes.patching import patch_manager
from coursekit.processes.session import Session
from coursekit.view import highgui, window_controls


@pytest.fixture
def session(monkeypatch):
    monkeypatch.setenv("ROS_DOMAIN_ID", "0")
    with Session(virtual=True).use() as virtual_session:
        patch_manager.renew()
        yield virtual_session


@pytest.fixture
def heard(session):
    """The velocities on /cmd_vel, as (seconds, linear x, linear y, angular z)."""
    commands = []

    class Ear:
        def put(self, subscription):
            subscription.queued = False
            while (entry := subscription.take()) is not None:
                twist = entry[0]
                now = round(session.clock.steady() * 1e-9, 3)
                commands.append((now, twist.linear.x, twist.linear.y, twist.angular.z))

    subscription = session.graph(0).add_node("ear", "/").subscription("/cmd_vel", Twist, Qos())
    subscription.attach(Ear(), subscription)
    return commands


def test_keys_held_together_add_up():
    assert meaning("up+left") == (1.0, 0.0, 1.0)
    with pytest.raises(ValueError, match=r"no key 'hop'. Keys are: up, down"):
        meaning("hop")


def test_a_press_is_published_ten_times_a_second_and_ends_with_zero(session, heard):
    pad(linear=0.5, angular=2.0).press("up+right", seconds=0.35)
    assert heard == [
        (0.0, 0.5, 0.0, -2.0),
        (0.1, 0.5, 0.0, -2.0),
        (0.2, 0.5, 0.0, -2.0),
        (0.3, 0.5, 0.0, -2.0),
        (0.35, 0.0, 0.0, 0.0),
    ]


def test_silence_stops(session, heard):
    Driver("/cmd_vel", 1.0, 1.0).drive(1.0)
    session.clock.sleep(5.0)
    assert heard == [(0.0, 1.0, 0.0, 0.0), (SILENCE_SECONDS, 0.0, 0.0, 0.0)]


def test_what_the_browser_says_is_clamped_and_zero_is_said_once(session, heard):
    driver = Driver("cmd_vel", 1.0, 1.0)
    assert driver.hear({"type": "drive", "x": 7, "y": 0, "turn": -0.5})
    for _ in range(3):
        assert driver.hear({"type": "drive", "x": 0, "y": 0, "turn": 0})
    assert not driver.hear({"type": "ready"})
    assert [entry[1:] for entry in heard] == [(1.0, 0.0, -0.5), (0.0, 0.0, 0.0)]


def test_a_driver_comes_back_after_the_graph_was_cleared(session, heard):
    driver = Driver("/cmd_vel", 1.0, 1.0)
    driver.join()
    assert [node.name for node in session.graph(0).nodes] == ["ear", "pad_cmd_vel"]
    session.graph(0).clear()
    driver.drive(1.0)
    assert [node.name for node in session.graph(0).nodes] == ["pad_cmd_vel"]


def test_an_interrupted_press_stops(session, heard):
    process = session.start(lambda: pad().press("up", 60), name="hand")
    session.clock.sleep(0.25)
    process.interrupt()
    process.wait(1.0)
    assert heard[-1][1:] == (0.0, 0.0, 0.0)


def test_the_pad_has_a_text_form(session):
    assert repr(pad("turtle1/cmd_vel", 1.0, 2.0)) == "[pad /turtle1/cmd_vel: 1.00 m/s, 2.00 rad/s]"
    assert pad()._repr_mimebundle_()[0]["text/plain"] == "[pad /cmd_vel: 0.50 m/s, 1.00 rad/s]"


def test_the_turtles_window_waits_for_a_turtlesim(session):
    window = turtlesim_window()
    assert repr(window) == NONE_RUNS
    with pytest.raises(LookupError, match="turtlesim_node"):
        window.snapshot()
    session.start_executable(find("turtlesim", "turtlesim_node"))
    session.clock.sleep(0.1)
    assert "turtle1  x 5.54 m" in repr(window)
    assert window._repr_mimebundle_()[0]["image/png"]


def test_the_turtles_window_drives_as_the_keyboard_does(session):
    session.start_executable(find("turtlesim", "turtlesim_node"), name="sim")
    session.clock.sleep(0.1)
    window = turtlesim_window()
    window.press("up", seconds=1.5)
    turtle = window.simulator.world.turtles["turtle1"]
    assert turtle.travelled == pytest.approx(3.0, abs=0.1)
    session.clock.sleep(0.05)
    assert turtle.speed == 0.0


def test_the_browser_gets_the_pose_as_it_is_and_rounds_it_once(session):
    session.start_executable(find("turtlesim", "turtlesim_node"))
    session.clock.sleep(0.1)
    window = turtlesim_window()
    window.simulator.world.turtles["turtle1"].x = 3.79512  # 3.80 m; by way of 3.795, which is no double, 3.79 m
    sent = []
    window.send = sent.append
    window._hear(window, {"type": "ready"}, [])
    assert sent[-1]["turtles"][0][2] == 3.79512


def test_the_browser_gets_each_piece_of_a_line_once(session):
    session.start_executable(find("turtlesim", "turtlesim_node"))
    session.clock.sleep(0.1)
    window = turtlesim_window()
    sent = []
    window.send = sent.append
    window._hear(window, {"type": "ready"}, [])
    for _ in range(12):
        window._drivers or window._driver()
        window.press("up+left", seconds=0.3)
        window._tell()
    lines = {}
    for message in sent:
        if message["whole"]:
            lines.clear()
        for piece in message["strokes"]:
            points = lines.setdefault(piece["i"], [])
            points[piece["from"] :] = piece["points"]
    strokes = window.simulator.world.paper.strokes
    assert [line for _, line in sorted(lines.items())] == [
        [(round(x, 3), round(y, 3)) for x, y in stroke.points] for stroke in strokes
    ]
    assert sum(len(piece["points"]) for message in sent for piece in message["strokes"]) < 2 * len(strokes[0].points)


def test_two_simulators_have_two_windows(session):
    for name in ("a", "b"):
        session.start_executable(find("turtlesim", "turtlesim_node"), ["--ros-args", "-r", f"__ns:=/{name}"])
    session.clock.sleep(0.1)
    first, second = turtlesim_window("/a/turtlesim"), turtlesim_window("/b/turtlesim")
    first.press("up", 0.5)
    assert first.simulator.world.turtles["turtle1"].travelled > 0.9
    assert second.simulator.world.turtles["turtle1"].travelled == 0.0


def test_windows_show_what_imshow_opened(session):
    assert repr(windows()) == NO_WINDOWS
    highgui.imshow("frame", np.zeros((30, 40, 3), np.uint8))
    shown = windows()
    assert repr(shown) == "[window frame: 40x30]"
    assert shown["frame"].image.shape == (30, 40, 3)
    with pytest.raises(LookupError, match="Open are: frame"):
        shown["other"]
    shown.press("q")
    assert highgui.waitKey(0) == ord("q")
    bundle = shown._repr_mimebundle_()
    assert (bundle[0] if isinstance(bundle, tuple) else bundle)["text/plain"] == "[window frame: 40x30]"


def test_a_window_has_its_trackbars_and_tells_of_the_mouse(session):
    told = []
    highgui.namedWindow("tune")
    shown = windows()
    picture = WindowPicture(shown.desk, shown["tune"])
    assert picture.controls() == {"trackbars": [], "mouse": False}
    window_controls.createTrackbar("hue", "tune", 3, 179, told.append)
    window_controls.setMouseCallback("tune", lambda *given: told.append(given))
    assert picture.controls() == {"trackbars": [{"name": "hue", "value": 3, "min": 0, "max": 179}], "mouse": True}
    picture._hear(None, {"type": "slide", "name": "hue", "value": 90}, [])
    picture._hear(None, {"type": "slide", "name": "gone", "value": 1}, [])
    picture._hear(None, {"type": "mouse", "event": 1, "x": 20, "y": 10, "flags": 1}, [])
    highgui.pollKey()
    assert told == [90, (1, 20, 10, 1, None)]


def test_an_image_view_keeps_the_newest_image(session):
    view = image_view("camera/image_raw")
    assert "no image yet" in repr(view)
    publisher = session.graph(0).add_node("camera", "/").publisher("/camera/image_raw", Image, Qos())
    for value in range(3):
        publisher.publish(Image(height=1, width=2, step=6, encoding="bgr8", data=bytes([value] * 6)))
    assert view.count == 3 and view.image.tolist() == [[[2, 2, 2], [2, 2, 2]]]
    assert repr(view) == "[image /camera/image_raw: 2x1 bgr8]"
