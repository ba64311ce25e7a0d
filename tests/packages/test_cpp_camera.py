"""Chapter 5's two nodes in C++: built by colcon, they take pictures of the virtual camera and show their windows.

With the headers here, whose functions Python's cv2 answers, and with the system's OpenCV where it has one for C++.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.needs import compiler_or_skip
from tests.packages.test_cpp_workspace import colcon, scripted, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
SOURCES = Path(__file__).parent.parent / "fixtures" / "cpp_camera_ws" / "src"
HAS_OPENCV = any(Path("/usr/lib").glob("*/cmake/opencv4/OpenCVConfig.cmake"))
"""Whether Debian's libopencv-dev is here."""


@pytest.fixture(scope="module", params=["face", "system"])
def workspace(request, tmp_path_factory):
    compiler_or_skip()
    if request.param == "system" and not HAS_OPENCV:
        pytest.skip("NOT TESTED: no OpenCV for C++: apt-get install libopencv-dev")
    folder = tmp_path_factory.mktemp("cpp_camera_ws")
    shutil.copytree(SOURCES, folder / "src")
    built = colcon(folder, "build", "--cmake-args", f"-DCOURSEKIT_OPENCV={request.param}")
    assert built.returncode == 0 and "1 package finished" in built.stdout, built.stdout + built.stderr
    assert "stderr" not in built.stdout + built.stderr
    return folder


SEEN = """
from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session
from coursekit.sim.camera import Scene
from coursekit.view.desk import desk
from sensor_msgs.msg import Image
import numpy as np
import rclpy

with (session := Session(virtual=True)).use():
    def start(name, *words):
        return session.launch(make_process(session, find("k_eyes", name), words, name=name))
    camera = start("camera_exe", "--ros-args", "-p", "camera.width:=320", "-p", "camera.height:=240")
    user = start("camera_user_exe")
    rclpy.init()
    node = rclpy.create_node("listener")
    heard = []
    node.create_subscription(Image, "camera/image_raw", heard.append, 1)
    while len(heard) < 40:
        rclpy.spin_once(node)
    last = heard[-1]
    print(last.width, last.height, last.encoding, last.step, last.header.frame_id)
    apart = (heard[-1].header.stamp.nanosec - heard[-2].header.stamp.nanosec) % 10**9
    print(round(apart / 1e6))
    picture = np.frombuffer(bytes(last.data), np.uint8).reshape(240, 320, 3)
    hall = Scene().render(0.0, 320, 240)
    print(np.median(np.abs(picture.astype(int) - hall)) < 10, (picture == (0, 255, 0)).all(2).sum() > 50)
    for name, window in sorted(desk().windows.items()):
        print(name, window.image.shape, window.shown > 10)
    desk().press("q")
    print(user.wait(5.0), sorted(desk().windows))
    camera.interrupt()
    print(camera.wait(5.0), camera.output.splitlines()[1].split("] ")[-1])
"""


def test_the_user_shows_what_the_camera_sees(workspace):
    said = scripted(workspace, SEEN)
    assert said.stdout.splitlines() == [
        "320 240 bgr8 960 camera",
        "33",
        "True True",
        "cpp_camera_user_node (240, 320, 3) True",
        "cpp_camera_user_node strip (120, 480) True",
        "0 []",
        "0 [cpp_camera_node]: 30.0 FPS",
    ], said.stdout + said.stderr


def test_a_launch_file_gives_the_camera_its_size(workspace):
    said = sourced(workspace, "COURSEKIT_STOP_AFTER=2.5 ros2 launch k_eyes eyes.launch.py").stdout
    assert "[camera_exe-1] [INFO] [1700000002" in said and "[cpp_camera_node]: 30.0 FPS" in said
    assert "process has died" not in said


def test_a_camera_that_is_not_there_ends_the_program(workspace):
    said = sourced(workspace, "ros2 run k_eyes camera_exe --ros-args -p camera.deviceID:=7")
    assert "no camera: is camera.deviceID right?" in said.stdout + said.stderr
    assert "[ros2run]: Aborted" in said.stdout + said.stderr and said.returncode == 250
