"""Recorder and player as a program uses them, beside rclpy of its own."""

from __future__ import annotations

import datetime
import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import rclpy
import rosbag2_py
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rosbag2_py._qos import offer_for, offers_text, parse_offers, request_for
from std_msgs.msg import String

from coursekit.bag.errors import BagError
from coursekit.processes import script
from coursekit.processes.session import Session


@pytest.fixture
def session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Session]:
    """A session on the virtual clock, in a folder of its own."""
    monkeypatch.chdir(tmp_path)
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session


def all_topics() -> rosbag2_py.RecordOptions:
    """Options of a recording of everything."""
    options = rosbag2_py.RecordOptions()
    options.all = True
    options.topic_polling_interval = datetime.timedelta(milliseconds=50)
    return options


def test_a_recorder_in_a_thread_is_ended_by_cancel_and_leaves_the_programs_rclpy_alone(session: Session) -> None:
    import time

    def main() -> None:
        rclpy.init()
        out = rclpy.create_node("speaker").create_publisher(String, "chatter", 10)
        recorder = rosbag2_py.Recorder()
        options = rosbag2_py.StorageOptions("bag", "sqlite3")
        thread = threading.Thread(target=recorder.record, args=(options, all_topics()), daemon=True)
        thread.start()
        for _ in range(4):
            time.sleep(0.2)
            out.publish(String(data="hi"))
        time.sleep(0.1)
        rosbag2_py.Recorder.cancel()
        thread.join()
        del recorder
        print("rclpy goes on:", rclpy.ok())

    program = session.start(main, name="program")
    other = session.start(lambda: rosbag2_py.Recorder().record(rosbag2_py.StorageOptions("other"), all_topics()), name="o")
    assert program.wait(5) == 0 and "rclpy goes on: True\n" in program.output
    assert other.exit_code is None  # only the recordings of the program itself end
    other.interrupt()
    assert other.wait(1) == 0
    facts = rosbag2_py.Info().read_metadata("bag", "")
    assert {topic.topic_metadata.name: topic.message_count for topic in facts.topics_with_message_count}["/chatter"] == 4


def test_a_player_plays_where_it_is_called(session: Session) -> None:
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions("bag"), rosbag2_py.ConverterOptions())
    writer.create_topic(rosbag2_py.TopicMetadata("/a", "std_msgs/msg/String", "cdr"))
    for stamp in (0, 2_500_000_000):
        writer.write("/a", rclpy.serialization.serialize_message(String()), stamp)
    writer.close()

    def main() -> float:
        options = rosbag2_py.PlayOptions()
        options.rate, options.delay = 2.0, 0.5
        rosbag2_py.Player("info").play(rosbag2_py.StorageOptions("bag"), options)
        return None  # type: ignore[return-value]

    began = session.clock.steady()
    program = session.start(main, name="program")
    assert program.wait(5) == 0 and session.clock.steady() - began == 1_750_000_000


def test_a_level_that_is_none_is_refused() -> None:
    for kind in (rosbag2_py.Player, rosbag2_py.Recorder):
        with pytest.raises(RuntimeError, match="nope"):
            kind("nope")


PROFILES = [
    QoSProfile(depth=10),
    QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, deadline=Duration(seconds=1.5)),
    QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, lifespan=Duration(nanoseconds=7)),
]


def test_what_publishers_offer_goes_into_a_bag_and_comes_back() -> None:
    back = parse_offers(offers_text(PROFILES))
    for before, after in zip(PROFILES, back, strict=True):
        for name in ("reliability", "durability", "deadline", "lifespan", "liveliness"):
            assert getattr(before, name) == getattr(after, name)
    assert offers_text([]) == "" and parse_offers("") == []
    beginning = "- history: 3\n  depth: 0\n  reliability: 1\n  durability: 2\n  deadline:\n    sec: "
    assert offers_text(PROFILES[:1]).startswith(beginning)


@pytest.mark.parametrize("text", ["7", "a: b", "- 1", "[", "- &a [*a]"])
def test_offers_that_are_none_are_refused(text: str) -> None:
    with pytest.raises(BagError, match="offered_qos_profiles"):
        parse_offers(text)


def test_a_recorder_asks_for_the_most_that_all_publishers_offer() -> None:
    said: list[str] = []
    plain, latched, lossy = PROFILES
    assert request_for("/a", [latched, latched], said.append).durability == DurabilityPolicy.TRANSIENT_LOCAL
    assert request_for("/a", [plain, plain], said.append).reliability == ReliabilityPolicy.RELIABLE
    assert request_for("/a", [], said.append).reliability == ReliabilityPolicy.RELIABLE
    assert request_for("/a", [lossy], said.append).reliability == ReliabilityPolicy.BEST_EFFORT
    assert not said
    mixed: Any = request_for("/a", PROFILES, said.append)
    assert (mixed.reliability, mixed.durability) == (ReliabilityPolicy.BEST_EFFORT, DurabilityPolicy.VOLATILE)
    assert len(said) == 2


def test_a_player_offers_what_the_publishers_agreed_on() -> None:
    said: list[str] = []
    latched = PROFILES[1]
    assert offer_for("/a", [latched, latched], said.append).durability == DurabilityPolicy.TRANSIENT_LOCAL and not said
    assert offer_for("/a", PROFILES, said.append).durability == DurabilityPolicy.VOLATILE and len(said) == 1


def test_a_program_that_only_plays_is_one_of_ros_for_a_launch_file(tmp_path: Path) -> None:
    (tmp_path / "play.py").write_text("import rosbag2_py\nrosbag2_py.Player()\n")
    assert script.of_command(["python3", "play.py"], str(tmp_path)) == (tmp_path / "play.py", [])


@pytest.mark.slow
def test_a_program_that_only_plays_joins_the_session_that_runs(tmp_path: Path) -> None:
    kept = {name: value for name, value in os.environ.items() if not name.startswith("COURSEKIT_")}
    env = {**kept, "COURSEKIT_RUNTIME_DIR": str(tmp_path), "ROS_DOMAIN_ID": "79", "PYTHONUNBUFFERED": "1"}
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(tmp_path / "bag")), rosbag2_py.ConverterOptions())
    writer.create_topic(rosbag2_py.TopicMetadata("/a", "std_msgs/msg/String", "cdr"))
    writer.write("/a", rclpy.serialization.serialize_message(String(data="from a bag")), 0)
    writer.close()
    (tmp_path / "play.py").write_text(
        "import rosbag2_py\n"
        "rosbag2_py.Player().play(rosbag2_py.StorageOptions('bag'), rosbag2_py.PlayOptions())\n"
    )
    echo = [sys.executable, "-m", "coursekit.cli.ros2", "topic", "echo", "/a", "std_msgs/msg/String", "--once"]
    with subprocess.Popen(echo, env=env, stdout=subprocess.PIPE, encoding="utf-8") as ear:
        for _ in range(100):  # until it listens
            played = subprocess.run([sys.executable, "play.py"], cwd=tmp_path, env=env, capture_output=True, timeout=60)
            assert played.returncode == 0, played.stderr
            if ear.poll() is not None:
                break
        assert ear.communicate(timeout=30)[0] == "data: from a bag\n---\n"


@pytest.mark.parametrize("wait", [0.0, 0.5])
def test_a_cancel_is_heard_also_before_the_recording_has_begun(session: Session, tmp_path: Path, wait: float) -> None:
    import time

    def main() -> None:
        rclpy.init()
        recorder = rosbag2_py.Recorder()
        options = rosbag2_py.StorageOptions("bag", "sqlite3")
        thread = threading.Thread(target=recorder.record, args=(options, all_topics()), daemon=True)
        thread.start()
        time.sleep(wait)
        recorder.cancel()
        thread.join()

    assert session.start(main, name="main").wait(5.0) == 0
    assert {path.name for path in (tmp_path / "bag").iterdir()} == {"metadata.yaml", "bag_0.db3"}


def test_a_player_is_cancelled(session: Session, tmp_path: Path) -> None:
    def main() -> None:
        recorder = rosbag2_py.Recorder()
        recorder.cancel()
        recorder.record(rosbag2_py.StorageOptions("bag", "sqlite3"), all_topics())
        player, options = rosbag2_py.Player(), rosbag2_py.PlayOptions()
        options.loop = options.start_paused = True
        thread = threading.Thread(target=player.play, args=(rosbag2_py.StorageOptions("bag"), options), daemon=True)
        thread.start()
        player.cancel()
        thread.join()

    assert session.start(main, name="main").wait(5.0) == 0
