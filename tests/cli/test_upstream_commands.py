"""Commands of ros2cli's own tests: hidden names, interfaces that are not there, folders that are not there."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
import rclpy
from rclpy.lifecycle import LifecycleNode
from std_msgs.msg import String
from std_srvs.srv import Empty

from coursekit.cli.parser import run
from coursekit.processes.session import Session

Command = Callable[[str], tuple[int, str]]


def hidden_nodes() -> None:
    rclpy.init()
    nodes = LifecycleNode("_hidden"), LifecycleNode("seen")
    nodes[0].create_publisher(String, "_whisper", 1)
    nodes[0].create_service(Empty, "_secret", lambda request, response: response)
    executor = rclpy.executors.SingleThreadedExecutor()
    for node in nodes:
        executor.add_node(node)
    try:
        executor.spin()
    except KeyboardInterrupt:
        pass


@pytest.fixture
def ros2() -> Iterator[Command]:
    with Session(virtual=True).use() as session:
        session.start(hidden_nodes, name="hidden_nodes")
        session.clock.sleep(0.5)

        def carry_out(line: str) -> tuple[int, str]:
            process = session.start(lambda: run(shlex.split(line)), name="ros2")
            return process.wait(10), process.output.strip()

        yield carry_out


@pytest.mark.parametrize(
    ("line", "flag", "unseen", "seen"),
    [
        ("topic {} type /_whisper", "--include-hidden-topics", "", "std_msgs/msg/String"),
        ("service {} type /_secret", "--include-hidden-services", "", "std_srvs/srv/Empty"),
        ("lifecycle get {} /_hidden", "--include-hidden-nodes", "Node not found", "unconfigured [1]"),
        ("lifecycle set {} /_hidden configure", "--include-hidden-nodes", "Node not found", "Transitioning successful"),
        ("lifecycle list {} _hidden", "--include-hidden-nodes", "Node not found", "- configure [1]"),
        ("node info /_hidden {}", "--include-hidden", "Unable to find node '/_hidden'", "/_hidden\n  Subscribers:"),
    ],
)
def test_hidden_names_are_found_only_on_request(ros2: Command, line: str, flag: str, unseen: str, seen: str) -> None:
    assert ros2(line.format("")) == (1, unseen)
    code, text = ros2(line.format(flag))
    assert code == 0 and text.startswith(seen)


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ("lifecycle nodes", "/seen"),
        ("lifecycle nodes -a", "/_hidden\n/seen"),
        ("lifecycle nodes -c", "1"),
        ("lifecycle nodes --all --count-nodes", "2"),
    ],
)
def test_lifecycle_nodes_are_listed_and_counted(ros2: Command, line: str, text: str) -> None:
    assert ros2(line) == (0, text)


def test_an_interface_that_is_not_there_is_told_by_what_is_missing(ros2: Command) -> None:
    assert ros2("interface show nope/msg/String") == (1, "Unknown package 'nope'")
    code, text = ros2("interface show std_msgs/msg/Nope")
    assert code == 1 and text.startswith("Could not find the interface '") and text.endswith("std_msgs/msg/Nope.idl'")


def test_a_dump_into_no_folder_is_refused(ros2: Command, tmp_path: Path) -> None:
    assert ros2("param dump /seen --output-dir nowhere") == (1, "'nowhere' is not a valid directory.")
    assert ros2(f"param dump /seen --output-dir {tmp_path}")[0] == 0 and (tmp_path / "seen.yaml").is_file()


def test_a_report_of_failures_is_asked_for(ros2: Command) -> None:
    code, text = ros2("doctor --report-failed")
    assert code == 0 and ("PLATFORM INFORMATION" in text) == ("check(s) failed" in text)


def test_a_message_for_nobody_waits_until_it_is_told_to_end() -> None:
    with Session(virtual=True).use() as session:
        process = session.start(lambda: run(shlex.split("topic pub --once /nobody std_msgs/msg/String")), name="ros2")
        session.clock.sleep(2.5)
        assert process.output == 3 * "Waiting for at least 1 matching subscription(s)...\n"
        process.terminate()
        assert process.wait(10) == 1
        assert process.output == 3 * "Waiting for at least 1 matching subscription(s)...\n"


def test_security_says_why_there_is_nothing_to_encrypt(ros2: Command) -> None:
    code, text = ros2("security create_enclave demo_keystore /talker_listener/talker")
    assert code == 1 and "no message leaves the computer" in text and "sros2" in text
    assert ros2("security create_keystore demo_keystore") == (code, text)
