"""Reads a bag: a folder with metadata.yaml, or a single file."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

from coursekit.bag import compression, metadata_file
from coursekit.bag.errors import BagError
from coursekit.bag.metadata import BagFacts, TopicMetadata
from coursekit.bag.opening import open_reader
from coursekit.bag.storage import FileReader, Message, check_storage_id, storage_id_of


class BagReader:
    """A bag's messages, oldest first, file after file. Raises BagError when it cannot be read.

    `on_open(path)` is called for each file that is opened.

    >>> from coursekit.bag.writer import BagWriter, WriteSettings
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     writer = BagWriter(WriteSettings(f"{folder}/walk"))
    ...     writer.create_topic(TopicMetadata("/chatter", "std_msgs/msg/String"))
    ...     writer.write(Message("/chatter", b"bytes in CDR", 5))
    ...     writer.close()
    ...     reader = BagReader(f"{folder}/walk")
    ...     print(reader.take(), reader.take())
    ...     reader.close()
    Message(topic='/chatter', data=b'bytes in CDR', stamp=5) None
    """

    def __init__(self, uri: str, storage_id: str = "", on_open: Callable[[str], None] = lambda path: None) -> None:
        self._path = Path(uri)
        self._on_open = on_open
        self._unpacked: tempfile.TemporaryDirectory[str] | None = None
        self._open_files: dict[str, FileReader] = {}
        if not self._path.exists():
            raise BagError(f"there is no bag '{uri}'")
        self.is_folder = self._path.is_dir()
        self._folder = self._path if self.is_folder else self._path.parent
        try:
            self._open(storage_id)
        except BagError:
            self.close()
            raise

    def _open(self, storage_id: str) -> None:
        self.facts = metadata_file.read(self._path) if self.is_folder else self._facts_of_file(storage_id)
        if storage_id:
            self.facts.storage_identifier = check_storage_id(storage_id)
        check_storage_id(self.facts.storage_identifier)
        compression.check(self.facts.compression_mode, self.facts.compression_format)
        self.facts.bag_size = metadata_file.size_of(self._path)
        self.rewind()

    def _facts_of_file(self, storage_id: str) -> BagFacts:
        name = self._path.name
        mode = "FILE" if name.endswith(compression.SUFFIX) else ""
        chosen = storage_id or storage_id_of(self._path)
        self.facts = BagFacts(storage_identifier=chosen, compression_mode=mode, compression_format=compression.FORMAT)
        facts = self._file(name).facts()
        facts.compression_mode, facts.compression_format = mode, compression.FORMAT if mode else ""
        facts.relative_file_paths, facts.files[0].path = [name], name
        return facts

    def _file(self, name: str) -> FileReader:
        if name not in self._open_files:
            path = self._folder / name
            self._on_open(str(path))
            if self.facts.compression_mode == "FILE" and name.endswith(compression.SUFFIX):
                path = self._unpack(path)
            self._open_files[name] = open_reader(path, self.facts.storage_identifier)
        return self._open_files[name]

    def _unpack(self, path: Path) -> Path:
        if not path.is_file():
            raise BagError(f"the file '{path}' of the bag is not there")
        if self._unpacked is None:
            self._unpacked = tempfile.TemporaryDirectory(prefix="rosbag2_")
        return compression.decompress_file(path, Path(self._unpacked.name))

    def check_files(self) -> None:
        """Open the first file, so that errors in it are reported now."""
        for name in self.facts.relative_file_paths[:1]:
            self._file(name)

    def topics(self) -> list[TopicMetadata]:
        """The recorded topics."""
        listed = [topic.topic_metadata for topic in self.facts.topics_with_message_count]
        if listed:
            return listed
        topic_by_name = {topic.name: topic for name in self.facts.relative_file_paths for topic in self._file(name).topics()}
        return list(topic_by_name.values())

    def rewind(self, start_ns: int = -(2**63), topics: list[str] | None = None) -> None:
        """Restart at a time, with the messages of these topics (None: of all)."""
        self._next: Message | None = None
        self._start_ns = start_ns
        self._taken: list[Message] = []  # messages with the newest stamp
        self._messages = self._from(start_ns, topics)

    def choose(self, topics: list[str] | None) -> None:
        """Continue from here with the messages of these topics (None: of all)."""
        taken = self._taken
        self.rewind(taken[0].stamp if taken else self._start_ns, topics)
        self._messages = _without(list(taken), self._messages)
        self._taken = taken

    def _from(self, start_ns: int, topics: list[str] | None) -> Iterator[Message]:
        packed = self.facts.compression_mode == "MESSAGE"
        for name in self.facts.relative_file_paths:
            for message in self._file(name).messages(topics, start_ns):
                yield message._replace(data=compression.decompress(message.data)) if packed else message

    def peek(self) -> Message | None:
        """Return the next message without taking it; None at the end. A broken bag is closed."""
        try:
            if self._next is None:
                self._next = next(self._messages, None)
        except BagError:
            self.close()
            raise
        return self._next

    def take(self) -> Message | None:
        """Take the next message; None at the end."""
        message = self.peek()
        self._next = None
        if message is not None:
            if self._taken and self._taken[0].stamp != message.stamp:
                self._taken = []
            self._taken.append(message)
        return message

    def close(self) -> None:
        """Close the files."""
        self._messages = iter(())
        for file in self._open_files.values():
            file.close()
        self._open_files.clear()
        if self._unpacked is not None:
            self._unpacked.cleanup()
            self._unpacked = None


def _without(taken: list[Message], messages: Iterator[Message]) -> Iterator[Message]:
    """Yield the messages without those already taken, each once."""
    for message in messages:
        if message in taken:
            taken.remove(message)
        else:
            yield message
