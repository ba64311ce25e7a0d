"""Messages of an mcap file. The mcap library parses the records; the decompressed size is limited here."""

from __future__ import annotations

import heapq
import io
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from mcap.data_stream import ReadDataStream
from mcap.exceptions import McapError
from mcap.reader import make_reader
from mcap.records import Channel, Chunk, ChunkIndex, Schema
from mcap.records import Message as Record
from mcap.stream_reader import StreamReader, breakup_chunk
from mcap.summary import Summary

from coursekit.bag.errors import BagError
from coursekit.bag.metadata import BagFacts, FileFacts, TopicInformation, TopicMetadata
from coursekit.bag.storage import Message

LARGEST_CHUNK = 1 << 30
"""Maximum size of a chunk, compressed or decompressed [bytes]."""
_TROUBLES = (McapError, struct.error, ValueError, LookupError, TypeError, OverflowError, MemoryError, OSError, EOFError)


class McapReader:
    """An existing file; BagError when it is not an mcap file, or broken."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file = path.open("rb")
        self._size = path.stat().st_size
        self._facts: BagFacts | None = None
        try:
            self._summary = self._read_summary()
            self._channels = self._summary.channels
        except BaseException:
            self._file.close()
            raise

    def _broken(self, error: Exception) -> BagError:
        text = " ".join(str(error).split()) or type(error).__name__
        return BagError(f"'{self._path}' cannot be read as an mcap file: {text}")

    def _read_summary(self) -> Summary:
        """Read the index at the file's end; if it is missing, scan the whole file."""
        try:
            summary = make_reader(self._file).get_summary()
            if summary is not None and summary.channels:
                return summary
        except _TROUBLES as error:
            if self._size < 8 or self._starts_otherwise():
                raise self._broken(error) from None
        summary = Summary()
        for record in self._scan():
            if isinstance(record, Schema):
                summary.schemas[record.id] = record
            elif isinstance(record, Channel):
                summary.channels[record.id] = record
        return summary

    def _starts_otherwise(self) -> bool:
        self._file.seek(0)
        return self._file.read(8) != b"\x89MCAP0\r\n"

    def _scan(self) -> Iterator[Any]:
        """Yield all records in file order, as far as the file is readable: an interrupted recording may lack its end."""
        self._file.seek(0)
        try:
            for record in StreamReader(self._file, emit_chunks=True, record_size_limit=LARGEST_CHUNK).records:
                yield from self._unpack(record) if isinstance(record, Chunk) else (record,)
        except (McapError, struct.error, EOFError):
            return
        except _TROUBLES as error:
            raise self._broken(error) from None

    def _unpack(self, chunk: Chunk) -> list[Any]:
        size = max(len(chunk.data), chunk.uncompressed_size, _announced(chunk))
        if size > LARGEST_CHUNK:
            raise BagError(f"'{self._path}': a chunk has {size} bytes, more than {LARGEST_CHUNK}: it is not unpacked")
        try:
            return breakup_chunk(chunk, validate_crc=True)
        except Exception as error:  # the decompressors raise their own exception types
            raise self._broken(error) from None

    def topics(self) -> list[TopicMetadata]:
        """Return the topics, in the order of their creation."""
        return [self._topic(channel) for _, channel in sorted(self._channels.items())]

    def _topic(self, channel: Channel) -> TopicMetadata:
        schema = self._summary.schemas.get(channel.schema_id)
        qos = channel.metadata.get("offered_qos_profiles", "")
        return TopicMetadata(channel.topic, schema.name if schema else "", channel.message_encoding, qos)

    def facts(self) -> BagFacts:
        """Return the facts of a bag that consists of this file."""
        name = self._path.name
        whole, counts = FileFacts(name), dict.fromkeys(self._channels, 0)
        for record in self._records(0):
            counts[record.channel_id] = counts.get(record.channel_id, 0) + 1
            whole.include(record.log_time)
        topics = [TopicInformation(self._topic(channel), counts[key]) for key, channel in sorted(self._channels.items())]
        facts = BagFacts(
            storage_identifier="mcap", topics_with_message_count=topics, relative_file_paths=[name], files=[whole]
        )
        facts.sum_up()
        return facts

    def messages(self, topics: list[str] | None, start_ns: int) -> Iterator[Message]:
        """Yield the messages of these topics (None: of all) from a time on, oldest first."""
        for record in self._records(start_ns):
            channel = self._channels.get(record.channel_id)
            if channel is not None and (topics is None or channel.topic in topics):
                yield Message(channel.topic, bytes(record.data), record.log_time)

    def _records(self, start_ns: int) -> Iterator[Record]:
        if not self._summary.chunk_indexes:
            records = [record for record in self._scan() if isinstance(record, Record) and record.log_time >= start_ns]
            yield from sorted(records, key=lambda record: record.log_time)
            return
        waiting = sorted(self._summary.chunk_indexes, key=lambda chunk: (chunk.message_start_time, chunk.chunk_start_offset))
        ready: list[tuple[int, int, int, Record]] = []
        for index in waiting:  # a chunk is read once all older messages have been yielded
            while ready and ready[0][0] < index.message_start_time:
                yield heapq.heappop(ready)[3]
            if index.message_end_time >= start_ns:
                for number, record in enumerate(self._chunk(index)):
                    if isinstance(record, Record) and record.log_time >= start_ns:
                        heapq.heappush(ready, (record.log_time, index.chunk_start_offset, number, record))
        while ready:
            yield heapq.heappop(ready)[3]

    def _chunk(self, index: ChunkIndex) -> list[Any]:
        try:
            self._file.seek(index.chunk_start_offset + 1)
            (length,) = struct.unpack("<Q", self._file.read(8))
            if length > min(self._size, LARGEST_CHUNK):
                raise ValueError(f"a chunk of {length} bytes in a file of {self._size}")
            chunk = Chunk.read(ReadDataStream(io.BytesIO(self._file.read(length))))
        except _TROUBLES as error:
            raise self._broken(error) from None
        return self._unpack(chunk)

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def _announced(chunk: Chunk) -> int:
    """Return the decompressed size declared in the compressed data."""
    if chunk.compression == "zstd":
        import zstandard

        try:
            size: int = zstandard.frame_content_size(chunk.data)
        except zstandard.ZstdError:
            return 0
        return size
    if chunk.compression == "lz4":
        return len(chunk.data) * 255  # lz4's highest compression ratio
    return 0
