"""`python3 node.py` in a terminal joins the session that runs; without one it has its own."""

import os
import subprocess
import sys

import pytest

PUBLISHER = """
import sys
from helper import WORD
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("plain")
publisher = node.create_publisher(String, "chatter", 10)
publisher.publish(String(data=WORD))
print("said it to", publisher.get_subscription_count(), "with", sys.argv[1:])
sys.exit(3)
"""


@pytest.fixture
def program(tmp_path):
    (tmp_path / "helper.py").write_text("WORD = 'from a file'\n")
    (tmp_path / "plain.py").write_text(PUBLISHER)
    return tmp_path / "plain.py"


@pytest.fixture
def surroundings(tmp_path):
    kept = {name: value for name, value in os.environ.items() if not name.startswith("COURSEKIT_")}
    return {**kept, "COURSEKIT_RUNTIME_DIR": str(tmp_path), "ROS_DOMAIN_ID": "78", "PYTHONUNBUFFERED": "1"}


def run(program, env):
    command = [sys.executable, program.name, "--flag"]
    return subprocess.run(command, cwd=program.parent, env=env, capture_output=True, encoding="utf-8", timeout=60)


def test_without_a_session_it_has_one_of_its_own(program, surroundings):
    ended = run(program, surroundings)
    assert (ended.returncode, ended.stdout, ended.stderr) == (3, "said it to 0 with ['--flag']\n", "")


@pytest.mark.slow
def test_it_joins_the_session_of_the_user_and_keeps_its_words_and_exit_code(program, surroundings):
    ros2 = [sys.executable, "-m", "coursekit.cli.ros2", "topic", "echo", "/chatter", "std_msgs/msg/String", "--once"]
    for _ in range(100):
        with subprocess.Popen(ros2, env=surroundings, stdout=subprocess.PIPE, encoding="utf-8") as echo:
            while "to 1" not in (ended := run(program, surroundings)).stdout and echo.poll() is None:
                assert ended.returncode == 3, ended.stderr
            told = echo.communicate(timeout=30)[0]
        if "to 1" in ended.stdout:
            break  # else the echo came between the count and the message, and has gone with it
    assert (ended.returncode, ended.stdout) == (3, "said it to 1 with ['--flag']\n")
    assert (echo.returncode, told) == (0, "data: from a file\n---\n")


SQUARES = """
import multiprocessing
import rclpy

def square(number):
    return number * number

if __name__ == "__main__":
    rclpy.init()
    node = rclpy.create_node("squares")
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        print("told", pool.map(square, [2, 3]))
    print("beside", node.count_subscribers("chatter"))
"""


@pytest.mark.slow
def test_it_may_start_interpreters_beside_a_session(program, surroundings):
    program.write_text(SQUARES)
    echo = [sys.executable, "-m", "coursekit.cli.ros2", "topic", "echo", "/chatter", "std_msgs/msg/String"]
    with subprocess.Popen(echo, env=surroundings, stdout=subprocess.DEVNULL) as session:
        for _ in range(100):
            ended = run(program, surroundings)
            assert ended.stdout.startswith("told [4, 9]\n"), ended.stderr
            if "beside 1" in ended.stdout:
                break
        session.terminate()
    assert "beside 1" in ended.stdout


def test_a_launch_file_runs_it_on_the_virtual_clock_in_the_session(program, surroundings):
    (program.parent / "both.launch.py").write_text(
        "from launch import LaunchDescription\n"
        "from launch.actions import ExecuteProcess\n"
        "from launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        f"    return LaunchDescription([Node(package='demo_nodes_py', executable='listener'),\n"
        f"        ExecuteProcess(cmd=['python3', {str(program)!r}], output='screen')])\n"
    )
    env = {**surroundings, "COURSEKIT_TIME": "virtual", "COURSEKIT_STOP_AFTER": "2"}
    command = [sys.executable, "-m", "coursekit.cli.ros2", "launch", str(program.parent / "both.launch.py")]
    ended = subprocess.run(command, env=env, capture_output=True, encoding="utf-8", timeout=60)
    assert "I heard: [from a file]" in ended.stdout + ended.stderr
    assert "process has died [pid 1002, exit code 3" in ended.stdout + ended.stderr
