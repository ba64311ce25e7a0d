"""Whole interpreters that join by the environment: they meet there, and end by themselves whatever the network does."""

import os
import subprocess
import sys

from coursekit.net.joining import link_of
from tests.needs import posix

from .sides import LIMIT, free_port

PROGRAM = """
import sys, rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node(sys.argv[1])
publisher = node.create_publisher(String, "chatter", 10)
heard = lambda message: print("heard", message.data, flush=True) if message.data != sys.argv[1] else None
subscription = node.create_subscription(String, "chatter", heard, 10)
timer = node.create_timer(0.02, lambda: publisher.publish(String(data=sys.argv[1])))
print("ready", flush=True)
if "leave" in sys.argv:
    rclpy.spin_once(node)
else:
    rclpy.spin(node)
"""


def program(address, *words, **environ):
    env = dict(os.environ, COURSEKIT_NETWORK=address, COURSEKIT_ALONE="1", **environ)
    command = [sys.executable, "-c", PROGRAM, *words]
    return subprocess.Popen(command, env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def until_line(child, wanted):
    for line in child.stdout:
        if line.strip() == wanted:
            return
    raise AssertionError(f"{wanted!r} was not said: {child.stderr.read()}")


def test_programs_join_by_the_environment_and_one_that_is_killed_is_gone_at_once(side):
    watch = side()
    children = [program(side.address, "one"), program(side.address, "two")]
    try:
        until_line(children[0], "heard two")
        until_line(children[1], "heard one")
        watch.until(lambda: watch.names() == ["/one", "/two"])
        children[0].kill()
        watch.until(lambda: watch.names() == ["/two"])
    finally:
        for child in children:
            child.kill()
            child.communicate()


COUNTING = """
import sys, rclpy
from std_msgs.msg import Int32
rclpy.init()
node = rclpy.create_node(sys.argv[1])
if sys.argv[1] == "counter":
    numbers, publisher = iter(range(10**9)), node.create_publisher(Int32, "count", 100)
    timer = node.create_timer(0.01, lambda: publisher.publish(Int32(data=next(numbers))))
else:
    subscription = node.create_subscription(Int32, "count", lambda message: print(message.data, flush=True), 100)
rclpy.spin(node)
"""


def test_programs_of_one_computer_that_both_join_hear_nothing_twice(side, tmp_path):
    env = dict(os.environ, COURSEKIT_NETWORK=side.address, COURSEKIT_RUNTIME_DIR=str(tmp_path))
    children = [
        subprocess.Popen([sys.executable, "-c", COUNTING, name], env=env, stdout=subprocess.PIPE, text=True)
        for name in ("counter", "listener")
    ]
    try:
        heard = [int(children[1].stdout.readline()) for _ in range(50)]
        assert heard == list(range(heard[0], heard[0] + 50))
    finally:
        for child in children:
            child.kill()
            child.communicate()


def test_tests_join_nothing_by_the_environment(side, session, monkeypatch):
    monkeypatch.setenv("COURSEKIT_NETWORK", side.address)
    session.meet(0)
    assert link_of(session, 0) is None


def test_a_program_ends_by_itself_though_messages_come_in(side):
    loud = program(side.address, "loud")
    try:
        until_line(loud, "ready")
        quiet = program(side.address, "quiet", "leave")
        assert quiet.wait(LIMIT) == 0, quiet.communicate()
        assert "Traceback" not in quiet.communicate()[1]
    finally:
        loud.kill()
        loud.communicate()


@posix("no signal stops a program for a while")
def test_a_program_ends_by_itself_though_its_router_is_frozen(side, tmp_path):
    import signal

    from coursekit.systems.children import send_signal

    port = free_port()
    router = subprocess.Popen(
        [sys.executable, "-m", "coursekit.cli.coursekit", "network", "serve", "--listen", f"tcp/127.0.0.1:{port}"],
        stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    try:
        assert f"%network tcp/127.0.0.1:{port}" in router.stdout.readline()
        child = program(f"127.0.0.1:{port}", "one")
        until_line(child, "ready")
        send_signal(router, signal.SIGSTOP)
        child.send_signal(signal.SIGINT)
        child.communicate(timeout=LIMIT)
    finally:
        router.kill()
        router.communicate()


def test_a_program_whose_network_is_not_there_says_so_and_runs(side):
    child = program(f"127.0.0.1:{free_port()}", "alone", "leave")
    said = child.communicate(timeout=LIMIT)
    assert child.returncode == 0 and "ready" in said[0] and "Nobody listens" in said[1]


def test_a_program_of_a_session_ends_by_itself_though_it_was_the_first_that_joined(side, tmp_path):
    watch = side()
    env = dict(os.environ, COURSEKIT_NETWORK=side.address, COURSEKIT_STOP_AFTER="6", COURSEKIT_RUNTIME_DIR=str(tmp_path))
    command = [sys.executable, "-m", "coursekit.cli.ros2", "run", "demo_nodes_py", "talker"]
    child = subprocess.Popen(command, env=env, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        watch.until(lambda: "/talker" in watch.names())
        assert "Publishing" in child.communicate(timeout=LIMIT)[0]
    finally:
        child.kill()
        child.communicate()
