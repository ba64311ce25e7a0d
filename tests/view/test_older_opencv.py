"""The names of OpenCV 4.5, which robots with Humble have, where a newer OpenCV lacks them."""

import subprocess
import sys

import cv2
import numpy as np
import pytest

from coursekit.processes.session import Session
from coursekit.view import highgui, older_opencv

CAMERA = np.array([[400.0, 0.0, 320.0], [0.0, 400.0, 240.0], [0.0, 0.0, 1.0]])
SIZE = 0.2


@pytest.fixture(autouse=True)
def session():
    with Session(virtual=True).use() as virtual_session:
        highgui.install()
        yield virtual_session


def seen(rvec, tvec, number=7):
    """What a camera sees of a marker of 20 cm on white paper."""
    dictionary = cv2.aruco.Dictionary_get(cv2.aruco.DICT_4X4_50)
    marker = cv2.aruco.drawMarker(dictionary, number, 200)
    paper = cv2.copyMakeBorder(marker, 50, 50, 50, 50, cv2.BORDER_CONSTANT, value=255)
    half = SIZE / 2 * 1.5
    corners = np.array([[-half, half, 0], [half, half, 0], [half, -half, 0], [-half, -half, 0]])
    there = cv2.projectPoints(corners, np.array(rvec), np.array(tvec), CAMERA, None)[0].reshape(4, 2)
    here = np.array([[0, 0], [300, 0], [300, 300], [0, 300]], np.float32)
    turned = cv2.getPerspectiveTransform(here, there.astype(np.float32))
    return cv2.warpPerspective(paper, turned, (640, 480), borderValue=255), dictionary


def test_a_marker_is_found_and_located_as_older_programs_do_it():
    rvec, tvec = [np.pi - 0.3, 0.1, 0.0], [0.1, -0.05, 1.2]
    image, dictionary = seen(rvec, tvec)
    parameters = cv2.aruco.DetectorParameters_create()
    parameters.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
    corners, ids, _ = cv2.aruco.detectMarkers(image, dictionary, parameters=parameters)
    assert ids.tolist() == [[7]] and corners[0].shape == (1, 4, 2)
    rvecs, tvecs, points = cv2.aruco.estimatePoseSingleMarkers(corners, SIZE, CAMERA, np.zeros(5))
    assert rvecs.shape == tvecs.shape == (1, 1, 3) and points.shape == (4, 1, 3)
    assert tvecs[0][0] == pytest.approx(tvec, abs=0.02)
    turn = cv2.Rodrigues(rvecs[0][0])[0] @ cv2.Rodrigues(np.array(rvec))[0].T
    assert np.trace(turn) == pytest.approx(3.0, abs=0.02)
    colours = cv2.cvtColor(image, cv2.COLOR_GRAY2BGR)
    drawn = cv2.aruco.drawAxis(colours.copy(), CAMERA, np.zeros(5), rvecs[0], tvecs[0], 0.1)
    assert (drawn != colours).any()


def test_where_no_marker_is_there_is_none():
    corners, ids, _ = cv2.aruco.detectMarkers(np.full((60, 80), 255, np.uint8), cv2.aruco.Dictionary_get(0))
    assert ids is None and len(corners) == 0


def test_boards_are_made_from_numbers():
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_6X6_250)
    board = cv2.aruco.GridBoard_create(3, 2, 0.04, 0.01, dictionary)
    assert board.getGridSize() == (3, 2)
    squares = cv2.aruco.CharucoBoard_create(5, 7, 0.04, 0.02, dictionary)
    assert squares.getChessboardSize() == (5, 7)


def board_before_the_camera(place, **options):
    """A board of 3 by 2 markers, and what a camera sees of it at this place, looking straight at it."""
    dictionary = cv2.aruco.Dictionary_get(cv2.aruco.DICT_4X4_50)
    board = cv2.aruco.GridBoard_create(3, 2, 0.08, 0.02, dictionary)
    drawn = board.draw((280, 180), **options)
    left, below, away = place
    scale = CAMERA[0, 0] / away / 1000
    to_pixels = np.array([[scale, 0, 320 + CAMERA[0, 0] * left / away], [0, scale, 240 + CAMERA[0, 0] * below / away]])
    return board, dictionary, cv2.warpAffine(drawn, to_pixels, (640, 480), borderValue=255)


def test_a_board_is_located_by_its_lower_left_corner_with_y_upwards():
    board, dictionary, image = board_before_the_camera([-0.1, -0.05, 0.5])
    corners, ids, rejected = cv2.aruco.detectMarkers(image, dictionary)
    corners, ids, *_ = cv2.aruco.refineDetectedMarkers(image, board, corners, ids, rejected)
    seen, rvec, tvec = cv2.aruco.estimatePoseBoard(corners, ids, board, CAMERA, np.zeros(5), None, None)
    assert seen == 6
    assert tvec.ravel() == pytest.approx([-0.1, -0.05 + 0.18, 0.5], abs=0.01)
    assert cv2.Rodrigues(rvec)[0] == pytest.approx(np.diag([1.0, -1.0, -1.0]), abs=0.05)


def test_of_a_board_out_of_sight_no_marker_is_counted():
    board = cv2.aruco.GridBoard_create(2, 2, 0.08, 0.02, cv2.aruco.Dictionary_get(0))
    turn, place = np.zeros((3, 1)), np.ones((3, 1))
    assert cv2.aruco.estimatePoseBoard((), None, board, CAMERA, None, turn, place) == (0, turn, place)


def test_markers_and_boards_are_drawn_with_the_older_words():
    dictionary = cv2.aruco.Dictionary_get(cv2.aruco.DICT_4X4_50)
    assert cv2.aruco.drawMarker(dictionary, 3, sidePixels=80, borderBits=2)[8:16, 8:16].max() == 0
    board = cv2.aruco.GridBoard_create(2, 2, 0.08, 0.02, dictionary)
    assert board.draw((200, 200), marginSize=10, borderBits=1).shape == (200, 200)
    assert (cv2.aruco.drawPlanarBoard(board, (200, 200)) == board.draw((200, 200))).all()


def test_what_opencv_has_itself_is_left_alone(monkeypatch):
    monkeypatch.setattr(older_opencv, "ARUCO", {**older_opencv.ARUCO, "drawDetectedMarkers": print})
    undo = older_opencv.add_aruco(None)
    assert cv2.aruco.drawDetectedMarkers is not print
    undo()


def test_results_have_the_shapes_that_programs_for_humble_unpack():
    image = np.zeros((200, 200), np.uint8)
    cv2.line(image, (10, 10), (180, 150), 255, 2)
    assert cv2.HoughLinesP(image, 1, np.pi / 180, 50, minLineLength=30, maxLineGap=5).shape[1:] == (1, 4)
    assert cv2.findNonZero(image).shape[1:] == (1, 2)
    assert cv2.calcHist([image], [0], None, [16], [0, 256]).shape == (16, 1)
    assert not cv2.CascadeClassifier(cv2.data.haarcascades + "haarcascade_frontalface_default.xml").empty()


@pytest.mark.parametrize("turned", [5, 30, 45, 80, 90])
def test_the_smallest_rectangle_is_turned_by_more_than_0_up_to_90_degrees(turned):
    corners = cv2.boxPoints(((100.0, 100.0), (80.0, 20.0), turned))
    center, size, angle = cv2.minAreaRect(corners)
    assert (center, size, angle) == (
        pytest.approx((100.0, 100.0), abs=1e-3), pytest.approx((80.0, 20.0), abs=1e-3), pytest.approx(turned, abs=1e-3),
    )  # fmt: skip


def test_the_smallest_rectangle_of_an_upright_one_stands_on_its_side():
    upright = np.array([[0, 0], [20, 0], [20, 10], [0, 10]], np.int32)
    assert cv2.minAreaRect(upright) == ((10.0, 5.0), (10.0, 20.0), 90.0)
    corners = cv2.boxPoints(cv2.minAreaRect(points=upright)).round()
    assert sorted(corners.tolist()) == sorted(upright.tolist())


@pytest.mark.skipif(hasattr(cv2, "face"), reason="this OpenCV has it")
def test_what_only_contrib_modules_have_is_told_with_what_to_type():
    with pytest.raises(AttributeError, match=r"'face'.*pip install \"opencv-contrib-python-headless<5\""):
        cv2.face.LBPHFaceRecognizer_create()
    with pytest.raises(AttributeError, match=r"module 'cv2' has no attribute 'nothing'$"):
        _ = cv2.nothing


def test_after_the_last_session_opencv_is_as_it_was_found():
    added = set(older_opencv.ARUCO) - {name for name in older_opencv.ARUCO if name not in vars(cv2.aruco)}
    with Session(virtual=True).use():
        pass
    undo = older_opencv.add_aruco(None)
    undo()
    assert {name for name in older_opencv.ARUCO if name in vars(cv2.aruco)} == added


def test_the_smallest_rectangle_is_opencvs_own_again_after_it_was_turned():
    before = cv2.minAreaRect
    undo = older_opencv.turn_rectangles(None)
    assert cv2.minAreaRect is not before
    undo()
    assert cv2.minAreaRect is before


@pytest.mark.parametrize("order", [("cv2", "rclpy"), ("rclpy", "cv2")])
def test_a_plain_script_finds_the_markers_above_its_first_node(order):
    lines = "\n".join([*(f"import {name}" for name in order), "print(cv2.aruco.Dictionary_get(0).markerSize)"])
    done = subprocess.run([sys.executable, "-c", lines], capture_output=True, encoding="utf-8")
    assert done.stdout.split() == ["4"], done.stderr
