"""A compiled program's requests to rosbag2, carried out by rosbag2_py."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from rosbag2_py import (
    CompressionOptions,
    ConverterOptions,
    SequentialCompressionWriter,
    SequentialReader,
    SequentialWriter,
    StorageFilter,
    StorageOptions,
    TopicMetadata,
    compression_mode_from_string,
)
from rosbag2_py._reader import say_opened as say_read
from rosbag2_py._writer import say_opened as say_written

from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


def do_bag_writer(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a writer; a compressing one if a format is given."""
    form, mode = frame.text(), compression_mode_from_string(frame.text())
    return packed(host.keep(SequentialCompressionWriter(CompressionOptions(form, mode)) if form else SequentialWriter()))


def do_bag_reader(host: Host, _channel: Channel, _frame: Unpacker) -> bytes:
    """Make a reader."""
    return packed(host.keep(SequentialReader()))


def _bag(host: Host, frame: Unpacker) -> Any:
    return host.things[frame.integer()]


def do_bag_open(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Open a bag for writing or reading."""
    bag, uri, folder = _bag(host, frame), frame.text(), host.process.cwd
    options = StorageOptions(
        uri=os.path.join(folder, uri),  # the requesting thread may be in another folder
        storage_id=frame.text(),
        max_bagfile_size=frame.integer(),
        max_bagfile_duration=frame.integer(),
        max_cache_size=frame.integer(),
        storage_preset_profile=frame.text(),
        storage_config_uri=frame.text(),
        snapshot_mode=bool(frame.integer()),
    )
    hidden = "" if os.path.isabs(uri) else os.path.join(folder, "")
    say = say_written if isinstance(bag, SequentialWriter) else say_read
    bag._say_opened = lambda path: say(path.removeprefix(hidden))
    try:
        bag.open(options, ConverterOptions(frame.text(), frame.text()))
    except RuntimeError as error:
        raise RuntimeError(str(error).replace(hidden, "") if hidden else str(error)) from None


def do_bag_close(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Close a bag; does nothing if it is closed."""
    _bag(host, frame).close()


def _topic(frame: Unpacker) -> TopicMetadata:
    return TopicMetadata(frame.text(), frame.text(), frame.text(), frame.text())


def do_bag_create_topic(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Add a topic."""
    _bag(host, frame).create_topic(_topic(frame))


def do_bag_remove_topic(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Remove a topic."""
    _bag(host, frame).remove_topic(_topic(frame))


def do_bag_snapshot(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Write the snapshot buffer."""
    return packed(int(_bag(host, frame).take_snapshot()))


def do_bag_write(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Add a message."""
    _bag(host, frame).write(frame.text(), frame.blob(), frame.integer())


def do_bag_has_next(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a message is left."""
    return packed(int(_bag(host, frame).has_next()))


def do_bag_read_next(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the next message: its topic, data and reception time."""
    return packed(*_bag(host, frame).read_next())


def do_bag_filter(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Read only some topics."""
    bag, expression, hidden = _bag(host, frame), frame.text(), frame.text()
    bag.set_filter(StorageFilter([frame.text() for _ in range(frame.integer())], expression, hidden))


def do_bag_seek(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Continue at a time."""
    _bag(host, frame).seek(frame.integer())


def do_bag_facts(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return a bag's metadata."""
    facts = _bag(host, frame).get_metadata()
    start, size = facts.starting_time_ns, facts.bag_size
    parts = [packed(facts.version, size, facts.storage_identifier, facts.duration_ns, start, facts.message_count)]
    parts.append(packed(facts.compression_format, facts.compression_mode))
    parts.append(packed(len(facts.relative_file_paths), *facts.relative_file_paths, len(facts.files)))
    parts += [packed(file.path, file.starting_time_ns, file.duration_ns, file.message_count) for file in facts.files]
    parts.append(packed(len(facts.topics_with_message_count)))
    for counted in facts.topics_with_message_count:
        topic = counted.topic_metadata
        texts = (topic.name, topic.type, topic.serialization_format, topic.offered_qos_profiles)
        parts.append(packed(*texts, counted.message_count))
    return b"".join(parts)
