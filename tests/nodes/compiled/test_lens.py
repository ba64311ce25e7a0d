"""Compiled programs: a camera's calibration, loaded and stored, and what is seen through its lens."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
import rclpy
from camera_info_manager import loadCalibrationFile, saveCalibrationFile
from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program

K = np.array([[200.0, 0, 160], [0, 200, 120], [0, 0, 1]])
D = np.array([-0.25, 0.05, 0.001, 0.0, 0.0])


def calibration():
    p = np.hstack([K, np.zeros((3, 1))])
    info = CameraInfo(width=320, height=240, distortion_model="plumb_bob", d=D, k=K.ravel(), p=p.ravel())
    info.r = np.eye(3).ravel()
    return info


def numbers(line):
    return [float(word) for word in line.split()[1:]]


@pytest.fixture
def camera(session, build, tmp_path):
    saveCalibrationFile(calibration(), str(tmp_path / "eye.yaml"), "eye")
    path = build("lens", program("lens.cpp"))
    process = session.launch(make_process(session, path, [str(tmp_path)], name="lens"))
    session.clock.sleep(1.0)
    return process


def test_a_camera_sees_points_where_its_calibration_says(camera):
    lines = [line for line in camera.output.splitlines() if not line.startswith("[")]
    assert lines[:2] == ["1010", "0101"]
    pixel, ray, rectified, back = map(numbers, lines[2:6])
    assert pixel == [200 * 0.1 / 2 + 160, 200 * -0.05 / 2 + 120]
    assert ray == pytest.approx([(100 - 160) / 200, (50 - 120) / 200, 1], rel=1e-5)
    oracle = cv2.undistortPoints(np.array([[[80.0, 60.0]]]), K, D, R=np.eye(3), P=K)[0, 0]
    assert rectified == pytest.approx(oracle, abs=1e-3)
    assert back == pytest.approx([80, 60], abs=0.05)
    assert lines[6:8] == ["numbers 200 120 0 160 5 200 optical", "lit 1"]
    assert numbers(lines[8]) == [(160 - 40) / 2, (115 - 0) / 2]
    assert numbers(lines[9]) == [160, 115]
    assert lines[10:] == ["50", "Cannot call rectifyPoint when distortion is unknown."]


def test_a_calibration_that_a_calibrator_sets_is_stored(camera, session, tmp_path):
    rclpy.init()
    node = rclpy.create_node("calibrator")
    client = node.create_client(SetCameraInfo, "/camera/set_camera_info")
    better = calibration()
    better.k[0] = 210.0
    future = client.call_async(SetCameraInfo.Request(camera_info=better))
    rclpy.spin_until_future_complete(node, future)
    assert future.result().success
    assert loadCalibrationFile(str(tmp_path / "eye.yaml"), "eye").k[0] == 210.0
    camera.interrupt()
    assert camera.wait(5.0) == 0
    assert camera.output.splitlines()[-1] == "210"
    url = f"[camera]: camera calibration URL: file://{tmp_path}/eye.yaml"
    assert any(line.endswith(url) for line in camera.output.splitlines())
