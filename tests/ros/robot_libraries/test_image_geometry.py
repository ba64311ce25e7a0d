"""image_geometry: pixels and rays of one camera and of two."""

import math

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from image_geometry import PinholeCameraModel, StereoCameraModel
from sensor_msgs.msg import CameraInfo


def info(base=0.0, d=(), **more):
    k = [500.0, 0.0, 320.0, 0.0, 510.0, 240.0, 0.0, 0.0, 1.0]
    p = [500.0, 0.0, 320.0, -500.0 * base, 0.0, 510.0, 240.0, 0.0, 0.0, 0.0, 1.0, 0.0]
    return CameraInfo(width=640, height=480, k=k, d=list(d), r=np.eye(3).ravel().tolist(), p=p, **more)


def camera(**how):
    model = PinholeCameraModel()
    model.fromCameraInfo(info(**how))
    return model


@given(st.floats(0, 640), st.floats(0, 480), st.floats(0.1, 50))
def test_a_point_on_a_pixels_ray_is_seen_at_that_pixel(u, v, far):
    ray = camera().projectPixelTo3dRay((u, v))
    assert math.hypot(*ray) == pytest.approx(1.0)
    assert camera().project3dToPixel([far * number for number in ray]) == pytest.approx((u, v), abs=1e-6)


def test_what_lies_in_the_cameras_plane_is_seen_nowhere():
    assert all(map(math.isnan, camera().project3dToPixel((1.0, 1.0, 0.0))))


def test_binning_and_region_move_and_shrink_the_image():
    msg = info(binning_x=2, binning_y=2)
    msg.roi.x_offset, msg.roi.y_offset = 100, 40
    model = PinholeCameraModel()
    model.fromCameraInfo(msg)
    assert (model.fx(), model.cx(), model.cy()) == (250.0, 110.0, 100.0) and model.fullIntrinsicMatrix()[0, 0] == 500.0


def test_a_distorted_point_is_set_right_as_opencv_distorts_it():
    bent = camera(d=(-0.2, 0.05, 0.001, 0.002, 0.0))
    point = np.array([[[0.3, -0.2, 1.0]]])
    raw, _ = cv2.projectPoints(point, np.zeros(3), np.zeros(3), bent.K, bent.D)
    assert bent.rectifyPoint(raw.ravel()) == pytest.approx(bent.project3dToPixel(point.ravel()), abs=0.1)


def test_an_image_of_a_good_lens_stays_as_it_is():
    raw = np.random.default_rng(1).integers(0, 255, (480, 640), np.uint8)
    rectified = np.zeros_like(raw)
    camera(d=(0.0,) * 5).rectifyImage(raw, rectified)
    assert (rectified == raw).all()


@given(st.floats(0.5, 20), st.floats(-1, 1), st.floats(-1, 1))
def test_two_cameras_see_how_far_away_a_point_is(z, x, y):
    pair = StereoCameraModel()
    pair.fromCameraInfo(info(), info(base=0.12))
    left, right = pair.project3dToPixel((x, y, z))
    assert pair.getDisparity(z) == pytest.approx(left[0] - right[0]) and pair.getZ(left[0] - right[0]) == pytest.approx(z)
    point = pair.projectPixelTo3d(left, left[0] - right[0])
    assert (point[0], point[2]) == pytest.approx((x, z), abs=1e-6)


def test_sizes_and_angles_of_view():
    model = camera()
    assert model.getDeltaX(model.getDeltaU(0.3, 2.0), 2.0) == pytest.approx(0.3)
    assert model.fovX() == pytest.approx(2 * math.atan(0.64)) and model.getDeltaV(1.0, 0.0) == math.inf
