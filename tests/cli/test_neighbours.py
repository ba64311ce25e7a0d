"""Programs in plain interpreters beside each other meet, as on a robot; test runs do not meet each other."""

import json
import os
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from tests.needs import posix

TALKER = """
import sys, rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node(sys.argv[1])
publisher = node.create_publisher(String, "chatter", 10)
node.create_timer(0.05, lambda: publisher.publish(String(data=sys.argv[1])))
print("ready", flush=True)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
"""
LISTENER = """
import sys, rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("listener")
wanted, done = set(sys.argv[1:]), rclpy.task.Future()
def hear(message):
    wanted.discard(message.data)
    if not wanted and not done.done():
        done.set_result(True)
node.create_subscription(String, "chatter", hear, 10)
if not wanted:
    done.set_result(True)
rclpy.spin_until_future_complete(node, done, timeout_sec=30.0)
print(sorted(name for name in node.get_node_names() if name != "listener"), sorted(wanted), flush=True)
"""

FORKED = """
import multiprocessing, rclpy
rclpy.init()
node = rclpy.create_node("parent")

def child(start):
    start.wait()
    context = rclpy.Context()
    rclpy.init(context=context)
    mine = rclpy.create_node("child", context=context)
    done.put(sorted(mine.get_node_names()))

fork = multiprocessing.get_context("fork")
start, done = fork.Event(), fork.Queue()
process = fork.Process(target=child, args=(start,))
process.start()
start.set()
print(done.get(), sorted(node.get_node_names())[-1:], flush=True)
process.join()
"""


@pytest.fixture
def programs(tmp_path):
    """Starts `python FILE WORDS` in the domain of the test; ends what still runs afterwards."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("COURSEKIT", "PYTEST"))}
    env = {**kept, "COURSEKIT_RUNTIME_DIR": str(tmp_path), "ROS_DOMAIN_ID": "83", "PYTHONUNBUFFERED": "1"}
    running = []

    def start(text: str, *words: str, how: tuple[str, ...] = (), **variables: str) -> subprocess.Popen:
        file = tmp_path / f"program{len(running)}.py"
        file.write_text(text)
        command = [sys.executable, *(how or (str(file),)), *words]
        streams = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "encoding": "utf-8"}
        child = subprocess.Popen(command, env=env | variables, cwd=tmp_path, **streams)
        running.append(child)
        return child

    yield start
    for child in running:
        child.kill()
        child.wait()
        child.stdin.close()
        child.stdout.close()


def talker(programs, name: str, **variables: str) -> subprocess.Popen:
    child = programs(TALKER, name, **variables)
    assert child.stdout.readline() == "ready\n"
    return child


def test_two_programs_started_by_path_meet_whichever_comes_first(programs):
    talker(programs, "one")
    late = programs(LISTENER, "one", "two")
    talker(programs, "two")
    assert late.communicate()[0] == "['one', 'two'] []\n"


AT_A_PORT = "from coursekit.systems import user_socket\nuser_socket.HAS_UNIX = False\n"
"""As on Windows, where a file holds a loopback port and a token."""


def test_programs_meet_at_loopback_ports_where_there_are_no_sockets_of_files(programs):
    assert programs(AT_A_PORT + TALKER, "one").stdout.readline() == "ready\n"
    assert programs(AT_A_PORT + LISTENER, "one").communicate()[0] == "['one'] []\n"


def test_who_does_not_know_the_token_learns_nothing(programs, tmp_path):
    assert programs(AT_A_PORT + TALKER, "one").stdout.readline() == "ready\n"
    [file] = Path(tmp_path, "coursekit").glob("program-83-*")
    port = json.loads(file.read_text(encoding="utf-8"))["port"]
    for said in (b"0" * 32, b"0" * 8):
        with socket.create_connection(("127.0.0.1", port), timeout=30) as stranger:
            stranger.sendall(said)
            assert stranger.recv(1) == b""
    assert programs(AT_A_PORT + LISTENER, "one").communicate()[0] == "['one'] []\n"


def test_a_module_meets_a_program(programs):
    talker(programs, "one")
    assert programs(LISTENER, "one", how=("-m", "program1")).communicate()[0] == "['one'] []\n"


def test_a_ros2_command_sees_a_program_that_was_there_before(programs):
    talker(programs, "one")
    asked = programs("", "node", "list", how=("-m", "coursekit.cli.ros2"))
    assert asked.communicate()[0] == "/one\n"


def test_the_end_of_one_takes_its_nodes_along(programs):
    talker(programs, "one")
    two = talker(programs, "two")
    two.kill()
    two.wait()
    assert programs(LISTENER, "one").communicate()[0] == "['one'] []\n"


@pytest.mark.parametrize("apart", [{"ROS_DOMAIN_ID": "84"}, {"COURSEKIT_ALONE": "1"}, {"PYTEST_XDIST_WORKER": "gw0"}])
def test_other_domains_and_those_that_want_to_be_alone_do_not_meet(programs, apart):
    talker(programs, "one")
    assert programs(LISTENER, **apart).communicate()[0] == "[] []\n"


def test_two_test_runs_do_not_meet(programs):
    talker(programs, "one")
    runs = [programs("import pytest\n" + TALKER, name) for name in ("two", "three")]
    assert [run.stdout.readline() for run in runs] == ["ready\n"] * 2
    test = "import pytest\n" + LISTENER
    assert programs(test, "one").communicate()[0] == "['one'] []\n"
    assert programs(LISTENER, "one", "two", "three").communicate()[0] == "['one', 'three', 'two'] []\n"


def test_nothing_is_left_in_the_runtime_folder(programs, tmp_path):
    programs(LISTENER).communicate()
    assert not [path for path in Path(tmp_path, "coursekit").iterdir() if path.name.startswith(("program", "test"))]


SERVER = """
import rclpy
from std_srvs.srv import Trigger
rclpy.init()
node = rclpy.create_node("server")
node.create_service(Trigger, "ring", lambda request, response: response)
print("ready", flush=True)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""
ASKER = """
import sys, rclpy
from std_srvs.srv import Trigger
rclpy.init()
node = rclpy.create_node("asker")
client = node.create_client(Trigger, "ring")
for line in sys.stdin:
    client.wait_for_service()
    rclpy.spin_until_future_complete(node, client.call_async(Trigger.Request()))
    print("answered", flush=True)
"""


@posix("a signal there cannot be sent to one program of a console")
def test_ctrl_c_ends_a_node_also_when_it_is_about_to_wait(programs):
    """It comes in the moment after an answer: between the last step of the program and its sleep."""
    asker = programs(ASKER)
    for _ in range(16):
        server = programs(SERVER)
        assert server.stdout.readline() == "ready\n"
        asker.stdin.write("\n")
        asker.stdin.flush()
        assert asker.stdout.readline() == "answered\n"
        server.send_signal(signal.SIGINT)
        assert server.communicate(timeout=60)[0] == "interrupted\n"
    asker.stdin.close()


BESIDE = """
import unittest, pytest, launch_testing.markers, launch_testing.tools
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_testing.actions import ReadyToTest

@pytest.mark.launch_test
@launch_testing.markers.keep_alive
def generate_test_description():
    return LaunchDescription([ReadyToTest()])

class TestBeside(unittest.TestCase):
    def test_nodes(self, launch_service, proc_info, proc_output):
        action = ExecuteProcess(cmd=["ros2", "node", "list"], output="screen")
        with launch_testing.tools.launch_process(launch_service, action, proc_info, proc_output) as command:
            assert command.wait_for_shutdown(timeout=20)
        assert command.output == "/one\\n", command.output
"""


def test_a_launch_test_sees_a_program_that_runs_beside_it(programs):
    talker(programs, "one", ROS_DOMAIN_ID="0")
    run = programs(BESIDE, how=("-m", "pytest", "-q", "-p", "no:cacheprovider", "program1.py"), ROS_DOMAIN_ID="")
    assert "1 passed" in run.communicate()[0]


@posix("there is no fork")
def test_a_forked_child_is_a_program_of_its_own(programs):
    talker(programs, "one")
    assert programs(FORKED).communicate()[0] == "['child', 'one', 'parent'] ['parent']\n"


def test_tests_side_by_side_meet_only_the_programs_that_they_start(programs):
    for worker in ("gw0", "gw1"):
        talker(programs, f"of_{worker}", PYTEST_XDIST_WORKER=worker)
    for worker in ("gw0", "gw1"):
        test = programs("import pytest\n" + LISTENER, f"of_{worker}", PYTEST_XDIST_WORKER=worker)
        assert test.communicate()[0] == f"['of_{worker}'] []\n"
