"""`ros2 bag play`, and the verbs that show and change bags."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import rclpy
import yaml
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.storage import Message
from coursekit.bag.writer import BagWriter, WriteSettings
from coursekit.cli.parser import run
from coursekit.core.session import Session
from tests.bag.made import CHATTER, all_of, text_bytes

SECOND = 10**9
START = 1_700_000_000 * SECOND


class Stage:
    """A session on the virtual clock, and what was heard in it."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.heard: list[tuple[str, float]] = []

    def ros2(self, line: str) -> Any:
        """Start a command."""
        return self.session.start(lambda: run(shlex.split(line)), name="ros2")

    def ask(self, line: str) -> str:
        """Carry out a command; its output."""
        process = self.ros2(line)
        process.wait(5)
        return str(process.output)

    def listen(self, topic: str, kind: Any = String, qos: Any = 50, text: Callable[[Any], str] = lambda m: m.data) -> None:
        """Note what comes on a topic, and when."""

        def main() -> None:
            rclpy.init()
            node = rclpy.create_node("ear")

            def note(message: Any) -> None:
                self.heard.append((text(message), (self.session.clock.now() - START) / SECOND))

            node.create_subscription(kind, topic, note, qos)
            try:
                rclpy.spin(node)
            except KeyboardInterrupt:
                pass

        self.session.start(main, name="ear")
        self.session.clock.sleep(0.001)

    def sleep_until(self, seconds: float) -> None:
        """Let the session go to a time."""
        self.session.clock.sleep(seconds - (self.session.clock.now() - START) / SECOND)


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Stage]:
    """A folder with the bag `talk`: Hello 0 ... Hello 5, one a second."""
    monkeypatch.chdir(tmp_path)
    write("talk", 6)
    with Session(virtual=True).use() as session:
        yield Stage(session)


def write(name: str, count: int, topic: TopicMetadata = CHATTER, **settings: Any) -> None:
    """Make a bag."""
    writer = BagWriter(WriteSettings(name, **settings))
    writer.create_topic(topic)
    for number in range(count):
        writer.write(Message(topic.name, text_bytes(f"Hello {number}"), (100 + number) * SECOND))
    writer.close()


def test_it_plays_in_time_and_says_what_humble_says(stage: Stage) -> None:
    stage.listen("/chatter")
    stage.sleep_until(1)
    player = stage.ros2("bag play talk")
    assert player.wait(10) == 0
    assert stage.heard == [(f"Hello {n}", 1.0 + n) for n in range(6)]
    assert [line.split("] ", 2)[2] for line in player.output.splitlines()] == [
        "[rosbag2_storage]: Opened database 'talk/talk_0.db3' for READ_ONLY.",
        "[rosbag2_player]: Set rate to 1",
        "[rosbag2_player]: Adding keyboard callbacks.",
        "[rosbag2_player]: Press SPACE for Pause/Resume",
        "[rosbag2_player]: Press CURSOR_RIGHT for Play Next Message",
        "[rosbag2_player]: Press CURSOR_UP for Increase Rate 10%",
        "[rosbag2_player]: Press CURSOR_DOWN for Decrease Rate 10%",
        "[rosbag2_storage]: Opened database 'talk/talk_0.db3' for READ_ONLY.",
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


def test_keys_pause_step_and_change_the_rate(stage: Stage) -> None:
    stage.listen("/chatter")
    player = stage.ros2("bag play talk -p")
    stage.sleep_until(10)
    assert stage.heard == []
    player.write_stdin("\x1b[C\x1b[Cx\x1b[A\x1b[B")
    stage.sleep_until(11)
    assert [text for text, _ in stage.heard] == ["Hello 0", "Hello 1"]
    player.write_stdin(" ")
    stage.sleep_until(12.5)
    player.write_stdin(" ")
    stage.sleep_until(20)
    assert [text for text, _ in stage.heard] == ["Hello 0", "Hello 1", "Hello 2"]
    player.write_stdin(" ")
    player.wait(10)
    said = [line.split("]: ")[1] for line in player.output.splitlines()]
    assert said[-5:] == ["Set rate to 1.1", "Set rate to 0.99", "Resuming play.", "Pausing play.", "Resuming play."]
    assert stage.heard[2][1] == pytest.approx(11 + 1 / 0.99) and stage.heard[-1][0] == "Hello 5"


def call(stage: Stage, name: str, kind: str, values: str = "{}") -> str:
    """Call a service of the player; the response as text."""
    return stage.ask(f"service call /rosbag2_player/{name} rosbag2_interfaces/srv/{kind} '{values}'").split("response:\n")[1]


def test_services_control_it(stage: Stage) -> None:
    stage.listen("/chatter")
    player = stage.ros2("bag play talk")
    stage.sleep_until(1.5)
    call(stage, "pause", "Pause")
    assert "paused=True" in call(stage, "is_paused", "IsPaused")
    assert "success=True" in call(stage, "play_next", "PlayNext")
    assert "actually_burst=2" in call(stage, "burst", "Burst", "{num_messages: 2}")
    assert [text for text, _ in stage.heard] == [f"Hello {n}" for n in range(5)]
    assert "success=True" in call(stage, "seek", "Seek", "{time: {sec: 103}}")
    assert "success=True" in call(stage, "set_rate", "SetRate", "{rate: 4.0}")
    assert "success=False" in call(stage, "set_rate", "SetRate", "{rate: -1.0}")
    assert "rate=4.0" in call(stage, "get_rate", "GetRate")
    stage.heard.clear()
    call(stage, "toggle_paused", "TogglePaused")
    assert player.wait(5) == 0
    assert [text for text, _ in stage.heard] == ["Hello 3", "Hello 4", "Hello 5"]
    assert stage.heard[2][1] - stage.heard[0][1] == pytest.approx(0.5)
    assert "Failed to set rate to invalid value -1" in player.output and "Burst 2 messages." in player.output


def test_only_a_paused_player_steps(stage: Stage) -> None:
    player = stage.ros2("bag play talk")
    stage.sleep_until(0.5)
    assert "success=False" in call(stage, "play_next", "PlayNext")
    assert "actually_burst=0" in call(stage, "burst", "Burst")
    call(stage, "pause", "Pause")
    assert "actually_burst=5" in call(stage, "burst", "Burst")
    assert player.wait(1) == 0  # nothing is left
    assert "Called play next, but not in paused state." in player.output


def test_seeking_before_the_beginning_begins_anew(stage: Stage) -> None:
    stage.listen("/chatter")
    stage.ros2("bag play talk")
    stage.sleep_until(2.5)
    assert "success=True" in call(stage, "seek", "Seek", "{time: {sec: 3}}")
    stage.sleep_until(3)
    assert [text for text, _ in stage.heard] == ["Hello 0", "Hello 1", "Hello 2", "Hello 0"]


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
    Path("qos.yaml").write_text("/chatter: {durability: transient_local, depth: 2, history: keep_last}")
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


@pytest.mark.parametrize(
    ("line", "code", "text"),
    [
        ("play nowhere", 2, "argument bag_path: Bag path 'nowhere' does not exist!"),
        ("play talk -r 0", 2, "argument -r/--rate: 0 is not in the valid range (> 0.0)"),
        ("play talk -r x", 2, "x is not the valid type (float)"),
        ("play talk --clock -5", 2, "-5 is not in the valid range (> 0.0)"),
        ("play talk -d -1", 2, "Value -1 is less than zero."),
        ("play talk --wait-for-all-acked -1", 2, "Value -1 is less than zero."),
        ("play empty", 1, "[ERROR] [ros2bag]: there is no metadata.yaml in 'empty'."),
        ("info empty", 1, "'ros2 bag reindex empty' makes one from its files"),
        ("reindex talk/metadata.yaml", 1, "[ERROR] [ros2bag]: Must specify a bag directory"),
        ("reindex empty", 1, "No storage files found for reindexing. Abort"),
        ("convert -i talk -o nowhere.yaml", 1, "'nowhere.yaml' cannot be read: "),
        ("convert -i a b c -o nowhere.yaml", 1, "--input expects 1 or 2 arguments, 3 provided"),
        ("list birds", 2, "argument plugin_type: invalid choice: 'birds'"),
    ],
)
def test_what_cannot_be_is_refused(stage: Stage, line: str, code: int, text: str) -> None:
    Path("empty").mkdir()
    process = stage.ros2(f"bag {line}")
    assert process.wait(5) == code and text in process.output and "Traceback" not in process.output


def test_a_bag_is_shown_in_humbles_layout(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    import time

    monkeypatch.setenv("TZ", "UTC")
    time.tzset()
    write("long", 7, max_file_seconds=3, storage_id="sqlite3")
    size = sum(one.stat().st_size for one in Path("long").iterdir()) / 1024
    assert stage.ask("bag info long") == (
        "\n"
        "Files:             long_0.db3\n"
        "                   long_1.db3\n"
        f"Bag size:          {size:.1f} KiB\n"
        "Storage id:        sqlite3\n"
        "Duration:          6.000000000s\n"
        "Start:             Jan  1 1970 00:01:40.000000000 (100.000000000)\n"
        "End:               Jan  1 1970 00:01:46.000000000 (106.000000000)\n"
        "Messages:          7\n"
        "Topic information: Topic: /chatter | Type: std_msgs/msg/String | Count: 7 | Serialization Format: cdr\n"
        "\n"
    )


def test_metadata_is_made_anew_and_bags_are_converted(stage: Stage) -> None:
    before = Path("talk/metadata.yaml").read_text()
    Path("talk/metadata.yaml").unlink()
    said = stage.ask("bag reindex talk")
    assert "[rosbag2_cpp]: Beginning reindexing bag in directory: talk" in said and "Reindexing complete." in said
    assert Path("talk/metadata.yaml").read_text() == before
    Path("out.yaml").write_text("output_bags: [{uri: new, storage_id: mcap, all: true}]")
    stage.ask("bag convert -i talk sqlite3 -o out.yaml")
    assert all_of("new") == all_of("talk") and Path("new/new_0.mcap").exists()


def test_plugins_are_listed(stage: Stage) -> None:
    assert stage.ask("bag list storage") == "mcap\nsqlite3\n"
    assert stage.ask("bag list compressor") == stage.ask("bag list decompressor") == "zstd\n"
    assert "name: sqlite3\n\trosbag2 storage plugin for sqlite3 files\n\ttype: " in stage.ask("bag list storage --verbose")


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
        for one in Path("again").iterdir():
            one.unlink()
        Path("again").rmdir()
    assert outputs[0] == outputs[1]


def test_a_bag_that_breaks_off_is_played_so_far_and_told(stage: Stage) -> None:
    write("long", 4000)
    file = Path("long/long_0.db3")
    file.write_bytes(file.read_bytes()[:60_000])
    player = stage.ros2("bag play long -r 1e6")
    assert player.wait(5) == 1 and "Traceback" not in player.output
    assert "[ERROR] [ros2bag]: 'long/long_0.db3' cannot be read as a sqlite3 file of a bag: " in player.output
