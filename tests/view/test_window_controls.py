"""Trackbars and the mouse in OpenCV's windows, as programs that tune a colour or wait for a click use them."""

import cv2
import numpy as np
import pytest

from coursekit.processes.current_process import current_process
from coursekit.processes.session import Session
from coursekit.view import highgui
from coursekit.view.desk import desk

IMAGE = np.zeros((30, 40, 3), np.uint8)


@pytest.fixture
def session(monkeypatch):
    monkeypatch.setattr(highgui, "has_display", lambda: False)
    with Session(virtual=True).use() as virtual_session:
        highgui.install()
        cv2.namedWindow("tune", cv2.WINDOW_NORMAL)
        yield virtual_session


@pytest.fixture
def window(session):
    return desk().windows["tune"]


def test_a_trackbar_is_moved_while_its_program_waits_for_keys(window):
    told = []
    cv2.createTrackbar("hue", "tune", 20, 179, told.append)
    assert cv2.getTrackbarPos("hue", "tune") == 20 and told == []
    window.slide("hue", 90)
    assert told == []
    assert cv2.waitKey(1) == -1
    assert told == [90] and cv2.getTrackbarPos("hue", "tune") == 90
    assert repr(window) == "[window tune: no image yet, hue 90]"


def test_a_slide_does_not_end_the_wait_for_a_key(session, window):
    told = []
    cv2.createTrackbar("hue", "tune", 20, 179, told.append)
    session.clock.call_at(session.clock.steady() + 1_000_000_000, lambda: window.slide("hue", 5))
    session.clock.call_at(session.clock.steady() + 2_000_000_000, lambda: desk().press("q"))
    assert cv2.waitKey(0) == ord("q")
    assert told == [5] and session.clock.steady() == 2_000_000_000


def test_a_program_moves_a_trackbar_within_its_ends(window):
    told = []
    cv2.createTrackbar("speed", "tune", 500, 100, told.append)
    assert cv2.getTrackbarPos("speed", "tune") == 100
    cv2.setTrackbarMin("speed", "tune", 10)
    cv2.setTrackbarPos("speed", "tune", -3)
    cv2.setTrackbarPos("speed", "tune", 10)
    assert told == [10]
    cv2.setTrackbarMax("speed", "tune", 5000)
    cv2.setTrackbarPos("speed", "tune", 4000)
    assert told == [10, 4000]


def test_what_has_no_window_says_how_to_make_one(session):
    for call in (lambda: cv2.createTrackbar("hue", "none", 0, 9, print), lambda: cv2.setMouseCallback("none", print)):
        with pytest.raises(
            cv2.error, match=r"There is no window 'none'. There are: tune. Make it: cv2.namedWindow\('none'\)"
        ):
            call()
    assert cv2.getTrackbarPos("hue", "none") == cv2.getTrackbarPos("none", "tune") == -1


def test_a_click_comes_as_opencvs_events_with_the_programs_parameter(window):
    told = []
    cv2.setMouseCallback("tune", lambda *given: told.append(given), "mine")
    window.mouse(cv2.EVENT_MOUSEMOVE, 3, 4)
    window.click(7, 9)
    window.click(1, 2, cv2.EVENT_RBUTTONDOWN)
    cv2.pollKey()
    left, right = cv2.EVENT_FLAG_LBUTTON, cv2.EVENT_FLAG_RBUTTON
    assert told == [
        (cv2.EVENT_MOUSEMOVE, 3, 4, 0, "mine"),
        (cv2.EVENT_LBUTTONDOWN, 7, 9, left, "mine"),
        (cv2.EVENT_LBUTTONUP, 7, 9, left, "mine"),
        (cv2.EVENT_RBUTTONDOWN, 1, 2, right, "mine"),
        (cv2.EVENT_RBUTTONUP, 1, 2, right, "mine"),
    ]


def test_a_program_that_tells_no_more_hears_no_more(window):
    told = []
    cv2.setMouseCallback("tune", lambda *given: told.append(given))
    window.click(7, 9)
    cv2.destroyAllWindows()
    assert cv2.waitKey(1) == -1 and told == []


def test_each_program_hears_of_its_own_windows_only(session):
    told = []

    def program(name):
        cv2.namedWindow(name)
        cv2.createTrackbar("hue", name, 0, 9, lambda value: told.append((current_process().name, value)))
        cv2.waitKey(2000)

    for name in ("one", "two"):
        session.start(lambda name=name: program(name), name=name)
    session.clock.sleep(0.5)
    desk().windows["two"].slide("hue", 4)
    session.clock.sleep(0.5)
    assert told == [("two", 4)]


def test_what_only_moves_windows_about_is_taken(window):
    cv2.imshow("tune", IMAGE)
    cv2.setWindowProperty("tune", cv2.WND_PROP_FULLSCREEN, cv2.WINDOW_FULLSCREEN)
    assert cv2.getWindowImageRect("tune") == (0, 0, 40, 30)
    assert cv2.startWindowThread() == 0
