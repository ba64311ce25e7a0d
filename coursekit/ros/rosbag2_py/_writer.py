"""Writers of bags. In ROS 2: rosbag2_py._writer."""

from __future__ import annotations

import weakref
from dataclasses import replace
from typing import Any

from rclpy.logging import get_logger

from coursekit.bag import compression
from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.storage import SUFFIXES, Message
from coursekit.bag.writer import BagWriter, WriteSettings
from coursekit.processes.process import current_process
from rosbag2_py._compression_options import CompressionOptions
from rosbag2_py._storage import ConverterOptions, StorageOptions


def get_registered_writers() -> set[str]:
    """The storages that can be written."""
    return set(SUFFIXES)


def get_registered_compressors() -> set[str]:
    """The formats of compression."""
    return {compression.FORMAT}


def get_registered_serializers() -> set[str]:
    """The serializations that can be written."""
    return {"cdr_converter"}


def say_opened(path: str) -> None:
    """Log that a file is opened for writing; mcap files have no log line."""
    if path.endswith(SUFFIXES["sqlite3"]):
        get_logger("rosbag2_storage").info(f"Opened database '{path}' for READ_WRITE.")


def settings_of(options: StorageOptions, packing: CompressionOptions | None = None) -> WriteSettings:
    """Convert ROS's options to the settings of a bag."""
    packing = packing or CompressionOptions()
    return WriteSettings(
        uri=options.uri,
        storage_id=options.storage_id,
        max_file_size=options.max_bagfile_size,
        max_file_seconds=options.max_bagfile_duration,
        max_cache_size=options.max_cache_size,
        preset=options.storage_preset_profile,
        config=options.storage_config_uri,
        snapshot_mode=options.snapshot_mode,
        compression_mode=packing.compression_mode.name,
        compression_format=packing.compression_format,
        on_open=say_opened,
    )


class SequentialWriter:
    """Writes a bag until `close()`, or until the writer or its program ends. Raises RuntimeError on failure."""

    _compression: CompressionOptions | None = None

    def __init__(self) -> None:
        self._say_opened = say_opened
        self._bag: BagWriter | None = None
        self._end: Any = None

    def open(self, storage_options: StorageOptions, converter_options: ConverterOptions | None = None) -> None:
        """Create the bag's folder and its first file."""
        wanted = converter_options.output_serialization_format if converter_options else ""
        if wanted not in ("", "cdr"):
            raise RuntimeError(f"Could not find converter for format {wanted}: there is only 'cdr'")
        self.close()
        settings = replace(settings_of(storage_options, self._compression), on_open=self._say_opened)
        self._bag = BagWriter(settings)
        self._end = weakref.finalize(self, self._bag.close)
        process = current_process()
        if process is not None:
            process.cleanups.append(self._end)

    def _opened(self) -> BagWriter:
        if self._bag is None:
            raise RuntimeError("Bag is not open. Call open() before writing.")
        return self._bag

    def create_topic(self, topic_with_type: TopicMetadata) -> None:
        """Register a topic; do this before its first message."""
        self._opened().create_topic(topic_with_type)

    def remove_topic(self, topic_with_type: TopicMetadata) -> None:
        """Remove a registered topic."""
        self._opened().remove_topic(topic_with_type)

    def write(self, topic_name: str, message: bytes, timestamp: int) -> None:
        """Add a message: its topic, its bytes (`rclpy.serialization.serialize_message`), and a time (ns since 1970)."""
        if not isinstance(message, bytes):
            kind = type(message).__name__
            raise TypeError(f"write() takes the bytes of a message, not {kind}: write serialize_message(...) around it")
        self._opened().write(Message(topic_name, message, int(timestamp)))

    def split_bagfile(self) -> None:
        """Continue in a new file."""
        self._opened().split()

    def take_snapshot(self) -> bool:
        """In snapshot mode: write the buffered messages."""
        return self._opened().take_snapshot()

    def close(self) -> None:
        """Finish the bag; no effect if it is finished already."""
        if self._bag is not None:
            self._end()
            self._bag = None


class SequentialCompressionWriter(SequentialWriter):
    """Writes a compressed bag."""

    def __init__(self, compression_options: CompressionOptions | None = None) -> None:
        super().__init__()
        self._compression = compression_options or CompressionOptions()
