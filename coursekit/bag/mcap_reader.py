"""Messages of an mcap file. The mcap library parses the records; the decompressed size is limited here."""

from __future__ import annotations

import heapq
import io
import struct
from collections.abc import Iterator
from dataclasses import replace
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
            if isinstance(record, Chunk):
                summary.chunk_indexes.append(self._index_of(record))
            for part in self._unpack(record) if isinstance(record, Chunk) else (record,):
                if isinstance(part, Schema):
                    summary.schemas[part.id] = part
                elif isinstance(part, Channel):
                    summary.channels[part.id] = part
        return summary

    def _index_of(self, chunk: Chunk) -> ChunkIndex:
        """Return the index of the chunk that ends at the current position of the file."""
        length = 40 + len(chunk.compression) + len(chunk.data)
        begin = self._file.tell() - length - 9
        packed, first, last = len(chunk.data), chunk.message_start_time, chunk.message_end_time
        return ChunkIndex(length + 9, begin, chunk.compression, packed, last, 0, {}, first, chunk.uncompressed_size)

    def _starts_otherwise(self) -> bool:
        self._file.seek(0)
        return self._file.read(8) != b"\x89MCAP0\r\n"

    def _scan(self) -> Iterator[Any]:
        """Yield all records in file order, chunks whole, as far as the file is readable: its end may be missing."""
        self._file.seek(0)
        try:
            yield from StreamReader(self._file, emit_chunks=True, record_size_limit=LARGEST_CHUNK).records
        except (McapError, struct.error, EOFError):
            return
        except _TROUBLES as error:
            raise self._broken(error) from None

    def _unpack(self, chunk: Chunk) -> list[Any]:
        size = max(len(chunk.data), chunk.uncompressed_size, _announced(chunk))
        if size > LARGEST_CHUNK:
            raise BagError(f"'{self._path}': a chunk has {size} bytes, more than {LARGEST_CHUNK}: it is not unpacked")
        try:
            return breakup_chunk(_without_lz4(chunk), validate_crc=True)
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
            yield from self._without_chunks(start_ns)
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

    def _without_chunks(self, start_ns: int) -> Iterator[Record]:
        """Yield the messages outside of chunks; until it is their turn, only their places are kept."""
        found = [
            (record.log_time, self._file.tell(), len(record.data), record.channel_id)
            for record in self._scan()
            if isinstance(record, Record) and record.log_time >= start_ns
        ]
        for stamp, end, size, channel in sorted(found):
            self._file.seek(end - size)
            yield Record(channel, stamp, self._file.read(size), stamp, 0)

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
    return 0


def _without_lz4(chunk: Chunk) -> Chunk:
    """Return the chunk with lz4's data decompressed, which the library would do without a limit."""
    if chunk.compression != "lz4":
        return chunk
    from lz4.frame import LZ4FrameDecompressor

    data = LZ4FrameDecompressor().decompress(chunk.data, max_length=chunk.uncompressed_size + 1)
    if len(data) != chunk.uncompressed_size:
        raise ValueError(f"a chunk of {chunk.uncompressed_size} bytes has {len(data)}")
    return replace(chunk, compression="", data=data)
