"""Bags that are broken, or made to do harm: a clear error each time, no hang, nothing outside of the folder touched."""

from __future__ import annotations

import os
import re
import shutil
import sqlite3
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import lz4.frame
import pytest
import yaml
import zstandard
from hypothesis import given
from hypothesis import strategies as st
from mcap.records import Chunk

from coursekit.bag import compression, mcap_reader, metadata_file
from coursekit.bag.errors import BagError
from coursekit.bag.metadata_file import ROOT
from coursekit.bag.reader import BagReader
from coursekit.bag.reindex import reindex
from tests.bag.made import all_of
from tests.needs import ON_WINDOWS

Make = Callable[..., Path]


def change(bag: Path, edit: Callable[[dict[str, Any]], Any]) -> Path:
    """Edit a bag's metadata."""
    path = bag / "metadata.yaml"
    document = yaml.safe_load(path.read_text())
    edit(document[ROOT])
    path.write_text(yaml.safe_dump(document))
    return bag


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("", "is no metadata of a bag: it has no 'rosbag2_bagfile_information' at the top"),
        ("[1, 2]", "is no metadata of a bag"),
        ("a: [", "is no YAML: while parsing"),
        ("\x00", "is no YAML"),
        ("!!python/object/apply:os.system ['true']", "is no YAML: could not determine a constructor"),
        ("a: &a [x, x]\nb: [*a, *a]", r"is no YAML: it has aliases \(\*name\), which bags do not have"),
        ("a: 2001-99-99", "is no YAML: month must be"),
        ("[" * 100_000, "is no YAML"),
        (f"{ROOT}: 7", f"'{ROOT}' is int 7, and should be keys with values"),
        (f"{ROOT}: {{}}", f"'version' is missing in '{ROOT}'"),
        (f"{ROOT}: {{version: five}}", "'version' in .* is str 'five', and should be a whole number"),
        (f"{ROOT}: {{version: 77}}", "has version 77; versions 1 to 9 are known"),
    ],
)
def test_text_that_is_no_metadata_is_told_by_what_is_wrong(tmp_path: Path, text: str, error: str) -> None:
    (tmp_path / "metadata.yaml").write_text(text)
    with pytest.raises(BagError, match=error):
        BagReader(str(tmp_path))


@pytest.mark.parametrize(
    ("edit", "error"),
    [
        (lambda root: root.pop("storage_identifier"), "'storage_identifier' is missing"),
        (lambda root: root.update(message_count=2**80), "'message_count' .* 64 bits"),
        (lambda root: root.update(duration=None), "'duration' is NoneType None, and should be keys with values"),
        (lambda root: root.update(relative_file_paths=[1]), r"'relative_file_paths' .* should be a list of texts"),
        (lambda root: root.update(topics_with_message_count={}), "'topics_with_message_count' .* should be a list"),
        (lambda root: root["topics_with_message_count"][0].pop("topic_metadata"), "'topic_metadata' is missing in"),
        (lambda root: root.update(storage_identifier="tape"), "there is no storage 'tape'"),
        (lambda root: root.update(compression_mode="FILE", compression_format="lz9"), "no compression format 'lz9'"),
        (lambda root: root.update(compression_mode="SOMETIMES"), "no compression mode 'sometimes'"),
        (lambda root: root.update(relative_file_paths=["gone.db3"]), "the file '.*gone.db3' of the bag is not there"),
    ],
)
def test_keys_that_are_wrong_are_named(make: Make, edit: Callable[[dict[str, Any]], Any], error: str) -> None:
    bag = change(make("talk", 2), edit)
    with pytest.raises(BagError, match=error):
        all_of(bag)


@pytest.mark.parametrize("path", ["../secret.db3", "/etc/passwd", "a/../../secret.db3", "..\\secret.db3", "C:/secret", ""])
def test_files_outside_of_the_folder_are_not_opened(make: Make, path: str) -> None:
    bag = change(make("talk", 2), lambda root: root.update(relative_file_paths=[path]))
    shutil.copy(bag / "talk_0.db3", bag.parent / "secret.db3")
    with pytest.raises(BagError, match="is outside of the bag's folder: it is not opened"):
        all_of(bag)


def test_a_folder_without_metadata_names_the_cure(make: Make) -> None:
    bag = make("talk", 1)
    (bag / "metadata.yaml").unlink()
    cure = rf"'ros2 bag reindex {re.escape(str(bag))}' makes one"
    with pytest.raises(BagError, match=rf"there is no metadata.yaml in .*{cure}"):
        BagReader(str(bag))
    with pytest.raises(BagError, match="there is no bag"):
        BagReader(str(bag / "nowhere"))
    (bag / "talk_0.db3").unlink()
    with pytest.raises(BagError, match="No storage files found for reindexing"):
        reindex(bag)


VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8) | st.sampled_from(["cdr", "zstd", "mcap"]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=8,
)
KEYS = (
    "version", "storage_identifier", "duration", "starting_time",
    "message_count", "topics_with_message_count", "compression_format", "compression_mode",
    "relative_file_paths", "files", "custom_data", "ros_distro",
)


@given(st.dictionaries(st.sampled_from(KEYS), VALUES), st.integers(1, 9))
def test_any_values_under_the_keys_are_taken_or_refused(values: dict[str, Any], version: int) -> None:
    topic = {"topic_metadata": {"name": "/a", "type": "t", "serialization_format": "cdr"}, "message_count": 1}
    sound = {
        "version": version,
        "storage_identifier": "sqlite3",
        "duration": {"nanoseconds": 1},
        "starting_time": {"nanoseconds_since_epoch": 1},
        "message_count": 1,
        "topics_with_message_count": [topic],
        "relative_file_paths": ["a.db3"],
    }
    try:
        facts = metadata_file.parse(yaml.safe_dump({ROOT: sound | values}), "it")
    except BagError as error:
        assert str(error).startswith("it")
    else:
        assert all(".." not in Path(name).parts for name in facts.relative_file_paths)


@given(st.text())
def test_any_text_is_metadata_or_refused(text: str) -> None:
    for given_text in (text, f"{ROOT}:\n  {text}"):
        with pytest.raises(BagError, match="^it"):
            metadata_file.parse(given_text, "it")


@pytest.mark.parametrize("storage_id", ["sqlite3", "mcap"])
@pytest.mark.parametrize("keep", [0.0, 0.01, 0.3, 0.7, 0.95])
def test_a_file_that_ends_too_early_is_refused_or_read_so_far(make: Make, storage_id: str, keep: float) -> None:
    bag = make("talk", 400, storage_id=storage_id)
    (file,) = [path for path in bag.iterdir() if path.suffix != ".yaml"]
    whole = all_of(bag)
    data = file.read_bytes()
    file.write_bytes(data[: int(len(data) * keep)])
    try:
        assert all_of(bag) == whole[: len(all_of(bag))]
    except BagError as error:
        assert str(file) in str(error)


@pytest.mark.parametrize("storage_id", ["sqlite3", "mcap"])
@given(data=st.data())
def test_bytes_that_were_changed_never_raise_anything_else(tmp_path_factory: Any, storage_id: str, data: Any) -> None:
    folder = tmp_path_factory.mktemp("changed")
    file = folder / f"x_0{compression_suffix(storage_id)}"
    raw = bytearray(SOUND[storage_id])
    for place, value in data.draw(st.lists(st.tuples(st.integers(0, len(raw) - 1), st.integers(0, 255)), max_size=20)):
        raw[place] = value
    file.write_bytes(raw)
    try:
        all_of(file)
    except BagError as error:
        assert "x_0" in str(error) or "storage" in str(error)
        assert not is_open(file)
    finally:
        shutil.rmtree(folder)


def is_open(file: Path) -> bool:
    """Whether this process still has a file open; of one that has, Windows does not remove the folder."""
    if ON_WINDOWS:
        return False
    held = [path for path in Path("/proc/self/fd").glob("*") if os.path.realpath(path) == os.path.realpath(file)]
    return bool(held)


def compression_suffix(storage_id: str) -> str:
    """The end of the name of a storage's files."""
    return {"sqlite3": ".db3", "mcap": ".mcap"}[storage_id]


SOUND: dict[str, bytes] = {}


@pytest.fixture(autouse=True, scope="module")
def sound(tmp_path_factory: Any) -> None:
    """Files whose bytes are then changed."""
    from coursekit.bag.storage import Message
    from coursekit.bag.writer import BagWriter, WriteSettings
    from tests.bag.made import CHATTER, text_bytes

    for storage_id in ("sqlite3", "mcap"):
        folder = tmp_path_factory.mktemp("sound") / "bag"
        writer = BagWriter(WriteSettings(str(folder), storage_id))
        writer.create_topic(CHATTER)
        for number in range(5):
            writer.write(Message("/chatter", text_bytes("x"), number))
        writer.close()
        SOUND[storage_id] = (folder / f"bag_0{compression_suffix(storage_id)}").read_bytes()


@pytest.mark.parametrize("name", ["x.db3", "x.mcap"])
def test_files_that_are_something_else_are_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_bytes(b"hello" * 100)
    with pytest.raises(BagError, match=f"{name}' cannot be read as an? "):
        all_of(tmp_path / name)
    with sqlite3.connect(tmp_path / "other.db3") as db:
        db.execute("CREATE TABLE birds(name)")
    with pytest.raises(BagError, match="not of a bag: it has no tables topics and messages"):
        all_of(tmp_path / "other.db3")
    older = tmp_path / "x.bag"
    older.write_bytes(b"#ROSBAG V2.0")
    with pytest.raises(BagError, match="is a bag of ROS 1: .*rosbags-convert --src"):
        BagReader(str(older))
    with pytest.raises(BagError, match="ends neither in .db3 nor in .mcap"):
        BagReader(__file__)


def test_a_view_without_end_is_not_taken_for_the_messages(tmp_path: Path) -> None:
    endless = "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT x AS id, 1 AS topic_id, x AS timestamp"
    with sqlite3.connect(tmp_path / "trap.db3") as db:
        db.execute("CREATE TABLE topics(id, name, type, serialization_format)")
        db.execute(f"CREATE VIEW messages AS {endless}, x'00' AS data FROM n")
    with pytest.raises(BagError, match="it has no tables topics and messages"):
        all_of(tmp_path / "trap.db3")


@pytest.mark.parametrize(
    ("change_it", "error"),
    [
        ("UPDATE messages SET data = 'text'", "a message of /chatter is str, and should be bytes"),
        ("UPDATE messages SET timestamp = 'noon'", "the time of a message is 'noon', and should be whole nanoseconds"),
        ("ALTER TABLE messages DROP COLUMN data", "no such column: data"),
        ("DROP TABLE topics; CREATE TABLE topics(id)", "no such column: topics.name"),
    ],
)
def test_columns_with_other_values_are_refused(make: Make, change_it: str, error: str) -> None:
    bag = make("talk", 2)
    with sqlite3.connect(bag / "talk_0.db3") as db:
        db.executescript(change_it)
    with pytest.raises(BagError, match=error):
        all_of(bag)


def test_a_small_message_that_stands_for_a_large_one_is_not_unpacked() -> None:
    bomb = compression.compress(bytes(10_000_000))
    assert len(bomb) < 2000
    assert len(compression.decompress(bomb)) == 10_000_000
    with pytest.raises(BagError, match="has more than 1000000 bytes: it is not unpacked"):
        compression.decompress(bomb, limit=1_000_000)
    with pytest.raises(BagError, match="cannot be unpacked with zstd"):
        compression.decompress(b"no zstd at all")


def test_a_packed_file_that_does_not_fit_is_not_unpacked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "x.db3").write_bytes(bytes(5_000_000))
    packed = compression.compress_file(tmp_path / "x.db3")
    monkeypatch.setattr(compression, "LARGEST_FILE", 1_000_000)
    with pytest.raises(BagError, match="has more than 1000000 bytes when unpacked: there is no room for it"):
        all_of(packed)
    packed.write_bytes(b"no zstd at all")
    with pytest.raises(BagError, match="cannot be unpacked with zstd"):
        all_of(packed)


def test_a_chunk_that_announces_too_much_is_not_unpacked(make: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    bag = make("talk", 300, storage_id="mcap", preset="zstd_small")
    monkeypatch.setattr(mcap_reader, "LARGEST_CHUNK", 4000)
    with pytest.raises(BagError, match="a chunk has .* bytes, more than 4000: it is not unpacked"):
        all_of(bag)


def test_an_lz4_chunk_that_lies_about_its_size_is_not_unpacked() -> None:
    chunk = Chunk("lz4", lz4.frame.compress(bytes(10_000_000)), 0, 0, 0, 100)
    assert len(chunk.data) < 100_000
    with pytest.raises(ValueError, match="a chunk of 100 bytes has 101"):
        mcap_reader._without_lz4(chunk)


def test_a_chunk_that_lies_about_its_size_is_not_unpacked(make: Make) -> None:
    bag = make("talk", 300, storage_id="mcap", preset="zstd_small")
    (file,) = bag.glob("*.mcap")
    data = file.read_bytes()
    start = data.index(b"\x04\x00\x00\x00zstd") + 8
    (size,) = struct.unpack_from("<Q", data, start)
    bomb = zstandard.ZstdCompressor().compress(bytes(3 << 30 >> 1))
    frame = bomb[:size].ljust(size, b"\0")
    file.write_bytes(data[: start + 8] + frame + data[start + 8 + size :])
    with pytest.raises(BagError, match="it is not unpacked"):
        all_of(bag)
