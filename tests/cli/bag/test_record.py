"""`ros2 bag record`, and what is in the bag afterwards."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import rclpy
import yaml
from rosbags.rosbag2 import Reader
from std_msgs.msg import String

from coursekit.processes.executables import find
from coursekit.processes.session import Session
from tests.bag.made import all_of
from tests.cli.bag.stage import START, lines, stop


def test_a_recording_says_what_humble_says(session: Session, ros2: Callable[[str], Any]) -> None:
    session.start_executable(find("demo_nodes_py", "talker"))
    session.clock.sleep(0.5)
    recorder = ros2("bag record /chatter -o talk")
    session.clock.sleep(3)
    stop(session, recorder)
    assert lines(recorder) == [
        "[INFO] [rosbag2_recorder]: Press SPACE for pausing/resuming",
        f"[INFO] [rosbag2_storage]: Opened database '{Path('talk', 'talk_0.db3')}' for READ_WRITE.",
        "[INFO] [rosbag2_recorder]: Listening for topics...",
        "[INFO] [rosbag2_recorder]: Event publisher thread: Starting",
        "[INFO] [rosbag2_recorder]: Subscribed to topic '/chatter'",
        "[INFO] [rosbag2_recorder]: Recording...",
        "[INFO] [rosbag2_recorder]: All requested topics are subscribed. Stopping discovery...",
        "[INFO] [rosbag2_cpp]: Writing remaining messages from cache to the bag. It may take a while",
        "[INFO] [rosbag2_recorder]: Event publisher thread: Exiting",
        "[INFO] [rosbag2_recorder]: Recording stopped",
    ]
    assert [message.stamp - START for message in all_of("talk")] == [n * 10**9 for n in (1, 2, 3)]
    with Reader("talk") as judge:
        (qos,) = judge.connections[0].ext.offered_qos_profiles  # type: ignore[union-attr]
        assert (qos.reliability.value, qos.durability.value, qos.deadline.sec) == (1, 2, 9223372036)


def test_ctrl_c_ends_it_when_it_is_pressed_and_not_with_the_next_message(
    session: Session, ros2: Callable[[str], Any]
) -> None:
    session.start_executable(find("demo_nodes_py", "talker"))
    recorder = ros2("bag record -a -o talk")
    session.clock.sleep(1.25)
    recorder.interrupt()
    session.clock.sleep(0.01)
    assert recorder.exit_code == 0
    recorder = ros2("bag record -a -o more")
    session.clock.sleep(0.01)
    recorder.terminate()
    assert recorder.wait(1) == 0 and Path("more/metadata.yaml").exists()


def test_a_killed_recording_loses_nothing_either(session: Session, ros2: Callable[[str], Any]) -> None:
    session.start_executable(find("demo_nodes_py", "talker"))
    recorder = ros2("bag record /chatter -o talk")
    session.clock.sleep(2.5)
    recorder.kill()
    recorder.wait(1)
    assert len(all_of("talk")) == 2


def test_topics_that_appear_later_are_found(session: Session, ros2: Callable[[str], Any], node: Any) -> None:
    recorder = ros2("bag record /late /chatter -o talk")
    session.clock.sleep(1)
    out = node.create_publisher(String, "late", 10)
    session.clock.sleep(0.1)
    out.publish(String(data="here"))
    session.clock.sleep(0.1)
    stop(session, recorder)
    assert "Subscribed to topic '/late'" in recorder.output and "All requested" not in recorder.output
    assert [message.topic for message in all_of("talk")] == ["/late"]


def test_without_discovery_only_what_is_there_is_recorded(
    session: Session, ros2: Callable[[str], Any], node: Any
) -> None:
    node.create_publisher(String, "early", 10)
    recorder = ros2("bag record --all --no-discovery -o talk")
    session.clock.sleep(1)
    node.create_publisher(String, "late", 10)
    session.clock.sleep(1)
    stop(session, recorder)
    assert "'/early'" in recorder.output and "'/late'" not in recorder.output


@pytest.mark.parametrize(
    ("line", "topics"),
    [
        ("-a", {"/a/x", "/a/y", "/b/x", "/events/write_split", "/parameter_events", "/rosout"}),
        ("-e '/a/.*'", {"/a/x", "/a/y"}),
        ("-e '/a/.*' /b/x", {"/a/x", "/a/y", "/b/x"}),
        ("-e . -x '^/[^ab]'", {"/a/x", "/a/y", "/b/x"}),
        ("-e 'x$|silent|hidden'", {"/a/x", "/b/x"}),
        ("-e 'x$|silent' --include-unpublished-topics", {"/a/x", "/b/x", "/silent"}),
        ("-e 'x$|hidden' --include-hidden-topics", {"/a/x", "/b/x", "/_hidden"}),
        ("-a --ignore-leaf-topics", {"/b/x"}),
    ],
)
def test_topics_are_chosen_as_the_flags_say(
    session: Session, ros2: Callable[[str], Any], node: Any, line: str, topics: set[str]
) -> None:
    for name in ("/a/x", "/a/y", "/b/x", "/_hidden"):
        node.create_publisher(String, name, 10)
    for name in ("/b/x", "/silent"):
        node.create_subscription(String, name, print, 10)
    recorder = ros2(f"bag record {line} -o talk")
    session.clock.sleep(0.5)
    stop(session, recorder)
    with Reader("talk") as judge:
        assert {connection.topic for connection in judge.connections} == topics


def test_a_hidden_topic_is_passed_over_with_a_word(session: Session, ros2: Callable[[str], Any], node: Any) -> None:
    node.create_publisher(String, "/_hidden", 10)
    recorder = ros2("bag record -a -o talk")
    session.clock.sleep(1)
    stop(session, recorder)
    text = "[WARN] [rosbag2_recorder]: Hidden topics are not recorded. Enable them with --include-hidden-topics"
    assert lines(recorder).count(text) == 1


def test_a_pause_leaves_a_gap(session: Session, ros2: Callable[[str], Any]) -> None:
    session.start_executable(find("demo_nodes_py", "talker"))
    recorder = ros2("bag record /chatter -o talk --start-paused")
    session.clock.sleep(2.5)
    for seconds in (2, 2):
        recorder.write_stdin(" ")
        session.clock.sleep(seconds)
    stop(session, recorder)
    said = lines(recorder)
    assert "[INFO] [rosbag2_recorder]: Waiting for recording: Press SPACE to start." in said
    assert [line for line in said if line.endswith("g recording.")] == [
        "[INFO] [rosbag2_recorder]: Resuming recording.",
        "[INFO] [rosbag2_recorder]: Pausing recording.",
    ]
    assert [message.stamp - START for message in all_of("talk")] == [3 * 10**9, 4 * 10**9]


def test_a_bag_is_split_by_time_and_the_split_is_told(session: Session, ros2: Callable[[str], Any], node: Any) -> None:
    from rosbag2_interfaces.msg import WriteSplitEvent

    heard: list[Any] = []
    node.create_subscription(WriteSplitEvent, "/events/write_split", heard.append, 10)
    session.start_executable(find("demo_nodes_py", "talker"))
    recorder = ros2("bag record /chatter -o talk -d 2")
    session.clock.sleep(7.5)
    executor = rclpy.executors.SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    executor.spin_once(timeout_sec=0)
    executor.spin_once(timeout_sec=0)
    stop(session, recorder)
    first, second, third = (str(Path("talk", f"talk_{number}.db3")) for number in range(3))
    assert [(event.closed_file, event.opened_file) for event in heard] == [(first, second), (second, third)]
    files = yaml.safe_load(Path("talk/metadata.yaml").read_text(encoding="utf-8"))["rosbag2_bagfile_information"]["files"]
    assert [file["message_count"] for file in files] == [3, 3, 1]


def test_snapshots_are_taken_by_a_service(session: Session, ros2: Callable[[str], Any]) -> None:
    session.start_executable(find("demo_nodes_py", "talker"))
    recorder = ros2("bag record /chatter -o talk --snapshot-mode --max-cache-size 90")
    session.clock.sleep(9.5)
    ros2("service call /rosbag2_recorder/snapshot rosbag2_interfaces/srv/Snapshot").wait(1)
    stop(session, recorder)
    assert [message.stamp - START for message in all_of("talk")] == [n * 10**9 for n in (7, 8, 9)]


def test_simulated_time_is_waited_for_and_stamps_the_messages(
    session: Session, ros2: Callable[[str], Any], node: Any
) -> None:
    from rosgraph_msgs.msg import Clock

    session.start_executable(find("demo_nodes_py", "talker"))
    recorder = ros2("bag record /chatter -o talk --use-sim-time")
    session.clock.sleep(2.5)
    clock, now = node.create_publisher(Clock, "/clock", 1), Clock()
    now.clock.sec = 77
    session.clock.sleep(0.3)
    clock.publish(now)
    session.clock.sleep(1)
    stop(session, recorder)
    assert "use_sim_time set, waiting for /clock before starting recording..." in recorder.output
    assert "Sim time /clock found, starting recording." in recorder.output
    assert [message.stamp for message in all_of("talk")] == [77 * 10**9]


@pytest.mark.parametrize("flags", ["-s mcap", "--compression-mode file --compression-format zstd", "--max-cache-size 0"])
def test_other_storages_and_compression(session: Session, ros2: Callable[[str], Any], flags: str) -> None:
    session.start_executable(find("demo_nodes_py", "talker"))
    recorder = ros2(f"bag record /chatter -o talk {flags} -f cdr")
    session.clock.sleep(2.5)
    stop(session, recorder)
    with Reader("talk") as judge:
        assert len(list(judge.messages())) == 2


def test_without_a_name_the_folder_has_the_sessions_time(
    session: Session, ros2: Callable[[str], Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    recorder = ros2("bag record -a")
    session.clock.sleep(0.1)
    stop(session, recorder)
    (folder,) = Path().glob("rosbag2_2023_11_1[45]-*_*_20")
    assert (folder / f"{folder.name}_0.db3").exists()


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ("", "Invalid choice: Must specify topic(s), --regex or --all"),
        ("-a /chatter", "Specify either --all or topics, but not both simultaneously."),
        ("/chatter -x b", "--exclude argument cannot be used when specifying a list of topics explicitly"),
        ("-a -o there", "Output folder 'there' already exists."),
        ("-a --compression-format zstd", "Cannot specify compression format without a compression mode."),
        ("-a -s mcap --compression-mode message", "compression_mode 'message' is not supported by the MCAP storage"),
        ("-a --use-sim-time --no-discovery", "--use-sim-time and --no-discovery both set"),
        ("-a -b 5", "Invalid bag splitting size given. Please provide a value greater than 86016."),
        ("-e '('", "--regex '(' is no regular expression"),
        ("-a --qos-profile-overrides-path bad.yaml", "Unexpected key `colour` for QoS profile."),
        ("-a -p 0", "--polling-interval must be at least 1 ms"),
    ],
)
def test_what_cannot_be_is_refused_in_humbles_words(ros2: Callable[[str], Any], line: str, text: str) -> None:
    Path("there").mkdir()
    Path("bad.yaml").write_text("/chatter: {colour: red}", encoding="utf-8")
    process = ros2(f"bag record {line}")
    assert process.wait(5) == 1
    last = process.output.splitlines()[-1]
    assert last.startswith("[ERROR] [ros2bag]: ") and text in last
    assert {path.name for path in Path().iterdir()} == {"there", "bad.yaml"}


def test_a_launch_file_records_until_its_ctrl_c(session: Session, ros2: Callable[[str], Any]) -> None:
    Path("record.launch.py").write_text(
        "from launch import LaunchDescription\n"
        "from launch.actions import ExecuteProcess\n"
        "from launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([\n"
        "        Node(package='demo_nodes_py', executable='talker'),\n"
        "        ExecuteProcess(cmd=['ros2', 'bag', 'record', '-a', '-o', 'talk'], output='screen')])\n", encoding="utf-8"
    )
    launch = ros2("launch record.launch.py")
    session.clock.sleep(3.5)
    launch.interrupt()
    assert launch.wait(10) == 0
    assert "[rosbag2_recorder]: Recording stopped" in launch.output
    assert sum(message.topic == "/chatter" for message in all_of("talk")) == 3


@pytest.mark.parametrize("storage", ["sqlite3", "mcap"])
def test_a_disk_that_is_full_ends_the_recording_and_loses_nothing_before(
    session: Session, ros2: Callable[[str], Any], node: Any, storage: str
) -> None:
    resource = pytest.importorskip("resource", reason="Windows has no limits on a file's size")
    out = node.create_publisher(String, "chatter", 10)
    recorder = ros2(f"bag record /chatter -o talk -s {storage}")
    session.clock.sleep(0.1)
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2_000_000, before[1]))
    try:
        for number in range(80):
            out.publish(String(data=f"{number:09}" + "x" * 50_000))
            session.clock.sleep(0.1)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert recorder.wait(1) == 1
    assert "' cannot be written: " in recorder.output and "Make room, then: ros2 bag reindex talk" in recorder.output
    assert not Path("talk/metadata.yaml").exists()
    assert ros2("bag reindex talk").wait(5) == 0
    kept = [int(message.data[8:17]) for message in all_of("talk")]
    assert kept == list(range(len(kept))) and len(kept) > 20


@pytest.mark.parametrize("line", ["record -a", "play ."])
@pytest.mark.parametrize("option", ["--qos-profile-overrides-path", "--storage-config-file"])
def test_a_settings_file_that_is_not_there_is_an_error_of_usage(ros2: Callable[[str], Any], line: str, option: str) -> None:
    process = ros2(f"bag {line} {option} nowhere.yaml")
    assert process.wait(5) == 2
    expected = f"ros2 bag {line.split()[0]}: error: argument {option}: can't open 'nowhere.yaml': "
    assert process.output.splitlines()[-1] == f"{expected}[Errno 2] No such file or directory: 'nowhere.yaml'"
    assert not list(Path().iterdir())
