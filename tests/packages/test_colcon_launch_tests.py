"""`colcon test` runs the launch tests of a package and reports them."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.needs import real_windows

BIN = Path(sys.executable).parent
FILES = {
    "package.xml": """<?xml version="1.0"?>
<package format="3">
  <name>tested</name>
  <version>0.0.0</version>
  <description>With launch tests.</description>
  <maintainer email="a@example.com">a</maintainer>
  <license>Apache-2.0</license>
  <test_depend>launch_testing</test_depend>
  <test_depend>launch_testing_ros</test_depend>
  <test_depend>launch_pytest</test_depend>
  <test_depend>python3-pytest</test_depend>
  <export><build_type>ament_python</build_type></export>
</package>
""",
    "setup.py": """from setuptools import setup

setup(
    name='tested', version='0.0.0', packages=['tested'], tests_require=['pytest'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/tested']),
        ('share/tested', ['package.xml']),
    ],
    entry_points={'console_scripts': ['counter = tested.counter:main']},
)
""",
    "setup.cfg": "[develop]\nscript_dir=$base/lib/tested\n[install]\ninstall_scripts=$base/lib/tested\n",
    "resource/tested": "",
    "tested/__init__.py": "",
    "tested/counter.py": """import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node('counter')
    node.create_timer(1.0, lambda: node.get_logger().info('counted'))
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
""",
    "test/test_counter_launch.py": """import unittest

import launch
import launch_ros.actions
import launch_testing.actions
import launch_testing.asserts
import pytest


@pytest.mark.rostest
def generate_test_description():
    counter = launch_ros.actions.Node(package='tested', executable='counter')
    return launch.LaunchDescription([counter, launch_testing.actions.ReadyToTest()])


class TestCounter(unittest.TestCase):
    def test_counts(self, proc_output):
        proc_output.assertWaitFor('WORD')


@launch_testing.post_shutdown_test()
class TestEnd(unittest.TestCase):
    def test_code(self, proc_info):
        launch_testing.asserts.assertExitCodes(proc_info)
""",
    "test/test_counter_pytest.py": """import launch
import launch_pytest
import launch_ros.actions
import pytest
from launch_pytest.tools import process


@pytest.fixture
def counter():
    return launch_ros.actions.Node(package='tested', executable='counter', cached_output=True)


@launch_pytest.fixture
def described(counter):
    return launch.LaunchDescription([counter])


@pytest.mark.launch(fixture=described)
def test_counts(counter, launch_context):
    assert process.wait_for_stderr_sync(launch_context, counter, lambda text: 'counted' in text, timeout=5)
    yield
    assert counter.return_code == 0
""",
}


@pytest.fixture
def workspace(tmp_path):
    def make(word):
        for name, text in FILES.items():
            path = tmp_path / "src" / "tested" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text.replace("WORD", word))
        return tmp_path

    return make


def colcon(folder, *args):
    env = {key: value for key, value in os.environ.items() if not key.endswith("_PREFIX_PATH") and key != "PYTHONPATH"}
    env |= {"PATH": f"{BIN}{os.pathsep}{env['PATH']}", "COURSEKIT_TIME": "virtual", "ROS_LOG_DIR": str(folder / "ros")}
    command = [str(BIN / "colcon"), "--log-base", "log", *args]
    return subprocess.run(command, cwd=folder, env=env, capture_output=True, encoding="utf-8", check=False)


@real_windows("its cmd does not read a variable twice, as colcon's package.bat asks for")
@pytest.mark.slow
@pytest.mark.parametrize(("word", "failures"), [("counted", "0 failures"), ("never said", "1 failure")])
def test_launch_tests_of_a_package_are_run_and_reported(workspace, word, failures):
    folder = workspace(word)
    built = colcon(folder, "build")
    assert built.returncode == 0, built.stdout + built.stderr
    assert "tests_require" not in built.stderr, "a word of Humble's setup.py is no unknown one"
    tested = colcon(folder, "test", "--packages-select", "tested")
    result = colcon(folder, "test-result", "--all", "--verbose")
    assert f"Summary: 2 tests, 0 errors, {failures}, 0 skipped" in result.stdout, tested.stderr + result.stdout
    assert result.returncode == int(failures[0])
    assert ("FAIL: test_counter_launch.TestCounter.test_counts" in result.stdout) == bool(result.returncode)
