"""OpenCV's windows and camera in a session."""

import sys

import cv2
import numpy as np
import pytest

from coursekit import wiring
from coursekit.processes.session import Session
from coursekit.view import capture, desk, highgui

IMAGE = np.full((30, 40, 3), 7, np.uint8)


@pytest.fixture
def session(monkeypatch):
    monkeypatch.setattr(highgui, "has_display", lambda: False)
    monkeypatch.setattr(highgui, "has_camera", lambda: False)
    with Session(virtual=True).use() as virtual_session:
        highgui.install()
        yield virtual_session


def test_a_window_keeps_a_copy_of_the_newest_image(session):
    image = IMAGE.copy()
    cv2.imshow("frame", image)
    image[:] = 0
    window = highgui.desk().windows["frame"]
    assert np.array_equal(window.image, IMAGE) and repr(window) == "[window frame: 40x30]"


def test_destroying_closes_and_an_unknown_window_is_an_error(session):
    cv2.namedWindow("a")
    cv2.imshow("b", IMAGE)
    assert cv2.getWindowProperty("b", cv2.WND_PROP_VISIBLE) == 1.0
    cv2.destroyWindow("b")
    assert cv2.getWindowProperty("b", cv2.WND_PROP_VISIBLE) < 1.0
    with pytest.raises(cv2.error, match=r"There is no window 'b'. There are: a"):
        cv2.destroyWindow("b")
    cv2.destroyAllWindows()
    assert highgui.desk().windows == {}


def test_showing_nothing_says_what_to_look_at(session):
    with pytest.raises(cv2.error, match="read"):
        cv2.imshow("frame", None)


@pytest.mark.parametrize("milliseconds", [1, 30, 1000])
def test_wait_key_waits_in_session_time(session, milliseconds):
    before = session.clock.steady()
    assert cv2.waitKey(milliseconds) == -1
    assert session.clock.steady() - before == milliseconds * 1_000_000


def test_wait_key_returns_the_key_when_it_is_pressed(session):
    session.clock.call_at(session.clock.steady() + 2_000_000_000, lambda: highgui.desk().press("q"))
    assert cv2.waitKey(0) == ord("q")
    assert session.clock.steady() == 2_000_000_000
    highgui.desk().press(27)
    assert (cv2.pollKey(), cv2.pollKey()) == (27, -1)


def test_windows_are_told_of(session):
    heard = []
    desk.watch(heard.append)
    cv2.imshow("frame", IMAGE)
    cv2.destroyAllWindows()
    desk.unwatch(heard.append)
    assert [window.name for window in heard] == ["frame", "frame", "frame"] and not heard[-1].open


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32, np.float64])
@pytest.mark.parametrize("channels", [None, 1, 3, 4])
def test_every_kind_of_image_is_shown(kind, channels):
    shape = (4, 5) if channels is None else (4, 5, channels)
    shown = highgui.as_bgr(np.ones(shape, kind))
    assert shown.shape == (4, 5, 3) and shown.dtype == np.uint8


def test_the_camera_gives_thirty_pictures_a_second_of_session_time(session):
    camera = cv2.VideoCapture(0)
    assert camera.isOpened() and camera.get(cv2.CAP_PROP_FPS) == 30.0
    before = session.clock.steady()
    pictures = [camera.read()[1] for _ in range(31)]
    assert session.clock.steady() - before == pytest.approx(1e9, abs=1e3)
    assert pictures[0].shape == (480, 640, 3)
    assert not np.array_equal(pictures[0], pictures[1])


def test_two_sessions_see_the_same(session):
    first = [cv2.VideoCapture(0).read()[1] for _ in range(2)][1]
    with Session(virtual=True).use():
        second = [cv2.VideoCapture(0).read()[1] for _ in range(2)][1]
    assert np.array_equal(first, second)


def test_size_and_rate_can_be_set_and_others_not(session):
    camera = cv2.VideoCapture(0)
    assert camera.set(cv2.CAP_PROP_FRAME_WIDTH, 960) and camera.set(cv2.CAP_PROP_FRAME_HEIGHT, 540)
    assert camera.set(cv2.CAP_PROP_FPS, 10)
    assert not camera.set(cv2.CAP_PROP_FRAME_WIDTH, 100_000) and not camera.set(cv2.CAP_PROP_EXPOSURE, 1)
    assert camera.read()[1].shape == (540, 960, 3)
    before = session.clock.steady()
    camera.read()
    assert session.clock.steady() - before == 100_000_000
    assert camera.get(cv2.CAP_PROP_FRAME_WIDTH) == 960.0


def test_a_slow_reader_misses_pictures_and_none_waits(session):
    camera = cv2.VideoCapture(0)
    camera.read()
    session.clock.sleep(1.0)
    before = session.clock.steady()
    camera.read()
    assert session.clock.steady() == before
    camera.read()
    assert session.clock.steady() > before


def test_a_released_camera_and_any_other_number_give_nothing(session):
    camera = cv2.VideoCapture(0)
    camera.release()
    assert camera.read() == (False, None) and not camera.isOpened()
    assert not cv2.VideoCapture(3).isOpened()
    assert camera.open(0) and camera.read()[0]


def test_a_file_is_opened_by_opencv_itself(session, tmp_path):
    missing = cv2.VideoCapture(str(tmp_path / "none.avi"))
    assert not isinstance(missing, capture.VirtualCapture) and not missing.isOpened()


def test_it_steps_aside_for_a_display_and_a_device(monkeypatch):
    real = object()
    for name in ("imshow", "waitKey", "VideoCapture"):
        monkeypatch.setattr(cv2, name, real)
    monkeypatch.setattr(highgui, "has_display", lambda: True)
    monkeypatch.setattr(highgui, "has_camera", lambda: True)
    highgui.install()
    assert cv2.imshow is real and cv2.waitKey is real and cv2.VideoCapture is real


@pytest.mark.parametrize(
    ("wish", "device", "expected"),
    [("", True, True), ("", False, False), ("virtual", True, False), ("real", False, True)],
)
def test_which_camera_is_used_can_be_said(monkeypatch, wish, device, expected):
    monkeypatch.setenv("COURSEKIT_CAMERA", wish)
    monkeypatch.setattr(highgui.os.path, "exists", lambda path: device)
    assert highgui.has_camera() is expected


def test_a_program_that_imports_cv2_itself_finds_it_ready(session):
    def program():
        import cv2

        ok, image = cv2.VideoCapture(0).read()
        cv2.imshow("frame", image)
        print(ok, cv2.waitKey(5))

    process = session.start(program, name="camera")
    process.wait(2.0)
    assert process.output == "True -1\n"


def test_helpers_are_called_after_the_import_of_their_module(session, tmp_path, monkeypatch):
    (tmp_path / "needy.py").write_text("ready = False\n")
    (tmp_path / "helper_of_needy.py").write_text("def install():\n    import needy\n    needy.ready = True\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setitem(wiring.IMPORT_HOOKS, "needy", "helper_of_needy")
    import needy

    assert needy.ready
    for name in ("needy", "helper_of_needy"):
        del sys.modules[name]


def test_the_virtual_camera_has_the_name_of_a_device_too(session):
    camera = cv2.VideoCapture("/dev/video0", cv2.CAP_V4L2)
    assert camera.isOpened() and camera.read()[1].shape == (480, 640, 3)
    assert not cv2.VideoCapture("/dev/video7").isOpened()
