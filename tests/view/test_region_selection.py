"""cv2.selectROI: rectangles that are drawn with the mouse while the program waits."""

import cv2
import numpy as np
import pytest

from coursekit.processes.session import Session
from coursekit.view import highgui

IMAGE = np.full((60, 80, 3), 200, np.uint8)


@pytest.fixture
def user(monkeypatch):
    """user(...) lets these things happen, a tenth of a second apart: points drag the mouse, texts are keys."""
    monkeypatch.setattr(highgui, "has_display", lambda: False)
    with Session(virtual=True).use() as session:
        highgui.install()

        def act(*things, window="pick"):
            for number, thing in enumerate(things, 1):
                when = session.clock.steady() + number * 100_000_000
                session.clock.call_at(when, lambda thing=thing: happen(thing, window))

        yield act


def happen(thing, window):
    if isinstance(thing, str):
        highgui.desk().press(thing)
        return
    start, end = thing
    shown = highgui.desk().windows[window]
    shown.mouse(cv2.EVENT_LBUTTONDOWN, *start)
    shown.mouse(cv2.EVENT_MOUSEMOVE, *end)
    shown.mouse(cv2.EVENT_LBUTTONUP, *end)


def test_a_rectangle_is_drawn_and_taken(user, capsys):
    user(((10, 20), (40, 50)), " ")
    assert cv2.selectROI("pick", IMAGE) == (10, 20, 30, 30)
    assert "press SPACE or ENTER" in capsys.readouterr().out
    shown = highgui.desk().windows["pick"].image
    assert tuple(shown[20, 20]) == (255, 0, 0) and tuple(shown[35, 25]) == (255, 0, 0) and tuple(shown[30, 20]) == (200,) * 3


@pytest.mark.parametrize(
    ("drag", "options", "box"),
    [
        (((40, 50), (10, 20)), {}, (10, 20, 30, 30)),  # from below
        (((30, 30), (40, 35)), {"fromCenter": True}, (20, 25, 20, 10)),
        (((60, 40), (200, -10)), {"showCrosshair": False}, (60, 0, 20, 40)),  # out of the image
        (((5, 5), (5, 5)), {}, (0, 0, 0, 0)),  # a click
    ],
)
def test_it_is_within_the_image(user, drag, options, box):
    user(drag, "\r", window="ROI selector")
    assert cv2.selectROI(IMAGE, printNotice=False, **options) == box


def test_the_last_rectangle_counts_and_c_cancels(user):
    user(((1, 1), (9, 9)), ((10, 10), (30, 20)), "\r")
    assert cv2.selectROI("pick", IMAGE, False, False) == (10, 10, 20, 10)
    user(((1, 1), (9, 9)), "c")
    assert cv2.selectROI("pick", IMAGE) == (0, 0, 0, 0)


def test_several_until_escape(user):
    user(((1, 1), (9, 9)), " ", ((10, 10), (30, 20)), "\r", "\x1b")
    assert cv2.selectROIs("pick", IMAGE).tolist() == [[1, 1, 8, 8], [10, 10, 20, 10]]


def test_no_image_is_told(user):
    with pytest.raises(cv2.error, match="what did read"):
        cv2.selectROI("pick", None)
