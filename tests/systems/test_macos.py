"""A Mac, made on Linux: no /proc, /tmp is a link, other programs of Python begin afresh instead of being forked.

What else a Mac has of its own stands beside what it is about: sockets of 104 bytes in tests/systems/test_runtime_folder.py,
names in any case in test_letter_case.py, zsh and its keys in test_typed.py, containers in tests/grade/test_container.py.
"""

import os
import subprocess
import sys
import tempfile

import pytest

from coursekit.systems import runtime_folder
from tests.needs import posix
from tests.paths import workspace
from tests.paths.workspace import type_in

WITHOUT_PROC = """
import os, sys

def refuse(event, words):
    if event in ("open", "os.listdir", "os.scandir") and str(words[0]).startswith("/proc"):
        raise FileNotFoundError(2, "No such file or directory", str(words[0]))

def missing(path, *words, real=os.stat, **named):
    if str(path).startswith("/proc"):
        raise FileNotFoundError(2, "No such file or directory", str(path))
    return real(path, *words, **named)

sys.addaudithook(refuse)
os.stat = missing
assert not os.path.exists("/proc/self/stat")
from coursekit.systems import operating_system
operating_system.MAC = True
"""
"""Begins a program on a computer that has no /proc, as a Mac has none."""


def on_a_mac(code, *words, folder=None, **variables):
    """What a program says that begins so, with its exit code."""
    command = [sys.executable, "-c", WITHOUT_PROC + code, *words]
    env = {**os.environ, "COURSEKIT_TIME": "virtual", "COURSEKIT_STOP_AFTER": "2", **variables}
    done = subprocess.run(command, cwd=folder, env=env, capture_output=True, encoding="utf-8", check=False)
    return done.returncode, done.stdout + done.stderr


ROS2 = "from coursekit.cli.ros2 import main; sys.exit(main(sys.argv[1:]))"
COURSEKIT = "from coursekit.cli.coursekit import main; sys.exit(main(sys.argv[1:]))"


@posix("it is Linux' /proc that is taken away")
def test_without_proc_programs_are_launched_and_heard(tmp_path):
    code, said = on_a_mac(ROS2, "launch", "demo_nodes_cpp", "talker_listener.launch.py", folder=tmp_path)
    assert code == 0 and "I heard: [Hello World: 1]" in said, said


@posix("it is Linux' /proc that is taken away")
def test_without_proc_the_doctor_ends_with_its_verdict(tmp_path):
    _, said = on_a_mac(COURSEKIT, "doctor", folder=tmp_path)
    assert "rclpy       coursekit's" in said and "terminals   sessions are found in" in said, said
    assert "Traceback" not in said, said


@pytest.fixture
def link(tmp_path):
    """A folder whose own name is a link, as /tmp is on macOS, where it leads to /private/tmp."""
    (tmp_path / "private" / "tmp").mkdir(parents=True)
    link = tmp_path / "tmp"
    link.symlink_to(tmp_path / "private" / "tmp", target_is_directory=True)
    return link


@posix("links are made without a right there")
def test_sessions_listen_below_a_folder_that_is_a_link(link, monkeypatch):
    for name in ("COURSEKIT_RUNTIME_DIR", "XDG_RUNTIME_DIR", "PYTEST_XDIST_WORKER"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(tempfile, "tempdir", str(link))
    monkeypatch.setattr("coursekit.systems.runtime_folder.socket_path_bytes", lambda: 1000)
    path, faults = runtime_folder.choose()
    assert path.parent == link and faults == []


@pytest.mark.slow
@posix("links are made without a right there")
@pytest.mark.parametrize("words", ["", "--symlink-install"])
def test_a_workspace_below_such_a_folder_is_built_found_and_launched(link, words):
    workspace.make(link / "ws")
    said = type_in(link.parent, "cd tmp/ws; colcon build $1", words)
    assert "2 packages finished" in said, said
    begin = "cd tmp/ws; . install/setup.bash; "
    prefix = type_in(link.parent, begin + "ros2 pkg prefix talks").strip()
    assert os.path.samefile(prefix, link / "ws" / "install" / "talks")
    said = type_in(link.parent, begin + "ros2 launch talks all.launch.py")
    assert "told by" in said and "Map saved" in said, said
    said = type_in(link.parent, begin + "ros2 run talks talk")
    assert "told by" in said and "colcon build" not in said, said


SPAWNING = """
import multiprocessing
import rclpy


def square(number):
    return number * number


def main():
    rclpy.init()
    node = rclpy.create_node("squares")
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        node.get_logger().info(f"told {pool.map(square, [2, 3])}")
    rclpy.shutdown()


if __name__ == "__main__":
    main()
"""


@pytest.mark.parametrize("way", ["package", "file"])
def test_a_program_that_begins_others_afresh_gets_their_answers(tmp_path, way):
    file = tmp_path / "squares.py"
    file.write_text(SPAWNING, encoding="utf-8")
    words = [str(file)] if way == "file" else ["-c", "import squares; squares.main()"]
    env = {**os.environ, "PYTHONPATH": os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")])}
    env["COURSEKIT_ALONE"] = "1"  # in no session that another test has left open
    done = subprocess.run([sys.executable, *words], env=env, capture_output=True, encoding="utf-8", check=False)
    assert "told [4, 9]" in done.stdout + done.stderr, done.stdout + done.stderr

