"""camera_info_manager: calibrations come from files and go into them."""

import pytest
import rclpy
from camera_info_manager import CameraInfoManager, CameraInfoMissingError, loadCalibrationFile, saveCalibrationFile
from rclpy.executors import SingleThreadedExecutor
from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo

from coursekit.processes.session import Session

INFO = CameraInfo(width=640, height=480, distortion_model="plumb_bob", d=[0.1] * 5, k=[500.0] * 9, r=[1.0] * 9, p=[2.0] * 12)


@pytest.fixture
def node():
    with Session(virtual=True).use():
        rclpy.init()
        yield rclpy.create_node("camera")
        rclpy.shutdown()


def test_what_was_saved_is_loaded_again(tmp_path):
    file = tmp_path / "deep" / "left.yaml"
    assert saveCalibrationFile(INFO, str(file), "left")
    assert loadCalibrationFile(str(file), "left") == INFO and "camera_name: left" in file.read_text()


def test_a_manager_tells_what_is_in_its_file_once_it_was_loaded(node, tmp_path):
    saveCalibrationFile(INFO, str(tmp_path / "left.yaml"), "left")
    manager = CameraInfoManager(node, cname="left", url=f"file://{tmp_path}/${{NAME}}.yaml")
    with pytest.raises(CameraInfoMissingError, match="loadCameraInfo"):
        manager.getCameraInfo()
    manager.loadCameraInfo()
    assert manager.isCalibrated() and manager.getCameraInfo().width == 640
    assert manager.setCameraName("right") and not manager.setCameraName("no name") and not manager.setURL("http://x")
    manager.loadCameraInfo()
    assert not manager.isCalibrated()


@pytest.mark.parametrize("text", ["[1, 2]", "{image_width: wide}", "a: [", "\x00"])
def test_a_file_that_is_no_calibration_is_told_and_none_is_there(node, tmp_path, text):
    (tmp_path / "bad.yaml").write_text(text)
    manager = CameraInfoManager(node, url=f"file://{tmp_path}/bad.yaml")
    manager.loadCameraInfo()
    assert not manager.isCalibrated()


def test_a_calibrator_sets_and_stores_it(node, tmp_path):
    manager = CameraInfoManager(node, url=f"file://{tmp_path}/new.yaml")
    client = node.create_client(SetCameraInfo, "set_camera_info")
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    future = client.call_async(SetCameraInfo.Request(camera_info=INFO))
    executor.spin_until_future_complete(future, timeout_sec=2.0)
    assert future.result().success and manager.isCalibrated()
    assert loadCalibrationFile(str(tmp_path / "new.yaml"), "camera") == INFO
