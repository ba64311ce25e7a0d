"""The common parts of the storage kinds of bag files."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple, Protocol

from coursekit.bag.errors import BagError
from coursekit.bag.metadata import BagFacts, TopicMetadata

SUFFIXES = {"sqlite3": ".db3", "mcap": ".mcap"}
"""File suffixes by storage id."""
DEFAULT_STORAGE_ID = "sqlite3"


class Message(NamedTuple):
    """A recorded message: its topic, its bytes, and its receive time (ns since 1970)."""

    topic: str
    data: bytes
    stamp: int


class FileReader(Protocol):
    """One file, open for reading."""

    def topics(self) -> list[TopicMetadata]: ...
    def facts(self) -> BagFacts: ...
    def messages(self, topics: list[str] | None, start_ns: int) -> Iterator[Message]: ...
    def close(self) -> None: ...


class FileWriter(Protocol):
    """One file, open for writing."""

    def create_topic(self, topic: TopicMetadata) -> None: ...
    def remove_topic(self, topic: TopicMetadata) -> None: ...
    def write(self, message: Message) -> None: ...
    def size(self) -> int: ...
    def close(self, facts: BagFacts) -> None: ...
    def abandon(self) -> None: ...


def storage_id_of(path: Path) -> str:
    """Return the storage id for a file name; BagError for an unknown suffix.

    >>> storage_id_of(Path("run_0.db3")), storage_id_of(Path("run_0.mcap"))
    ('sqlite3', 'mcap')
    """
    name = path.name.removesuffix(".zstd")
    for storage_id, suffix in SUFFIXES.items():
        if name.endswith(suffix):
            return storage_id
    what = "is no file of a bag: it ends neither in .db3 nor in .mcap"
    if path.suffix == ".bag":
        what = f"is a bag of ROS 1: `pip install rosbags`, then `rosbags-convert --src {path} --dst {path.stem}`"
    raise BagError(f"'{path}' {what}")


def check_storage_id(storage_id: str) -> str:
    """Return the id; BagError when there is no such storage.

    >>> check_storage_id("rosbag1")
    Traceback (most recent call last):
    coursekit.bag.errors.BagError: there is no storage 'rosbag1'; there are mcap and sqlite3
    """
    if storage_id not in SUFFIXES:
        raise BagError(f"there is no storage '{storage_id}'; there are {' and '.join(sorted(SUFFIXES))}")
    return storage_id
