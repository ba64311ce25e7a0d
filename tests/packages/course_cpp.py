"""The course's sixteen nodes in C++ and their twins in Python as one workspace, for tests with several tools."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from tests.packages.test_cpp_workspace import BIN

FIXTURES = Path(__file__).parent.parent / "fixtures"
PYTHON = ("s2_py_pubsub", "s3_py_srvcli", "s4_py_apps", "s4_custom_interface")
NODES = {
    "s2_cpp_pubsub": ("publisher_exe", "subscriber_exe"),
    "s3_cpp_srvcli": ("server_exe", "client_exe", "client_async_exe"),
    "s4_cpp_apps": (
        *("hs_publisher_exe", "hs_subscriber_exe", "sphere_publisher_exe", "sphere_subscriber_exe"),
        *("add_server_exe", "add_client_exe"),
    ),
    "k_eyes": ("camera_exe", "camera_user_exe"),
    "s5_cpp_params": ("params_exe",),
    "s6_cpp_urdf": ("state_publisher_exe", "joint_listener_exe"),
}
"""The programs in C++ of each package."""


def lay_out(folder: Path) -> None:
    """Copy the packages into a workspace."""
    for source in (FIXTURES / "course_cpp_ws" / "src").iterdir():
        shutil.copytree(source, folder / "src" / source.name)
    shutil.copytree(FIXTURES / "cpp_camera_ws" / "src" / "k_eyes", folder / "src" / "k_eyes")
    for name in PYTHON:
        shutil.copytree(FIXTURES / "ros2_ws" / "src" / name, folder / "src" / name)


def build(folder: Path, env: dict[str, str]) -> str:
    """Build it; what colcon said."""
    words = [str(BIN / "colcon"), "--log-base", "log", "build", "--cmake-args", "-DCOURSEKIT_OPENCV=face"]
    done = subprocess.run(words, cwd=folder, env=env, capture_output=True, encoding="utf-8", check=False)
    said = done.stdout + done.stderr
    assert done.returncode == 0 and "10 packages finished" in said and "Skipped C++" not in said, said
    return said


RUN = """
from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session

with (session := Session(virtual={virtual})).use():
    def start(package, name, *words, **remapped):
        rules = [word for pair in remapped.items() for word in ("-r", ":=".join(pair))]
        words = [*words, "--ros-args", *rules] if rules else words
        return session.launch(make_process(session, find(package, name), words, name=name))
    def until(process, text, limit=20.0):
        end = session.clock.steady() + int(limit * 1e9)
        while text not in process.output and session.clock.steady() < end:
            session.clock.sleep(0.05)
        print("yes" if text in process.output else f"no {text!r} in {process.output!r}")
    {what}
"""


def told(folder: Path, env: dict[str, str], what: str, virtual: bool) -> str:
    """What a script prints that starts programs of the workspace in a session of its own."""
    text = RUN.replace("{virtual}", str(virtual)).replace("{what}", what.replace("\n", "\n    "))
    line = f"source install/setup.bash && '{sys.executable}' - <<'END'\n{text}END"
    bash = shutil.which("bash") or "bash"
    done = subprocess.run([bash, "-c", line], cwd=folder, env=env, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


PAIRS = """
cpp, py = start("s2_cpp_pubsub", "publisher_exe"), start("s2_py_pubsub", "publisher_exe")
ears = start("s2_cpp_pubsub", "subscriber_exe")
until(ears, "[cpp_subscriber_node]: heard 'C++ says 1'")
crossed = start("s2_cpp_pubsub", "subscriber_exe", cpp_str_topic="py_str_topic", __node="crossed")
until(crossed, "[crossed]: heard '")
twin = start("s2_py_pubsub", "subscriber_exe", py_str_topic="cpp_str_topic")
until(twin, "C++ says")
for one in (cpp, py, ears, crossed, twin): one.interrupt()
print(*(one.wait(5.0) for one in (cpp, ears, crossed)))
"""
SERVICES = """
server = start("s3_cpp_srvcli", "server_exe")
client = start("s3_cpp_srvcli", "client_exe", "20", "22")
print(client.wait(20.0), "sum: 42" in client.output)
wrong = start("s3_cpp_srvcli", "client_exe", "20")
print(wrong.wait(20.0), "usage: client_exe A B" in wrong.output)
until(start("s3_cpp_srvcli", "client_async_exe"), "answer: 101")
python = start("s3_py_srvcli", "server_exe")
crossed = start("s3_cpp_srvcli", "client_exe", "1", "2", cpp_add_two_ints_service="py_add_two_ints_service")
print(crossed.wait(20.0), "sum: 3" in crossed.output)
python.interrupt()
python.wait(5.0)
twin = start("s3_cpp_srvcli", "server_exe", cpp_add_two_ints_service="py_add_two_ints_service", __node="twin")
start("s3_py_srvcli", "client_exe", "3", "4")
until(twin, "3 + 4 = 7")
"""
INTERFACES = """
hs = start("s4_cpp_apps", "hs_publisher_exe")
until(start("s4_cpp_apps", "hs_subscriber_exe"), "41 degrees, motors up: motors are warm")
until(start("s4_py_apps", "hs_subscriber_exe", py_hs_topic="cpp_hs_topic"), "motors up: True")
start("s4_py_apps", "hs_publisher_exe")
until(start("s4_cpp_apps", "hs_subscriber_exe", cpp_hs_topic="py_hs_topic", __node="x"), "degrees")
start("s4_cpp_apps", "sphere_publisher_exe")
until(start("s4_cpp_apps", "sphere_subscriber_exe"), "centre 0.5 0.0 1.0, radius 0.20")
start("s4_cpp_apps", "add_server_exe")
asked = start("s4_cpp_apps", "add_client_exe", "1", "2", "3")
print(asked.wait(20.0), "sum: 6" in asked.output)
"""
STATES = """
start("s6_cpp_urdf", "state_publisher_exe")
until(start("s6_cpp_urdf", "joint_listener_exe"), "4 joints at ")
start("k_eyes", "camera_exe")
user = start("k_eyes", "camera_user_exe")
print(user.wait(1.0))
params = start("s5_cpp_params", "params_exe", "--ros-args", "-p", "camera.width:=320")
until(params, "hello 320x540")
"""
RIGHT = {
    "PAIRS": ["yes", "yes", "yes", "0 0 0"],
    "SERVICES": ["0 True", "1 True", "yes", "0 True", "yes"],
    "INTERFACES": ["yes", "yes", "yes", "yes", "0 True"],
    "STATES": ["yes", "None", "yes"],
}
"""What each prints."""
