"""Where a real ROS 2 is sourced, its `ros2` and its rclpy are used, and `coursekit doctor` says so."""

import os
import subprocess
import sys

import pytest

from tests.needs import posix


@pytest.fixture
def sourced(tmp_path):
    """The environment after a real setup.bash: a prefix with ros2cli, its modules on PYTHONPATH."""
    script = tmp_path / "bin" / "ros2"
    script.parent.mkdir()
    script.write_text('#!/bin/sh\necho the real one: "$@"\n')
    script.chmod(0o755)
    (tmp_path / "share" / "ros2cli").mkdir(parents=True)
    (tmp_path / "site" / "rclpy").mkdir(parents=True)
    (tmp_path / "site" / "rclpy" / "__init__.py").write_text("")
    env = {name: value for name, value in os.environ.items() if not name.startswith("COURSEKIT_")}
    return {**env, "AMENT_PREFIX_PATH": str(tmp_path), "PYTHONPATH": str(tmp_path / "site")}


def run(env, *words):
    done = subprocess.run([sys.executable, *words], env=env, capture_output=True, encoding="utf-8", timeout=60)
    return done.stdout.strip()


@posix("a program of sh is none")
def test_ros2_is_the_real_one(sourced):
    assert run(sourced, "-m", "coursekit.cli.ros2", "topic", "list") == "the real one: topic list"


def test_rclpy_is_the_real_one_and_doctor_says_so(sourced, tmp_path):
    assert run(sourced, "-c", "import rclpy; print(rclpy.__file__)").startswith(str(tmp_path))
    assert "a real ROS 2 is sourced or installed" in run(sourced, "-m", "coursekit.cli.coursekit", "doctor")
