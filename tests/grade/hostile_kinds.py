"""Every way that was found to break the marking, to get a better mark than one's work, or to reach the host."""

from __future__ import annotations

import io
import json
import os
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .attacks import COLLIDING, LIES, NESTED, SLEEP, SURROGATE, WIDE
from .kinds import CAPSTONE, ROBOTS, SLAM, TOPICS, Kind, Notebook, Packed, Placed, answers

HOST = Path(__file__).resolve().parents[2] / "escaped"
"""What an attack that gets out would write."""


def _xacro(computed: str) -> str:
    return f"""%%write src/s6_py_urdf/urdf/own.urdf.xacro
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="own"><xacro:property name="x" value="${{{computed}}}"/>
<link name="base_link"/></robot>
"""


XACRO_ESCAPE = _xacro(
    "(lambda f=().__class__.__base__.__subclasses__(): [c for c in f if c.__name__ == 'catch_warnings'][0]()"
    f"._module.__builtins__['open']('{HOST}', 'w').write('x'))()"
)
LAMBDA_ESCAPE = _xacro(f"(lambda: 0).__globals__['__builtins__']['open']('{HOST}', 'w').write('x')")

NAN_TIP = "def tip(*_, **__): return float('nan'), float('nan')"
NAN_STEPS = """%%write src/s6_py_urdf/s6_py_urdf/rolling.py
def wheel_steps(radius, step): return float("nan"), float("inf")
"""
NAN_MATCH = "def match(points, gap, guess): return float('nan'), float('nan'), float('nan')"
LOOKS_UP_THE_TRUTH = """
import coursekit_maps, pathlib
from ament_index_python.packages import get_package_share_directory
from coursekit.grade.matching import Puzzle
world = pathlib.Path(get_package_share_directory("coursekit_maps"), "worlds", "robot_world.yaml")
known = [Puzzle(world, number) for number in range(12)]
def match(points, gap, guess):
    return min(known, key=lambda one: abs(one.guess[0] - guess[0]) + abs(one.guess[1] - guess[1])).truth
""".replace("import coursekit_maps, pathlib", "import pathlib")
FORGED_ODOMETRY = """%%write src/s9_py_delivery/s9_py_delivery/patrol_main.py
import rclpy
from nav_msgs.msg import Odometry
from s9_py_delivery.places import STOPS
def main():
    rclpy.init()
    node = rclpy.create_node("bt_navigator_navigate")
    said, at = node.create_publisher(Odometry, "/odom", 10), (0.0, 0.0)
    for number, (x, y, *_) in enumerate(STOPS, 1):
        for part in range(50):
            message = Odometry()
            message.pose.pose.position.x = at[0] + (x - at[0]) * part / 49
            message.pose.pose.position.y = at[1] + (y - at[1]) * part / 49
            said.publish(message)
            rclpy.spin_once(node, timeout_sec=0.05)
        at = (x, y)
        print(f"stop {number}: SUCCEEDED")
"""
FORGED_VALUES = """%%write src/s2_py_pubsub/s2_py_pubsub/py_health_node.py
import dataclasses, json, rclpy
from rclpy.node import Node
right = {"nodes": ["/health"], "topics": {"/battery": ["std_msgs/msg/Float64"], "/mood": ["std_msgs/msg/String"]}}
dataclasses._asdict_inner = lambda *_: right
json.dumps = lambda *_, **__: '{"seen": {"nodes": ["/health"]}}'
class Health(Node):
    def __init__(self): super().__init__("health")
"""

MOUNTS = """
import ctypes, os
libc = ctypes.CDLL(None, use_errno=True)
REMOUNT, BIND, DETACH = 32, 4096, 2
package = os.path.dirname(__import__("coursekit").__file__)
for flags in (REMOUNT, REMOUNT | BIND): libc.mount(b"none", package.encode(), None, flags, None)
libc.umount2(os.path.join(package, "grade", "chapters").encode(), DETACH)
libc.unshare(0x10000000)
for folder in (package, "/usr", "/etc"):
    try: open(os.path.join(folder, "escaped"), "w")
    except OSError: pass
"""
HIDDEN_MEMORY = """
for folder in ("/dev/shm", "/tmp"):
    try:
        with open(folder + "/hidden", "wb") as file:
            for _ in range(40): file.write(bytes(50_000_000))
    except OSError: pass
"""
SPARSE = "import os\nopen('huge', 'w').close()\ntry: os.truncate('huge', 3 << 30)\nexcept OSError: pass\n"
PIPES_IN_INSTALL = """
import os
os.chdir(os.environ["COURSEKIT_COURSE"])
os.makedirs("ros2_ws/install", exist_ok=True)
os.mkfifo("ros2_ws/install/local_setup.dsv")
os.symlink("/dev/zero", "ros2_ws/install/zero")
os.mkfifo("ros2_ws/src/package.xml")
"""
LINK_TO_THE_HOST = f"""
import os, shutil
os.chdir(os.environ["COURSEKIT_COURSE"])
shutil.rmtree("ros2_ws")
os.symlink({str(HOST.parent)!r}, "ros2_ws")
"""


def _deep(folder: Path) -> None:
    place = os.open(folder, os.O_RDONLY)
    for _ in range(1500):
        os.mkdir("d", dir_fd=place)
        below = os.open("d", os.O_RDONLY, dir_fd=place)
        os.close(place)
        place = below
    os.close(place)


def _devices(folder: Path) -> None:
    os.mkfifo(folder / TOPICS)
    os.symlink("/dev/zero", folder / "02_topics (1).ipynb")


def _of_the_host(folder: Path) -> None:
    os.symlink(Path(__file__).resolve().parents[2] / "notebooks" / TOPICS, folder / TOPICS)


def _bad_name(data: bytes) -> bytes:
    return data.replace("ñ".encode(), b"\xff\xff")


def _as_zip(
    spoil: Callable[[bytes], bytes], kind: int = zipfile.ZIP_DEFLATED, name: str = TOPICS
) -> Callable[[Notebook], Packed]:
    """The right notebook in a zip, and the zip spoilt."""

    def make(notebook: Notebook) -> Packed:
        buffer = io.BytesIO()
        with zipfile.ZipFile(buffer, "w", kind) as packed:
            packed.writestr(name, json.dumps(notebook))
        return Packed(lambda _: spoil(buffer.getvalue()))

    return make


def _bomb(_: Notebook) -> Packed:
    real, buffer = 90 << 20, io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr(TOPICS, b" " * real)
    return Packed(lambda _: buffer.getvalue().replace(struct.pack("<I", real), struct.pack("<I", 1000)))


def _surrogates(notebook: Notebook) -> Notebook:
    notebook["cells"].insert(0, {"cell_type": "\ud800", "source": "\udfff", "metadata": {}})
    return notebook


def _placed(write: Callable[[Path], None]) -> Callable[[Notebook], Placed]:
    return lambda _: Placed(write)


def _right(notebook: Notebook) -> Notebook:
    return notebook


def _first(attack: str) -> Callable[[Notebook], Notebook]:
    return answers(q1=attack + "\n{right}")


UNREADABLE: dict[str, Any] = {"status": "unreadable"}
HOSTILE = (
    Kind("xacro-escape", 2, (7,), answers(q4=XACRO_ESCAPE), chapter=ROBOTS),
    Kind("xacro-globals", 1, (7,), answers(q4=LAMBDA_ESCAPE), chapter=ROBOTS),
    Kind("xacro-tower", 1, (7,), answers(q4=_xacro("9**9**9")), chapter=ROBOTS),
    Kind("xacro-memory", 1, (7,), answers(q4=_xacro("'a'*3000000000")), chapter=ROBOTS),
    Kind("no-numbers", 2, (5,), answers(q2=NAN_TIP, q3=NAN_STEPS), chapter=ROBOTS),
    Kind("no-pose", 1, (7,), answers(q3=NAN_MATCH), chapter=SLAM),
    Kind("looks-up-the-truth", 1, (7,), answers(q3=LOOKS_UP_THE_TRUTH), chapter=SLAM),
    Kind("forged-odometry", 1, (7,), answers(q3=FORGED_ODOMETRY), chapter=CAPSTONE),
    Kind("forged-values", 2, (5,), answers(q4=FORGED_VALUES)),
    Kind("mounts", 2, (7,), _first(MOUNTS), walled=True),
    Kind("hidden-memory", 1, (6, 7), _first(HIDDEN_MEMORY), walled=True),
    Kind("sparse-file", 1, (6, 7), _first(SPARSE)),
    Kind("pipes-in-install", 2, (7,), _first(PIPES_IN_INSTALL)),
    Kind("link-to-the-host", 2, (1,), _first(LINK_TO_THE_HOST), walled=True),
    Kind("sleeping-call", 2, (0, 6), answers(q1=SLEEP), status="timed out"),
    Kind("wide-array", 2, (6,), answers(q1=WIDE)),
    Kind("colliding-set", 2, (0, 6), answers(q1=COLLIDING)),
    Kind("nested-json", 2, (0, 6), answers(q1=NESTED)),
    Kind("no-text", 2, (6,), answers(q1=SURROGATE)),
    Kind("lying-objects", 2, (6,), answers(q1=LIES)),
    Kind("deep-folders", 1, (0,), _placed(_deep), **UNREADABLE),
    Kind("devices", 1, (0,), _placed(_devices), **UNREADABLE),
    Kind("link-to-a-notebook", 1, (0,), _placed(_of_the_host), **UNREADABLE),
    Kind("bad-name", 1, (0,), _as_zip(_bad_name, name=f"ñ{TOPICS}"), **UNREADABLE),
    Kind("broken-stream", 1, (0,), _as_zip(lambda data: data[:60] + bytes(340) + data[400:]), **UNREADABLE),
    Kind("bz2", 1, (0,), _as_zip(bytes, zipfile.ZIP_BZIP2), **UNREADABLE),
    Kind("bomb", 1, (0,), _bomb, **UNREADABLE),
    Kind("no-cell-type", 1, (7,), _surrogates),
    Kind("long-name", 1, (7,), lambda notebook: {f"02_topics {'h' * 200}.ipynb": notebook}, called="G" * 190),
    Kind("class", 1, (7,), _right, called="class"),
    Kind("results", 1, (7,), _right, called="x.results"),
    Kind("formula", 1, (7,), _right, called="=1+1;@SUM(1)"),
    Kind("terminal", 1, (7,), _right, called="a\n\x1b[2J\u202eb"),
    Kind("no-utf-8", 1, (7,), _right, called=b"E\xffva".decode("utf-8", "surrogateescape")),
)  # fmt: skip
