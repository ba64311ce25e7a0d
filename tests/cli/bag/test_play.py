"""`ros2 bag play`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.storage import Message
from coursekit.bag.writer import BagWriter, WriteSettings
from coursekit.processes.session import Session
from tests.bag.made import CHATTER, all_of, text_bytes
from tests.cli.bag.stage import SECOND, Stage, write


def test_it_plays_in_time_and_says_what_humble_says(stage: Stage) -> None:
    stage.listen("/chatter")
    stage.sleep_until(1)
    player = stage.ros2("bag play talk")
    assert player.wait(10) == 0
    assert stage.heard == [(f"Hello {n}", 1.0 + n) for n in range(6)]
    assert [line.split("] ", 2)[2] for line in player.output.splitlines()] == [
        f"[rosbag2_storage]: Opened database '{Path('talk', 'talk_0.db3')}' for READ_ONLY.",
        "[rosbag2_player]: Set rate to 1",
        "[rosbag2_player]: Adding keyboard callbacks.",
        "[rosbag2_player]: Press SPACE for Pause/Resume",
        "[rosbag2_player]: Press CURSOR_RIGHT for Play Next Message",
        "[rosbag2_player]: Press CURSOR_UP for Increase Rate 10%",
        "[rosbag2_player]: Press CURSOR_DOWN for Decrease Rate 10%",
        f"[rosbag2_storage]: Opened database '{Path('talk', 'talk_0.db3')}' for READ_ONLY.",
    ]


@pytest.mark.parametrize(
    ("flags", "times"),
    [
        ("-r 2", [0, 0.5, 1, 1.5, 2, 2.5]),
        ("-r 0.5", [0, 2, 4, 6, 8, 10]),
        ("-r 3", [0, 1 / 3, 2 / 3, 1, 4 / 3, 5 / 3]),
        ("-d 1.5", [1.5, 2.5, 3.5, 4.5, 5.5, 6.5]),
        ("--start-offset 3.25", [None, None, None, None, 0.75, 1.75]),
        ("--topics /chatter /other --wait-for-all-acked 100 --disable-keyboard-controls", [0, 1, 2, 3, 4, 5]),
        ("--topics /other", [None] * 6),
    ],
)
def test_the_flags_of_time_and_choice(stage: Stage, flags: str, times: list[float | None]) -> None:
    stage.listen("/chatter")
    stage.sleep_until(1)
    assert stage.ros2(f"bag play talk {flags}").wait(20) == 0
    expected = [(f"Hello {n}", 1 + time) for n, time in enumerate(times) if time is not None]
    assert [text for text, _ in stage.heard] == [text for text, _ in expected]
    assert [time for _, time in stage.heard] == pytest.approx([time for _, time in expected], abs=2e-9)


def test_a_loop_goes_on_until_ctrl_c(stage: Stage) -> None:
    stage.listen("/elsewhere")
    player = stage.ros2("bag play talk --loop -m /chatter:=/elsewhere -r 5")
    stage.sleep_until(2.5)
    assert player.exit_code is None
    player.interrupt()
    assert player.wait(1) == 0
    assert [text for text, _ in stage.heard][:8] == [f"Hello {n}" for n in (0, 1, 2, 3, 4, 5, 0, 1)]


def test_the_clock_is_the_recordings(stage: Stage) -> None:
    from rosgraph_msgs.msg import Clock

    stage.listen("/clock", Clock, text=lambda m: f"{m.clock.sec}.{m.clock.nanosec:09d}")
    stage.ros2("bag play talk --clock 2 -r 4").wait(10)
    assert stage.heard == [("102.000000000", 0.501), ("104.000000000", 1.001)]
    stage.heard.clear()
    stage.ros2("bag play talk --clock").wait(10)
    assert len(stage.heard) in (199, 200)


def offered(**policies: Any) -> str:
    """What a publisher's QoS is in a bag."""
    values = {"history": 3, "depth": 0, "reliability": 1, "durability": 2, "liveliness": 1, **policies}
    return yaml.safe_dump([values])


@pytest.mark.parametrize(
    ("recorded", "durability", "reliability"),
    [
        ("", DurabilityPolicy.VOLATILE, ReliabilityPolicy.RELIABLE),
        ("~", DurabilityPolicy.VOLATILE, ReliabilityPolicy.RELIABLE),
        (offered(durability=1), DurabilityPolicy.TRANSIENT_LOCAL, ReliabilityPolicy.RELIABLE),
        (offered(reliability="best_effort"), DurabilityPolicy.VOLATILE, ReliabilityPolicy.BEST_EFFORT),
        (offered(reliability=[77], durability="?"), DurabilityPolicy.VOLATILE, ReliabilityPolicy.RELIABLE),
        (offered(durability=1) + offered(), DurabilityPolicy.VOLATILE, ReliabilityPolicy.RELIABLE),
    ],
)
def test_it_offers_what_was_recorded(
    stage: Stage, recorded: str, durability: DurabilityPolicy, reliability: ReliabilityPolicy
) -> None:
    write("map", 3, TopicMetadata("/map", "std_msgs/msg/String", offered_qos_profiles=recorded))
    player = stage.ros2("bag play map")
    stage.sleep_until(0.5)
    text = stage.ask("topic info -v /map")
    assert f"Durability: {durability.name}" in text and f"Reliability: {reliability.name}" in text
    assert ("Not all original publishers on topic /map offered the same QoS profiles" in player.output) == (
        recorded.count("history") == 2
    )


def test_qos_can_be_overridden(stage: Stage) -> None:
    Path("qos.yaml").write_text("/chatter: {durability: transient_local, depth: 2, history: keep_last}", encoding="utf-8")
    player = stage.ros2("bag play talk --qos-profile-overrides-path qos.yaml")
    stage.sleep_until(4.5)
    stage.listen("/chatter", qos=QoSProfile(depth=9, durability=DurabilityPolicy.TRANSIENT_LOCAL))
    player.wait(5)
    assert [text for text, _ in stage.heard] == ["Hello 3", "Hello 4", "Hello 5"]
    assert "Overriding QoS profile for topic /chatter" in player.output


def test_a_topic_of_an_unknown_type_is_passed_over(stage: Stage) -> None:
    writer = BagWriter(WriteSettings("odd"))
    topics = [TopicMetadata("/x", "nowhere_msgs/msg/Bird"), TopicMetadata("/y", "std_msgs/msg/Bird"), CHATTER]
    for topic in topics:
        writer.create_topic(topic)
        writer.write(Message(topic.name, text_bytes("Hello"), SECOND))
    writer.close()
    stage.listen("/chatter")
    player = stage.ros2("bag play odd")
    assert player.wait(5) == 0 and [text for text, _ in stage.heard] == ["Hello"]
    assert "[rosbag2_player]: Ignoring a topic '/x', reason: package 'nowhere_msgs' not found, searching: [" in player.output
    assert "[rosbag2_player]: Ignoring a topic '/y', reason: " in player.output


def test_bytes_that_are_no_message_are_told_once_and_passed_over(stage: Stage) -> None:
    writer = BagWriter(WriteSettings("odd"))
    writer.create_topic(CHATTER)
    for number, data in enumerate([b"", b"\0\1\0\0\xff\xff\xff\xff", text_bytes("Hello")]):
        writer.write(Message("/chatter", data, number))
    writer.close()
    stage.listen("/chatter")
    player = stage.ros2("bag play odd")
    assert player.wait(5) == 0 and [text for text, _ in stage.heard] == ["Hello"]
    assert player.output.count("A message of topic '/chatter' cannot be published: ") == 1


def test_two_runs_are_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    write("talk", 6)
    outputs = []
    for _ in range(2):
        with Session(virtual=True).use() as session:
            stage = Stage(session)
            recorder = stage.ros2("bag record -a -o again")
            stage.ros2("bag play talk -r 1.7").wait(10)
            recorder.interrupt()
            recorder.wait(1)
            outputs.append((recorder.output, all_of("again"), Path("again/again_0.db3").stat().st_size))
        for path in Path("again").iterdir():
            path.unlink()
        Path("again").rmdir()
    assert outputs[0] == outputs[1]


def test_a_bag_that_breaks_off_is_played_so_far_and_told(stage: Stage) -> None:
    write("long", 4000)
    file = Path("long/long_0.db3")
    file.write_bytes(file.read_bytes()[:60_000])
    player = stage.ros2("bag play long -r 1e6")
    assert player.wait(5) == 1 and "Traceback" not in player.output
    assert f"[ERROR] [ros2bag]: '{file}' cannot be read as a sqlite3 file of a bag: " in player.output
