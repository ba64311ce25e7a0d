"""Messages in an mcap file, written with the mcap library."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from mcap.writer import CompressionType, Writer

from coursekit.bag import metadata_file
from coursekit.bag.definitions import full_definition
from coursekit.bag.errors import BagError
from coursekit.bag.metadata import BagFacts, TopicMetadata
from coursekit.bag.storage import Message

_PRESETS: dict[str, dict[str, Any]] = {
    "": {},
    "none": {},
    "fastwrite": {"use_chunking": False, "enable_crcs": False},
    "zstd_fast": {"compression": CompressionType.ZSTD, "enable_crcs": False},
    "zstd_small": {"compression": CompressionType.ZSTD, "chunk_size": 4 * 2**20},
}
_COMPRESSIONS = {"None": CompressionType.NONE, "Lz4": CompressionType.LZ4, "Zstd": CompressionType.ZSTD}


class McapWriter:
    """A new file."""

    def __init__(self, path: Path, preset: str = "", config: str = "") -> None:
        if preset not in _PRESETS:
            known = ", ".join(name for name in _PRESETS if name)
            raise BagError(f"mcap has no preset '{preset}'; it has {known}")
        options = {"compression": CompressionType.NONE, **_PRESETS[preset], **_configured(config)}
        self._path = path
        with self._telling():
            self._file = path.open("xb")
            self._writer = Writer(self._file, **options)
            self._writer.start(profile="ros2", library="coursekit")
        self._schemas: dict[str, int] = {}
        self._channels: dict[str, int] = {}
        self._sequence: dict[str, int] = {}

    def create_topic(self, topic: TopicMetadata) -> None:
        """Register a topic."""
        if topic.type not in self._schemas:
            text = full_definition(topic.type)
            encoding = "ros2msg" if text else ""
            self._schemas[topic.type] = self._writer.register_schema(topic.type, encoding, text.encode())
        self._channels[topic.name] = self._writer.register_channel(
            topic.name,
            topic.serialization_format,
            self._schemas[topic.type],
            {"offered_qos_profiles": topic.offered_qos_profiles},
        )
        self._sequence[topic.name] = 0

    def remove_topic(self, topic: TopicMetadata) -> None:
        """Forget a topic; its messages already in the file remain."""
        del self._channels[topic.name]

    def write(self, message: Message) -> None:
        """Add a message of a registered topic."""
        number = self._sequence[message.topic] = self._sequence[message.topic] + 1
        channel = self._channels[message.topic]
        with self._telling():
            self._writer.add_message(channel, message.stamp, message.data, message.stamp, number & 0xFFFFFFFF)

    def size(self) -> int:
        """Return the bytes written so far; the current chunk is not included."""
        return self._file.tell()

    def close(self, facts: BagFacts) -> None:
        """Finish the file; it contains a copy of the bag's metadata."""
        text = metadata_file.dump(metadata_file.as_dict(facts))
        with self._telling():
            self._writer.add_metadata("rosbag2", {"serialized_metadata": text})
            self._writer.finish()
            self._file.close()

    def abandon(self) -> None:
        """Close the file as it is."""
        with contextlib.suppress(OSError):
            self._file.close()

    @contextlib.contextmanager
    def _telling(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            raise BagError(f"'{self._path}' cannot be written: {error.strerror or error}") from None


def _configured(config: str) -> dict[str, Any]:
    """Read the settings of a configuration file: compression, chunkSize, noChunking, noChunkCRC."""
    if not config:
        return {}
    loaded = metadata_file.load_settings(Path(config)) or {}
    if not isinstance(loaded, dict):
        raise BagError(f"{config} should be keys with values, for example: compression: Zstd")
    options: dict[str, Any] = {}
    for key, value in loaded.items():
        if key == "compression" and value in _COMPRESSIONS:
            options["compression"] = _COMPRESSIONS[value]
        elif key == "chunkSize" and isinstance(value, int) and value > 0:
            options["chunk_size"] = value
        elif key == "noChunking" and isinstance(value, bool):
            options["use_chunking"] = not value
        elif key == "noChunkCRC" and isinstance(value, bool):
            options["enable_crcs"] = not value
        else:
            raise BagError(f"{config}: '{key}: {value}' is no setting of mcap files that is known here")
    return options
