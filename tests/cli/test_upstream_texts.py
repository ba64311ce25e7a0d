"""What ros2cli's own tests expect of texts and exit codes."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
import rclpy
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

from coursekit.cli.parser import run
from coursekit.processes.session import Session

Command = Callable[..., tuple[int, str]]


def program() -> None:
    rclpy.init()
    nodes = [rclpy.create_node(name) for name in ("twin", "twin", "one")]
    nodes[0].declare_parameter("speed", 1.0)
    nodes[2].declare_parameter("speed", 1.0)
    publisher = nodes[2].create_publisher(String, "words", 10)
    nodes[2].create_timer(0.1, lambda: publisher.publish(String(data="hello")))
    nodes[2].create_publisher(String, "lost", QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT))
    executor = rclpy.executors.SingleThreadedExecutor()
    for node in nodes:
        executor.add_node(node)
    try:
        executor.spin()
    except KeyboardInterrupt:
        pass


@pytest.fixture
def session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Session]:
    monkeypatch.chdir(tmp_path)
    with Session(virtual=True).use() as virtual_session:
        virtual_session.start(program, name="program")
        virtual_session.clock.sleep(0.5)
        yield virtual_session


@pytest.fixture
def ros2(session: Session) -> Command:
    def carry_out(line: str, *words: str) -> tuple[int, str]:
        process = session.start(lambda: run([*shlex.split(line), *words]), name="ros2")
        return process.wait(10), process.output

    return carry_out


def test_nodes_of_one_name_are_told_with_the_name_in_double_quotes(ros2: Command) -> None:
    code, text = ros2("node info /twin")
    assert code == 0
    assert text.startswith(
        'There are 2 nodes in the graph with the exact name "/twin". You are seeing information about only one of them.\n'
    )


def test_raw_messages_come_in_whole_words(ros2: Command) -> None:
    code, text = ros2("topic echo --once --raw /words std_msgs/msg/String")
    assert (code, text) == (0, r"b'\x00\x01\x00\x00\x06\x00\x00\x00hello\x00\x00\x00'" + "\n---\n")


def test_where_parameters_are_saved_is_said_as_in_ros(ros2: Command, tmp_path: Path) -> None:
    assert ros2("param dump /one --output-dir", str(tmp_path)) == (0, f"Saving to:  {tmp_path / 'one.yaml'}\n")


@pytest.mark.parametrize(
    ("names", "flags", "text"),
    [
        ("/one", "", "Set parameter speed successful\n"),
        ("/**", "", "Set parameter speed successful\n"),
        ("one", "", "Param file does not contain parameters for /one,  only for nodes: ['one']\n"),
        (
            "/**",
            "--no-use-wildcard",
            "Param file does not contain parameters for /one,  only for nodes: ['/**']\n",
        ),
    ],
)
def test_a_file_is_loaded_by_the_full_name_of_a_node(
    ros2: Command, tmp_path: Path, names: str, flags: str, text: str
) -> None:
    (tmp_path / "file.yaml").write_text(f"{names}:\n  ros__parameters:\n    speed: 2.0\n")
    code, said = ros2("param load /one", str(tmp_path / "file.yaml"), *flags.split())
    assert (code, said) == (0 if "successful" in text else 1, text)


def test_all_comments_keep_the_empty_lines_between_them(ros2: Command, tmp_path: Path, monkeypatch) -> None:
    folder = tmp_path / "share" / "nested" / "msg"
    folder.mkdir(parents=True)
    index = tmp_path / "share" / "ament_index" / "resource_index"
    for kind, text in (("packages", ""), ("rosidl_interfaces", "msg/Inner.msg\nmsg/Outer.msg\n")):
        (index / kind).mkdir(parents=True)
        (index / kind / "nested").write_text(text)
    (folder / "Inner.msg").write_text("# one\nbool a\n\n# two\nbool b # three\n")
    (folder / "Outer.msg").write_text("Inner inner\n")
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    shown = ros2("interface show nested/msg/Outer --all-comments")
    assert shown == (0, "Inner inner\n\t# one\n\tbool a\n\n\t# two\n\tbool b # three\n")
    assert ros2("interface show nested/msg/Outer") == (0, "Inner inner\n\tbool a\n\tbool b\n")


def test_the_doctor_names_what_failed_and_does_not_fail_itself(ros2: Command, session: Session) -> None:
    code, text = ros2("doctor")
    assert code == 0 and "Failed modules: middleware" not in text

    def listen() -> None:
        rclpy.init()
        node = rclpy.create_node("listener")
        node.create_subscription(String, "lost", print, 10)
        rclpy.spin(node)

    session.start(listen, name="listener")
    session.clock.sleep(0.1)
    code, text = ros2("doctor")
    assert code == 0
    assert "on topic '/lost': Best effort publisher and reliable subscription;" in text
    assert text.splitlines()[-1].startswith("Failed modules: ") and "middleware" in text.splitlines()[-1]
    assert "compatibility status    : ERROR: Best effort publisher and reliable subscription;\n" in ros2("doctor -r")[1]


@pytest.mark.parametrize("package", ["ros2cli", "ros2launch", "ros2pkg", "launch_testing", "launch_pytest"])
def test_the_command_s_own_packages_are_found(ros2: Command, package: str) -> None:
    assert package in ros2("pkg list")[1].split()
    assert f"<name>{package}</name>" in ros2(f"pkg xml {package}")[1]
