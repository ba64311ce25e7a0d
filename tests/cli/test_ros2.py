"""The `ros2` command from a shell: texts, exit codes, the same bytes every time, the session that all terminals share."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from coursekit.systems import children
from tests.needs import in_wine

ROS2 = [str(Path(sys.executable).with_name("ros2"))]


def environment(**more):
    env = {key: value for key, value in os.environ.items() if not key.startswith(("COURSEKIT_", "ROS_", "AMENT_"))}
    return env | more


def ros2(*words, stop_after=3, **more):
    """Run a command alone on the virtual clock."""
    env = environment(COURSEKIT_TIME="virtual", COURSEKIT_STOP_AFTER=str(stop_after), **more)
    return subprocess.run([*ROS2, *words], env=env, capture_output=True, encoding="utf-8", timeout=60)


def test_a_node_runs_until_ctrl_c_and_two_runs_print_the_same_bytes():
    one, other = (ros2("run", "demo_nodes_py", "talker", stop_after=3.5) for _ in range(2))
    assert one.returncode == 0
    assert one.stderr.splitlines() == [
        f'[INFO] [170000000{second}.000000000] [talker]: Publishing: "Hello World: {second - 1}"' for second in (1, 2, 3)
    ]
    assert (one.stdout, one.stderr) == (other.stdout, other.stderr)


def test_names_and_remappings_of_the_command_line_reach_the_node():
    done = ros2("run", "demo_nodes_py", "talker", "--ros-args", "-r", "__node:=vera", "-r", "__ns:=/fleet", stop_after=1.5)
    assert "[fleet.vera]: Publishing" in done.stderr


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (["run", "nope", "talker"], 1, "Package 'nope' not found"),
        (["run", "demo_nodes_py", "nope"], 1, "No executable found"),
        (["topic", "info", "/nope"], 1, "Unknown topic '/nope'"),
        (["topic", "type", "/nope"], 1, ""),
        (["topic", "echo", "/nope"], 1, "WARNING: topic [/nope] does not appear to be published yet"),
        (["topic", "pub", "/t", "std_msgs/msg/Nope"], 1, "The passed message type is invalid"),
        (["topic", "pub", "/t", "std_msgs/msg/String", "hello"], 1, "The passed value needs to be a dictionary in YAML"),
        (["topic", "pub", "/t", "std_msgs/msg/String", "{nope: 1}"], 1, "Failed to populate field"),
        (["node", "info", "/nope"], 1, "Unable to find node '/nope'"),
        (["param", "get", "/nope", "a"], 1, "Node not found"),
        (["interface", "package", "nope"], 1, "Unknown package 'nope'"),
        (["lifecycle", "get", "/nope"], 1, "Node not found"),
        (["launch", "nope", "x.launch.py"], 1, "nope"),
        (["nonsense"], 2, "invalid choice"),
    ],
)
def test_what_cannot_be_done_is_said_with_ros_s_words_and_exit_code(words, code, text):
    done = ros2(*words)
    assert done.returncode == code, done.stderr
    assert text in done.stdout + done.stderr
    assert "Traceback" not in done.stderr


def test_interfaces_are_shown_with_nested_fields_indented_by_tabs():
    done = ros2("interface", "show", "geometry_msgs/msg/Twist", "--no-comments")
    assert done.stdout.splitlines() == [
        "Vector3  linear", "\tfloat64 x", "\tfloat64 y", "\tfloat64 z",
        "Vector3  angular", "\tfloat64 x", "\tfloat64 y", "\tfloat64 z",
    ]  # fmt: skip
    assert ros2("interface", "proto", "std_msgs/msg/String").stdout == "\"data: ''\n\"\n"


def test_a_launch_file_with_a_syntax_error_names_file_and_line(tmp_path):
    file = tmp_path / "bad.launch.py"
    file.write_text("def generate_launch_description(:\n")
    done = ros2("launch", str(file))
    assert done.returncode == 1 and "bad.launch.py" in done.stdout + done.stderr


@pytest.fixture
def terminals(tmp_path):
    """Starts commands that share a session of their own, as several terminals of one user do."""
    env = environment(COURSEKIT_RUNTIME_DIR=str(tmp_path), ROS_DOMAIN_ID="77", PYTHONUNBUFFERED="1")
    started = []

    def start(*words):
        process = subprocess.Popen(
            [*ROS2, *words], env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.PIPE,
            encoding="utf-8", **children.apart(),
        )  # fmt: skip
        started.append(process)
        return process

    yield start
    for process in started:
        if process.poll() is None:
            process.kill()
        process.communicate()


def read_line(stream, wanted):
    """The first line that contains `wanted`."""
    give_up = time.monotonic() + 30
    while time.monotonic() < give_up:
        line = stream.readline()
        if wanted in line:
            return line
    pytest.fail(f"no line with {wanted!r} came")


def test_a_command_whose_reader_has_gone_ends_without_a_word(terminals):
    listing = terminals("interface", "list")
    listing.stdout.close()
    assert listing.stderr.read() == "" and listing.wait(60) == 128 + 13


def test_terminals_share_the_graph_and_ctrl_c_ends_only_its_own_command(terminals):
    talker = terminals("run", "demo_nodes_py", "talker")
    read_line(talker.stderr, "Publishing")
    listener = terminals("run", "demo_nodes_py", "listener")
    assert "I heard: [Hello World" in read_line(listener.stderr, "I heard")
    nodes, _ = terminals("node", "list").communicate(timeout=30)
    assert nodes.splitlines() == ["/listener", "/talker"]
    echo, _ = terminals("topic", "echo", "/chatter", "--once").communicate(timeout=30)
    assert echo.startswith("data: 'Hello World") and echo.endswith("---\n")
    children.send_signal(listener, signal.SIGINT)
    assert listener.wait(timeout=30) == (1 if in_wine() else 0)  # there Ctrl-Break reaches no program without a console
    nodes, _ = terminals("node", "list").communicate(timeout=30)
    assert nodes.splitlines() == ["/talker"]
    talker.terminate()
    assert talker.wait(timeout=30) is not None


def test_a_terminal_that_is_closed_takes_its_process_with_it(terminals):
    talker = terminals("run", "demo_nodes_py", "talker")
    read_line(talker.stderr, "Publishing")
    talker.kill()
    talker.wait(timeout=30)
    give_up = time.monotonic() + 30
    while time.monotonic() < give_up:
        nodes, _ = terminals("node", "list").communicate(timeout=30)
        if "/talker" not in nodes:
            return
    pytest.fail("the talker lives on")


def test_help_lists_the_commands():
    done = subprocess.run([*ROS2, "--help"], env=environment(), capture_output=True, encoding="utf-8", timeout=60)
    assert done.returncode == 0
    assert all(f"    {name} " in done.stdout for name in ("run", "launch", "topic", "doctor", "pkg"))


def test_a_word_is_completed_by_tab(tmp_path):
    answers = tmp_path / "answers"
    env = environment(
        _ARGCOMPLETE="1", _ARGCOMPLETE_STDOUT_FILENAME=str(answers), COMP_LINE="ros2 run demo_nodes_p", COMP_POINT="21",
        _ARGCOMPLETE_IFS="\n", _ARGCOMPLETE_SUPPRESS_SPACE="1", COMP_TYPE="9",
    )  # fmt: skip
    subprocess.run(ROS2, env=env, capture_output=True, timeout=60)
    assert "demo_nodes_py" in answers.read_text().replace("\x0b", "\n").split()
