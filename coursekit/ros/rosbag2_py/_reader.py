"""Readers of bags. In ROS 2: rosbag2_py._reader."""

from __future__ import annotations

import re
from typing import Any

from rclpy.logging import get_logger

from coursekit.bag.errors import BagError
from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.reader import BagReader
from coursekit.bag.storage import SUFFIXES, Message
from rosbag2_py._storage import BagMetadata, ConverterOptions, StorageFilter, StorageOptions


def get_registered_readers() -> set[str]:
    """The storages that can be read."""
    return set(SUFFIXES)


def say_opened(path: str) -> None:
    """Log that a file is opened for reading; mcap files have no log line."""
    if path.endswith(SUFFIXES["sqlite3"]):
        get_logger("rosbag2_storage").info(f"Opened database '{path}' for READ_ONLY.")


class SequentialReader:
    """Reads a bag's messages, oldest first, also from compressed bags. Raises RuntimeError if the bag cannot be read."""

    def __init__(self) -> None:
        self._say_opened = say_opened
        self._bag: BagReader | None = None

    def open(self, storage_options: StorageOptions, converter_options: ConverterOptions | None = None) -> None:
        """Open a bag by its folder or one of its files."""
        wanted = converter_options.output_serialization_format if converter_options else ""
        if wanted not in ("", "cdr"):
            raise RuntimeError(f"Could not find converter for format {wanted}: there is only 'cdr'")
        self.close()
        bag = BagReader(storage_options.uri, storage_options.storage_id, self._say_opened)
        try:
            bag.check_files()
            if not bag.topics():
                get_logger("rosbag2_cpp").warning("No topics were listed in metadata.")
        except BagError:
            bag.close()
            raise
        self._bag = bag
        self._filter: list[str] | None = None

    def open_uri(self, uri: str) -> None:
        """Open a bag by its path alone (ROS releases after Humble)."""
        self.open(StorageOptions(uri=uri))

    def _opened(self) -> BagReader:
        if self._bag is None:
            raise RuntimeError("Bag is not open. Call open() before reading.")
        return self._bag

    def has_next(self) -> bool:
        """Whether a message is left."""
        return self._opened().peek() is not None

    def peek(self) -> Message | None:
        """The message that `read_next` would return; None at the end."""
        return self._opened().peek()

    def read_next(self) -> tuple[str, bytes, int]:
        """Take the next message: its topic, its bytes, and its time of reception (ns since 1970)."""
        message = self._opened().take()
        if message is None:
            raise RuntimeError("Bag is at end. No next message.")
        return tuple(message)  # type: ignore[return-value]

    def get_metadata(self) -> BagMetadata:
        """The bag's metadata."""
        return BagMetadata.of(self._opened().facts)

    def get_all_topics_and_types(self) -> list[TopicMetadata]:
        """The recorded topics."""
        return self._opened().topics()

    def set_filter(self, storage_filter: StorageFilter) -> None:
        """Read only these topics from now on."""
        bag = self._opened()
        self._filter = _chosen(storage_filter, [topic.name for topic in bag.topics()])
        bag.choose(self._filter)

    def reset_filter(self) -> None:
        """Read all topics from now on."""
        self.set_filter(StorageFilter())

    def set_read_order(self, order: Any) -> bool:
        """Whether this order is supported (ROS releases after Humble): only by reception, oldest first."""
        return not order.reverse and int(order.sort_by) == 0

    def seek(self, timestamp: int) -> None:
        """Continue with the first message at or after a time (ns since 1970)."""
        self._opened().rewind(timestamp, self._filter)

    def close(self) -> None:
        """Close the bag's files."""
        if self._bag is not None:
            self._bag.close()
            self._bag = None


class SequentialCompressionReader(SequentialReader):
    """The same as SequentialReader: the metadata states whether a bag is compressed."""


def _chosen(storage_filter: StorageFilter, names: list[str]) -> list[str] | None:
    expression, hidden = storage_filter.topics_regex, storage_filter.topics_regex_to_exclude
    if not (storage_filter.topics or expression or hidden):
        return None
    some = storage_filter.topics or expression
    matching = [name for name in names if name in storage_filter.topics or (expression and re.search(expression, name))]
    return [name for name in (matching if some else names) if not (hidden and re.search(hidden, name))]
