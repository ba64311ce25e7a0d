"""Bags go out as ROS 2 writes them, and come in whoever wrote them; the library rosbags is the judge."""

from __future__ import annotations

import random
import sqlite3
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml
from mcap import writer as mcap_writer
from rosbags.rosbag2 import CompressionFormat, CompressionMode, Reader, StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

from coursekit.bag import metadata_file
from coursekit.bag.errors import BagError
from coursekit.bag.mcap_reader import McapReader
from coursekit.bag.reader import BagReader
from coursekit.bag.reindex import reindex
from coursekit.bag.storage import Message
from coursekit.bag.writer import BagWriter, WriteSettings
from tests.bag.made import CHATTER, SECOND, all_of, text_bytes

Make = Callable[..., Path]
KINDS = [
    {"storage_id": "sqlite3"},
    {"storage_id": "sqlite3", "preset": "resilient"},
    {"storage_id": "mcap"},
    {"storage_id": "mcap", "preset": "fastwrite"},
    {"storage_id": "mcap", "preset": "zstd_small"},
    {"storage_id": "sqlite3", "compression_mode": "FILE", "compression_format": "zstd"},
    {"storage_id": "sqlite3", "compression_mode": "message", "compression_format": "zstd"},
    {"storage_id": "mcap", "compression_mode": "file", "compression_format": "zstd"},
]


@pytest.mark.parametrize("settings", KINDS)
@pytest.mark.parametrize("split", [0, 3])
def test_what_is_written_comes_back_here_and_in_rosbags(make: Make, settings: dict[str, str], split: int) -> None:
    bag = make("talk", 10, max_file_seconds=split, **settings)
    messages = all_of(bag)
    assert [message.stamp for message in messages] == [(100 + number) * SECOND for number in range(10)]
    assert messages[2] == Message("/odd", text_bytes("Hello 2"), 102 * SECOND)
    with Reader(bag) as judge:
        seen = [(connection.topic, data, stamp) for connection, stamp, data in judge.messages()]
        assert seen == [tuple(message) for message in messages] and judge.message_count == 10
        assert {connection.topic: connection.msgcount for connection in judge.connections} == {"/chatter": 7, "/odd": 3}
        assert (judge.start_time, judge.duration) == (100 * SECOND, 9 * SECOND + 1)
    assert len(metadata_file.read(bag).files) == (3 if split else 1)


@pytest.mark.parametrize("settings", KINDS)
def test_metadata_made_anew_is_the_metadata_that_was(make: Make, settings: dict[str, str]) -> None:
    bag = make("talk", 10, max_file_seconds=3, **settings)
    path = bag / "metadata.yaml"
    before = path.read_text()
    path.unlink()
    reindex(bag)
    assert path.read_text() == before


def mcap_file(path: Path, messages: list[bytes], **settings: Any) -> Path:
    """A file by the mcap library, with one channel."""
    with path.open("wb") as file:
        writer = mcap_writer.Writer(file, **settings)
        writer.start("ros2", "test")
        channel = writer.register_channel("/chatter", "cdr", writer.register_schema("std_msgs/msg/String", "ros2msg", b""))
        for number, data in enumerate(messages):
            writer.add_message(channel, number * SECOND, data, number * SECOND)
        writer.finish()
    return path


def test_a_large_message_in_an_lz4_chunk_is_read(tmp_path: Path) -> None:
    frame = random.Random(1).randbytes(5_000_000)  # as a camera's picture: lz4 finds nothing to compress
    path = mcap_file(tmp_path / "a.mcap", [frame], compression=mcap_writer.CompressionType.LZ4)
    assert [message.data for message in all_of(path)] == [frame]


@pytest.mark.parametrize("chunks", [True, False])
def test_what_an_interrupted_recording_holds_is_read_without_keeping_it(tmp_path: Path, chunks: bool) -> None:
    texts = [text_bytes(f"Hello {number} " + "x" * 10_000) for number in range(200)]
    path = mcap_file(tmp_path / "a.mcap", texts, use_chunking=chunks, chunk_size=50_000)
    if chunks:
        path.write_bytes(path.read_bytes()[:-20])
    reader = McapReader(path)
    tracemalloc.start()
    assert [message.data == text for message, text in zip(reader.messages(None, 0), texts, strict=True)] == [True] * 200
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert most < 1_000_000


def test_an_sqlite_file_has_the_tables_of_humble(make: Make) -> None:
    bag = make("talk", 4)
    with sqlite3.connect(bag / "talk_0.db3") as db:
        tables = dict(db.execute("SELECT name, sql FROM sqlite_master"))
        columns = {name: [row[1] for row in db.execute(f"PRAGMA table_info({name})")] for name in tables}
        assert columns == {
            "timestamp_idx": [],
            "schema": ["schema_version", "ros_distro"],
            "metadata": ["id", "metadata_version", "metadata"],
            "topics": ["id", "name", "type", "serialization_format", "offered_qos_profiles"],
            "messages": ["id", "topic_id", "timestamp", "data"],
        }
        assert tables["timestamp_idx"] == "CREATE INDEX timestamp_idx ON messages (timestamp ASC)"
        assert db.execute("SELECT * FROM schema").fetchall() == [(3, "humble")]
        ((version, text),) = db.execute("SELECT metadata_version, metadata FROM metadata")
        assert version == 5 and yaml.safe_load(text)["message_count"] == 4


def test_the_metadata_is_humbles_to_the_byte(make: Make) -> None:
    assert (make("talk", 2) / "metadata.yaml").read_text() == (
        "rosbag2_bagfile_information:\n"
        "  version: 5\n"
        "  storage_identifier: sqlite3\n"
        "  duration:\n"
        "    nanoseconds: 1000000000\n"
        "  starting_time:\n"
        "    nanoseconds_since_epoch: 100000000000\n"
        "  message_count: 2\n"
        "  topics_with_message_count:\n"
        "    - topic_metadata:\n"
        "        name: /chatter\n"
        "        type: std_msgs/msg/String\n"
        "        serialization_format: cdr\n"
        '        offered_qos_profiles: ""\n'
        "      message_count: 2\n"
        "    - topic_metadata:\n"
        "        name: /odd\n"
        "        type: std_msgs/msg/String\n"
        "        serialization_format: cdr\n"
        '        offered_qos_profiles: ""\n'
        "      message_count: 0\n"
        '  compression_format: ""\n'
        '  compression_mode: ""\n'
        "  relative_file_paths:\n"
        "    - talk_0.db3\n"
        "  files:\n"
        "    - path: talk_0.db3\n"
        "      starting_time:\n"
        "        nanoseconds_since_epoch: 100000000000\n"
        "      duration:\n"
        "        nanoseconds: 1000000000\n"
        "      message_count: 2\n"
    )


@pytest.mark.parametrize("version", [8, 9])
@pytest.mark.parametrize("storage", list(StoragePlugin))
@pytest.mark.parametrize("mode", list(CompressionMode))
def test_bags_of_newer_releases_are_read(
    tmp_path: Path, version: int, storage: StoragePlugin, mode: CompressionMode
) -> None:
    if mode == CompressionMode.STORAGE and storage == StoragePlugin.SQLITE3:
        return  # there is no such bag
    store = get_typestore(Stores.ROS2_JAZZY)
    writer = Writer(tmp_path / "new", version=version, storage_plugin=storage)  # type: ignore[arg-type]
    writer.set_compression(mode, CompressionFormat.ZSTD)
    with writer:
        talk = writer.add_connection("/chatter", "std_msgs/msg/String", typestore=store)
        for number in range(5):
            writer.write(talk, number * SECOND, text_bytes(f"new {number}"))
    assert all_of(tmp_path / "new") == [Message("/chatter", text_bytes(f"new {n}"), n * SECOND) for n in range(5)]
    assert BagReader(str(tmp_path / "new")).facts.topics_with_message_count[0].message_count == 5


def test_bags_of_older_releases_are_read(make: Make) -> None:
    bag = make("talk", 3)
    path = bag / "metadata.yaml"
    document = yaml.safe_load(path.read_text())
    root = document["rosbag2_bagfile_information"]
    root["version"] = 3
    root["relative_file_paths"] = ["talk/talk_0.db3"]
    del root["files"], root["compression_format"], root["compression_mode"]
    for topic in root["topics_with_message_count"]:
        del topic["topic_metadata"]["offered_qos_profiles"]
    path.write_text(yaml.safe_dump(document))
    with sqlite3.connect(bag / "talk_0.db3") as db:
        db.executescript("DROP TABLE schema; DROP TABLE metadata; ALTER TABLE topics DROP COLUMN offered_qos_profiles")
    assert len(all_of(bag)) == 3 and len(all_of(bag / "talk_0.db3")) == 3


@pytest.mark.parametrize("storage_id", ["sqlite3", "mcap"])
def test_one_file_can_be_read_without_its_folder(make: Make, storage_id: str) -> None:
    bag = make("talk", 6, storage_id=storage_id)
    (file,) = [path for path in bag.iterdir() if path.suffix != ".yaml"]
    reader = BagReader(str(file))
    assert reader.facts.message_count == 6 and [topic.name for topic in reader.topics()] == ["/chatter", "/odd"]
    assert all_of(file) == all_of(bag)


@pytest.mark.parametrize("storage_id", ["sqlite3", "mcap"])
def test_reading_begins_where_it_is_told_and_takes_the_topics_it_is_told(make: Make, storage_id: str) -> None:
    reader = BagReader(str(make("talk", 9, storage_id=storage_id, max_file_seconds=2)))
    reader.rewind(103 * SECOND, ["/odd"])
    stamps = []
    while (message := reader.take()) is not None:
        stamps.append(message.stamp // SECOND)
    assert stamps == [105, 108]


@pytest.mark.parametrize("storage_id", ["sqlite3", "mcap"])
def test_a_bag_is_split_before_its_files_grow_too_large(tmp_path: Path, storage_id: str) -> None:
    told: list[tuple[str, str]] = []
    limit = 200_000
    writer = BagWriter(WriteSettings(str(tmp_path / "big"), storage_id, max_file_size=limit))
    writer.settings.on_split = lambda closed, opened: told.append((Path(closed).name, Path(opened).name))
    writer.create_topic(CHATTER)
    for number in range(200):
        writer.write(Message("/chatter", bytes(20_000), number))
    writer.close()
    files = metadata_file.read(tmp_path / "big").files
    assert sum(file.message_count for file in files) == 200 and len(told) == len(files) - 1 > 2
    suffix = Path(files[0].path).suffix
    assert told[0] == (f"big_0{suffix}", f"big_1{suffix}")
    assert len(all_of(tmp_path / "big")) == 200


def test_a_snapshot_keeps_the_newest_messages_until_it_is_asked(tmp_path: Path) -> None:
    writer = BagWriter(WriteSettings(str(tmp_path / "snap"), max_cache_size=1000, snapshot_mode=True))
    writer.create_topic(CHATTER)
    for number in range(100):
        writer.write(Message("/chatter", bytes(100), number))
    assert writer.take_snapshot()
    writer.write(Message("/chatter", bytes(100), 1000))
    writer.close()
    assert [message.stamp for message in all_of(tmp_path / "snap")] == list(range(90, 100))


def test_an_mcap_recording_that_broke_off_is_read_as_far_as_it_goes(make: Make) -> None:
    bag = make("talk", 6, storage_id="mcap", preset="fastwrite")
    file = bag / "talk_0.mcap"
    whole = file.read_bytes()
    file.write_bytes(whole[: whole.index(b"Hello 4")])
    assert [message.data for message in all_of(file)] == [text_bytes(f"Hello {number}") for number in range(4)]
    reindex(bag)
    assert metadata_file.read(bag).message_count == 4


@pytest.mark.parametrize(
    ("settings", "text"),
    [
        ({"storage_id": "leveldb"}, "there is no storage 'leveldb'; there are mcap and sqlite3"),
        ({"max_file_size": 10}, "Please provide a value greater than 86016. Specified value of 10"),
        ({"compression_mode": "file", "compression_format": "lz4"}, "no compression format 'lz4'; there is zstd"),
        ({"compression_mode": "both"}, "there is no compression mode 'both'; there are none, file and message"),
        ({"snapshot_mode": True}, "Max cache size must be greater than 0"),
        ({"preset": "fast"}, "sqlite3 has no preset 'fast'; it has none and resilient"),
        ({"storage_id": "mcap", "preset": "resilient"}, "mcap has no preset 'resilient'"),
    ],
)
def test_settings_that_cannot_be_are_refused_before_anything_is_written(
    tmp_path: Path, settings: dict[str, object], text: str
) -> None:
    with pytest.raises(BagError, match=text):
        BagWriter(WriteSettings(str(tmp_path / "bag"), **settings))  # type: ignore[arg-type]
    assert not list(tmp_path.iterdir())


def test_a_bag_is_never_overwritten_and_never_written_after_its_end(make: Make, tmp_path: Path) -> None:
    make("talk", 1)
    with pytest.raises(BagError, match=r"Bag directory already exists \(.*talk\), can't overwrite existing bag"):
        make("talk", 1)
    writer = BagWriter(WriteSettings(str(tmp_path / "other")))
    with pytest.raises(BagError, match=r"Failed to write on topic '/chatter'. Call create_topic\(\) before first write."):
        writer.write(Message("/chatter", b"", 0))
    writer.create_topic(CHATTER)
    writer.close()
    with pytest.raises(BagError, match="is closed"):
        writer.write(Message("/chatter", b"", 0))


def test_settings_of_a_storage_come_from_a_file(tmp_path: Path) -> None:
    (tmp_path / "sqlite.yaml").write_text("write:\n  pragmas: ['page_size = 8192']\n")
    (tmp_path / "mcap.yaml").write_text("compression: Zstd\nchunkSize: 5000\n")
    for storage_id in ("sqlite3", "mcap"):
        config = str(tmp_path / f"{storage_id.rstrip('3')}.yaml")
        writer = BagWriter(WriteSettings(str(tmp_path / storage_id), storage_id, config=config))
        writer.create_topic(CHATTER)
        for number in range(100):
            writer.write(Message("/chatter", bytes(1000), number))
        writer.close()
        assert len(all_of(tmp_path / storage_id)) == 100
    assert (tmp_path / "mcap" / "mcap_0.mcap").stat().st_size < 30_000
    with sqlite3.connect(tmp_path / "sqlite3" / "sqlite3_0.db3") as db:
        assert db.execute("PRAGMA page_size").fetchone() == (8192,)


@pytest.mark.parametrize("what", ["PRAGMA max_page_count = 8", "DROP TABLE messages"])
def test_a_disk_that_is_full_is_told_by_the_files_name(tmp_path: Path, what: str) -> None:
    writer = BagWriter(WriteSettings(str(tmp_path / "full")))
    writer.create_topic(CHATTER)
    writer._file._db.execute(what)  # type: ignore[union-attr]
    with pytest.raises(BagError, match=r"full_0.db3' cannot be written: (database or disk is full|no such table)"):
        for number in range(10):
            writer.write(Message("/chatter", bytes(10_000), number))
