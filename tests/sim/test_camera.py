"""The virtual camera's scene."""

import cv2
import numpy as np
import pytest

from coursekit.sim.camera import ROBOT_MARKER, WALL_MARKER, Scene

SCENE = Scene()
HSV = {
    "red": ((0, 150, 100), (8, 255, 255)),
    "green": ((50, 120, 80), (75, 255, 255)),
    "blue": ((98, 150, 90), (118, 255, 255)),
}


def markers(image):
    detector = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50))
    corners, numbers, _ = detector.detectMarkers(image)
    return {} if numbers is None else {int(n): c[0] for n, c in zip(numbers.ravel(), corners, strict=True)}


@pytest.mark.parametrize("size", [(640, 480), (320, 240), (960, 540), (1280, 720), (64, 48)])
def test_any_size_is_the_same_view_every_time(size):
    width, height = size
    image = SCENE.render(2.0, width, height)
    assert image.shape == (height, width, 3) and image.dtype == np.uint8
    assert np.array_equal(image, Scene().render(2.0, width, height))


def test_the_picture_moves():
    assert not np.array_equal(SCENE.render(1.0), SCENE.render(1.1))


@pytest.mark.parametrize("colour", HSV)
@pytest.mark.parametrize("t", [0.7, 2.2, 7.3])
def test_a_ball_can_be_tracked_by_its_colour(colour, t):
    hsv = cv2.cvtColor(SCENE.render(t), cv2.COLOR_BGR2HSV)
    moments = cv2.moments(cv2.inRange(hsv, *map(np.array, HSV[colour])), binaryImage=True)
    centre = (moments["m10"] / moments["m00"], moments["m01"] / moments["m00"])
    (ball,) = [candidate for candidate in SCENE.balls(t) if candidate.colour == colour]
    assert centre == pytest.approx(SCENE.pixel(ball.centre), abs=4.0)


def test_the_wall_s_marker_is_always_seen_and_the_robot_s_nearly_so():
    seen = [markers(SCENE.render(t)) for t in np.arange(0.0, 12.0, 0.5)]
    assert all(WALL_MARKER in seen_markers for seen_markers in seen)
    assert sum(ROBOT_MARKER in seen_markers for seen_markers in seen) > 0.8 * len(seen)


def test_the_robot_s_marker_is_where_the_robot_is():
    for t in (1.0, 4.0, 9.0):
        corners = markers(SCENE.render(t))[ROBOT_MARKER]
        x, y, _ = SCENE.robot(t)
        assert corners.mean(axis=0) == pytest.approx(SCENE.pixel((x, y, 0.18)), abs=4.0)


def test_the_camera_matrix_projects_as_the_picture_does():
    point = (0.4, 3.0, 0.2)
    u, v, w = Scene.camera_matrix(640, 480) @ np.array(Scene.in_camera(point))
    assert (u / w, v / w) == pytest.approx(SCENE.pixel(point))
