"""Programs of the ROS tutorials, and what upstream's own tests of rosbag2_py ask for."""

from __future__ import annotations

import os
import textwrap
from pathlib import Path
from typing import Any

import pytest
import rosbag2_py
from rclpy.duration import Duration
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.time import Time
from rosidl_runtime_py.utilities import get_message
from std_msgs.msg import String

from coursekit.processes.executables import find
from coursekit.processes.session import Session

RECORDER = """
    import rclpy
    from rclpy.node import Node
    from rclpy.serialization import serialize_message
    from std_msgs.msg import String

    import rosbag2_py

    class SimpleBagRecorder(Node):
        def __init__(self):
            super().__init__('simple_bag_recorder')
            self.writer = rosbag2_py.SequentialWriter()
            storage_options = rosbag2_py._storage.StorageOptions(uri='my_bag', storage_id='{storage_id}')
            converter_options = rosbag2_py._storage.ConverterOptions('', '')
            self.writer.open(storage_options, converter_options)
            topic_info = rosbag2_py._storage.TopicMetadata(
                {number}name='chatter', type='std_msgs/msg/String', serialization_format='cdr')
            self.writer.create_topic(topic_info)
            self.subscription = self.create_subscription(String, 'chatter', self.topic_callback, 10)

        def topic_callback(self, msg):
            self.writer.write('chatter', serialize_message(msg), self.get_clock().now().nanoseconds)

    def main(args=None):
        rclpy.init(args=args)
        rclpy.spin(SimpleBagRecorder())
        rclpy.shutdown()

    main()
"""


@pytest.mark.parametrize(("storage_id", "number"), [("sqlite3", ""), ("mcap", "id=0, ")])
def test_the_tutorials_recorder_leaves_a_whole_bag_when_it_is_interrupted(
    tmp_path: Path, storage_id: str, number: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    program = tmp_path / "simple_bag_recorder.py"
    program.write_text("#!/usr/bin/env python3\n" + textwrap.dedent(RECORDER.format(storage_id=storage_id, number=number)))
    os.chmod(program, 0o755)
    with Session(virtual=True).use() as session:
        recorder = session.start_executable(program)
        session.start_executable(find("demo_nodes_py", "talker"))
        session.clock.sleep(3.5)
        recorder.interrupt()
        recorder.wait(5)
    reader = rosbag2_py.SequentialReader()
    reader.open(rosbag2_py.StorageOptions("my_bag"), rosbag2_py.ConverterOptions("", ""))
    kinds = {topic_info.name: get_message(topic_info.type) for topic_info in reader.get_all_topics_and_types()}
    said = []
    while reader.has_next():
        topic, data, stamp = reader.read_next()
        said.append((deserialize_message(data, kinds[topic]).data, stamp))
    assert said == [(f"Hello World: {n}", 1_700_000_001_000_000_000 + n * 10**9) for n in range(3)]


@pytest.fixture
def bag(tmp_path: Path) -> str:
    """A bag with ten messages on /topic and five on /other."""
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(uri=str(tmp_path / "bag"), storage_id="sqlite3"), rosbag2_py.ConverterOptions())
    for name in ("/topic", "/other"):
        writer.create_topic(rosbag2_py.TopicMetadata(name, "std_msgs/msg/String", "cdr"))
    for number in range(10):
        writer.write("/topic", serialize_message(String(data=f"Hello, world! {number}")), number * 100)
        if number % 2:
            writer.write("/other", serialize_message(String(data="x")), number * 100 + 1)
    writer.close()
    return str(tmp_path / "bag")


def opened(bag: str, **options: Any) -> rosbag2_py.SequentialReader:
    """A reader of it."""
    reader = rosbag2_py.SequentialReader()
    reader.open(rosbag2_py.StorageOptions(uri=bag, **options), rosbag2_py.ConverterOptions("cdr", "cdr"))
    return reader


def rest(reader: rosbag2_py.SequentialReader) -> list[tuple[str, int]]:
    """Topics and times of what is left."""
    records = []
    while reader.has_next():
        topic, _, stamp = reader.read_next()
        records.append((topic, stamp))
    return records


def test_a_filter_holds_from_the_next_message_on_until_it_is_reset(bag: str) -> None:
    reader = opened(bag)
    assert reader.read_next()[0::2] == ("/topic", 0)
    reader.set_filter(rosbag2_py.StorageFilter(topics=["/other"]))
    assert reader.read_next()[0::2] == ("/other", 101)
    reader.reset_filter()
    assert rest(reader)[:2] == [("/topic", 200), ("/topic", 300)]
    reader.seek(850)
    assert rest(reader) == [("/topic", 900), ("/other", 901)]
    reader.set_filter(rosbag2_py.StorageFilter(topics=["/other"]))
    reader.seek(0)
    assert {topic for topic, _ in rest(reader)} == {"/other"}
    with pytest.raises(RuntimeError, match="Bag is at end. No next message."):
        reader.read_next()


def test_the_facts_of_a_bag_come_in_rclpys_types(bag: str) -> None:
    facts = rosbag2_py.Info().read_metadata(bag, "sqlite3")
    assert (facts.message_count, facts.duration, facts.starting_time) == (15, Duration(nanoseconds=901), Time())
    assert facts.files[0].duration == Duration(nanoseconds=901) and facts.files[0].path == "bag_0.db3"
    assert [topic.message_count for topic in facts.topics_with_message_count] == [10, 5]
    assert facts.storage_identifier == "sqlite3" and facts.version == 5
    metadata = rosbag2_py.BagMetadata(duration=Duration(seconds=1), starting_time=Time(seconds=2))
    assert metadata.version == 6 and "Duration:          1.000000000s\nStart:             Jan  1 1970 " in repr(metadata)
    metadata.duration = Duration(nanoseconds=7)
    assert metadata.duration_ns == 7
    assert opened(bag).get_metadata().bag_size == facts.bag_size > 20_000


def test_compressing_writers_and_readers_understand_each_other(tmp_path: Path) -> None:
    for mode in (rosbag2_py.CompressionMode.FILE, rosbag2_py.CompressionMode.MESSAGE):
        uri = str(tmp_path / mode.name)
        writer = rosbag2_py.SequentialCompressionWriter(rosbag2_py.CompressionOptions("zstd", mode))
        writer.open(rosbag2_py.StorageOptions(uri), rosbag2_py.ConverterOptions())
        writer.create_topic(rosbag2_py.TopicMetadata("/a", "std_msgs/msg/String", "cdr"))
        writer.write("/a", serialize_message(String(data="a" * 1000)), 5)
        del writer  # what ends it ends the bag
        reader = rosbag2_py.SequentialCompressionReader()
        reader.open(rosbag2_py.StorageOptions(uri), rosbag2_py.ConverterOptions())
        assert deserialize_message(reader.read_next()[1], String).data == "a" * 1000
        assert reader.get_metadata().compression_mode == mode.name


def test_metadata_is_made_anew(bag: str) -> None:
    path = Path(bag) / "metadata.yaml"
    before = path.read_text()
    path.unlink()
    rosbag2_py.Reindexer().reindex(rosbag2_py.StorageOptions(uri=bag, storage_id="sqlite3"))
    assert path.read_text() == before


def test_names_and_registers_are_there() -> None:
    assert rosbag2_py.get_registered_readers() == rosbag2_py.get_registered_writers() == {"sqlite3", "mcap"}
    assert rosbag2_py.get_registered_compressors() == {"zstd"} and rosbag2_py.get_default_storage_id() == "sqlite3"
    assert "cdr_converter" in rosbag2_py.get_registered_serializers()
    for name in rosbag2_py.__all__:
        assert getattr(rosbag2_py, name) is not None
    with pytest.raises(AttributeError, match="module 'rosbag2_py' has no attribute 'Rekorder'"):
        rosbag2_py.Rekorder  # noqa: B018
    metadata = rosbag2_py.TopicMetadata("/a", "t", "cdr", "- depth: 1")
    same = {"name": "/a", "type": "t", "serialization_format": "cdr", "offered_qos_profiles": "- depth: 1"}
    assert metadata.equals(rosbag2_py.TopicMetadata(**same))


def test_what_is_done_in_the_wrong_order_is_told(tmp_path: Path, bag: str) -> None:
    with pytest.raises(RuntimeError, match=r"Bag is not open. Call open\(\) before reading."):
        rosbag2_py.SequentialReader().has_next()
    writer = rosbag2_py.SequentialWriter()
    with pytest.raises(RuntimeError, match=r"Bag is not open. Call open\(\) before writing."):
        writer.write("/a", b"", 0)
    with pytest.raises(RuntimeError, match="can't overwrite existing bag"):
        writer.open(rosbag2_py.StorageOptions(bag), rosbag2_py.ConverterOptions())
    writer.open(rosbag2_py.StorageOptions(str(tmp_path / "new")), rosbag2_py.ConverterOptions())
    writer.create_topic(rosbag2_py.TopicMetadata("/a", "std_msgs/msg/String", "cdr"))
    with pytest.raises(TypeError, match=r"takes the bytes of a message, not String: write serialize_message\(...\)"):
        writer.write("/a", String(), 0)  # type: ignore[arg-type]
    with pytest.raises(RuntimeError, match="Could not find converter for format xml: there is only 'cdr'"):
        writer.open(rosbag2_py.StorageOptions(str(tmp_path / "x")), rosbag2_py.ConverterOptions("", "xml"))
    with pytest.raises(RuntimeError, match="there is no bag"):
        opened(str(tmp_path / "nowhere"))


def test_bags_are_merged_and_parted_by_a_file_of_options(tmp_path: Path, bag: str) -> None:
    (tmp_path / "out.yaml").write_text(
        f"output_bags:\n- uri: {tmp_path}/both\n  storage_id: mcap\n  all: true\n"
        f"- uri: {tmp_path}/others\n  topics: [/other]\n  compression_mode: file\n  compression_format: zstd\n"
        f"- uri: {tmp_path}/rest\n  regex: .*\n  exclude: other\n"
    )
    rosbag2_py.bag_rewrite([rosbag2_py.StorageOptions(bag), rosbag2_py.StorageOptions(bag)], str(tmp_path / "out.yaml"))
    both = rest(opened(f"{tmp_path}/both"))
    assert len(both) == 30 and both == sorted(both, key=lambda one: one[1])
    assert {topic for topic, _ in rest(opened(f"{tmp_path}/others"))} == {"/other"}
    assert {topic for topic, _ in rest(opened(f"{tmp_path}/rest"))} == {"/topic"}


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("", "must have top-level key 'output_bags'"),
        ("output_bags: 7", "must contain a list of StorageOptions/RecordOptions dicts"),
        ("output_bags: [{}]", "each of output_bags needs a 'uri'"),
        ("output_bags: [{uri: a, colour: red}]", "there is no option 'colour'; there are uri, storage_id"),
        ("output_bags: [{uri: a, topics: /a}]", "'topics' is '/a', and should be list"),
        ("output_bags: [{uri: a, regex: '('}]", "a regular expression is wrong"),
    ],
)
def test_options_that_are_wrong_are_named(tmp_path: Path, bag: str, text: str, error: str) -> None:
    (tmp_path / "out.yaml").write_text(text)
    with pytest.raises(RuntimeError, match=error):
        rosbag2_py.bag_rewrite([rosbag2_py.StorageOptions(bag)], str(tmp_path / "out.yaml"))
