"""Writes a bag: a folder with message files, possibly split, and metadata.yaml."""

from __future__ import annotations

import shutil
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from coursekit.bag import compression, metadata_file
from coursekit.bag.errors import BagError
from coursekit.bag.metadata import BagFacts, FileFacts, TopicInformation, TopicMetadata
from coursekit.bag.opening import open_writer
from coursekit.bag.storage import DEFAULT_STORAGE_ID, SUFFIXES, FileWriter, Message, check_storage_id

SMALLEST_SPLIT = {"sqlite3": 86016, "mcap": 1024}
"""Minimum for the maximum file size, by storage id [bytes]."""


@dataclass
class WriteSettings:
    """The settings of a new bag; sizes in bytes, 0 for 'no limit'."""

    uri: str
    storage_id: str = ""
    max_file_size: int = 0
    max_file_seconds: float = 0
    max_cache_size: int = 0
    preset: str = ""
    config: str = ""
    snapshot_mode: bool = False
    compression_mode: str = ""
    compression_format: str = ""
    on_split: Callable[[str, str], None] = field(default=lambda closed, opened: None)
    on_open: Callable[[str], None] = field(default=lambda path: None)


class BagWriter:
    """A bag being written. Raises BagError when its folder exists already, or a setting is invalid."""

    def __init__(self, settings: WriteSettings) -> None:
        self.settings = settings
        self._storage_id = check_storage_id(settings.storage_id or DEFAULT_STORAGE_ID)
        self._mode = settings.compression_mode.upper().replace("NONE", "")
        self._check()
        self.folder = Path(settings.uri)
        try:
            self.folder.mkdir(parents=True)
        except FileExistsError:
            raise BagError(f"Bag directory already exists ({self.folder}), can't overwrite existing bag") from None
        except OSError as error:
            raise BagError(f"Failed to create database directory ({self.folder}): {error}") from None
        self._topics: dict[str, TopicInformation] = {}
        self._facts = BagFacts(
            storage_identifier=self._storage_id,
            compression_mode=self._mode,
            compression_format=settings.compression_format if self._mode else "",
        )
        self._snapshot: deque[Message] = deque()
        self._snapshot_size = 0
        try:
            self._open_file()
        except BaseException:
            shutil.rmtree(self.folder, ignore_errors=True)  # created above, and useless now
            raise

    def _check(self) -> None:
        settings = self.settings
        compression.check(self._mode, settings.compression_format)
        smallest = SMALLEST_SPLIT[self._storage_id]
        if 0 < settings.max_file_size < smallest:
            raise BagError(
                f"Invalid bag splitting size given. Please provide a value greater than {smallest}. "
                f"Specified value of {settings.max_file_size}"
            )
        if settings.snapshot_mode and not settings.max_cache_size:
            raise BagError("Max cache size must be greater than 0 when snapshot mode is enabled")
        if self._mode == "MESSAGE" and self._storage_id == "mcap":
            raise BagError("mcap files pack whole chunks: use compression: 'Zstd' in a storage config file")

    def _open_file(self) -> None:
        name = f"{self.folder.resolve().name}_{len(self._facts.files)}{SUFFIXES[self._storage_id]}"
        self._path = self.folder / name
        self._file: FileWriter | None = open_writer(
            self._path, self._storage_id, self.settings.preset, self.settings.config
        )
        self.settings.on_open(str(self._path))
        for topic in self._topics.values():
            self._file.create_topic(topic.topic_metadata)
        self._facts.files.append(FileFacts(name))
        self._facts.relative_file_paths.append(name)

    # -- topics

    def create_topic(self, topic: TopicMetadata) -> None:
        """Register a topic; harmless when it is registered already."""
        if topic.name not in self._topics:
            self._topics[topic.name] = TopicInformation(topic, 0)
            self._opened().create_topic(topic)

    def remove_topic(self, topic: TopicMetadata) -> None:
        """Remove a registered topic."""
        if self._topics.pop(topic.name, None) is not None:
            self._opened().remove_topic(topic)

    # -- messages

    def write(self, message: Message) -> None:
        """Add a message; BagError when its topic is not registered, the bag is closed, or the disk is full.

        >>> import tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     bag = BagWriter(WriteSettings(f"{folder}/walk"))
        ...     bag.create_topic(TopicMetadata("/chatter", "std_msgs/msg/String"))
        ...     bag.write(Message("/chatter", b"bytes in CDR", 5))
        ...     bag.close()
        ...     metadata_file.read(bag.folder).message_count
        1
        """
        if message.topic not in self._topics:
            raise BagError(f"Failed to write on topic '{message.topic}'. Call create_topic() before first write.")
        self._opened()
        if self.settings.snapshot_mode:
            self._remember(message)
        else:
            self._store(message)

    def _remember(self, message: Message) -> None:
        self._snapshot.append(message)
        self._snapshot_size += len(message.data)
        while self._snapshot_size > self.settings.max_cache_size:
            self._snapshot_size -= len(self._snapshot.popleft().data)

    def take_snapshot(self) -> bool:
        """In snapshot mode, write the buffered messages and clear the buffer; return whether this is snapshot mode.

        >>> import tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     bag = BagWriter(WriteSettings(f"{folder}/walk", snapshot_mode=True, max_cache_size=30))
        ...     bag.create_topic(TopicMetadata("/chatter", "std_msgs/msg/String"))
        ...     for stamp in range(9):
        ...         bag.write(Message("/chatter", b"ten bytes!", stamp))
        ...     _ = bag.take_snapshot()
        ...     bag.close()
        ...     facts = metadata_file.read(bag.folder)
        >>> facts.message_count, facts.starting_time_ns
        (3, 6)
        """
        if not self.settings.snapshot_mode:
            return False
        for message in self._snapshot:
            self._store(message)
        self._snapshot.clear()
        self._snapshot_size = 0
        return True

    def _store(self, message: Message) -> None:
        if self._is_full(message.stamp):
            self.split()
        data = compression.compress(message.data) if self._mode == "MESSAGE" else message.data
        self._opened().write(message._replace(data=data))
        self._facts.files[-1].include(message.stamp)
        self._topics[message.topic].message_count += 1

    def _is_full(self, stamp: int) -> bool:
        settings, file = self.settings, self._facts.files[-1]
        if not file.message_count:
            return False
        if settings.max_file_size and self._opened().size() > settings.max_file_size:
            return True
        return bool(settings.max_file_seconds) and stamp - file.starting_time_ns > settings.max_file_seconds * 1e9

    def split(self) -> None:
        """Finish the current file and continue in a new one."""
        closed = self._close_file()
        self._open_file()
        self.settings.on_split(str(closed), str(self._path))

    # -- the end

    def _opened(self) -> FileWriter:
        if self._file is None:
            raise BagError(f"the bag '{self.folder}' is closed: nothing can be written any more")
        return self._file

    def _close_file(self) -> Path:
        self._update()
        self._opened().close(self._facts)
        self._file = None
        if self._mode == "FILE":
            self._path = compression.compress_file(self._path)
            self._facts.files[-1].path = self._facts.relative_file_paths[-1] = self._path.name
        return self._path

    def _update(self) -> None:
        self._facts.topics_with_message_count = list(self._topics.values())
        self._facts.sum_up()

    def close(self) -> None:
        """Finish the bag and write its metadata.yaml; harmless when it is closed."""
        if self._file is not None:
            self._close_file()
            metadata_file.write(self.folder, self._facts)

    def abandon(self) -> None:
        """Close a bag that can no longer be written: its files can still be reindexed."""
        if self._file is not None:
            self._file.abandon()
            self._file = None
