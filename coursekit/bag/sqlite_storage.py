"""Messages in a sqlite3 file (.db3), with Humble's tables (schema 3); schemas 1 to 4 can be read."""

from __future__ import annotations

import re
import sqlite3
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from coursekit.bag import metadata_file
from coursekit.bag.errors import BagError
from coursekit.bag.metadata import BagFacts, FileFacts, TopicInformation, TopicMetadata
from coursekit.bag.storage import Message

SCHEMA_VERSION = 3
_TABLES = """
CREATE TABLE schema(schema_version INTEGER PRIMARY KEY,ros_distro TEXT NOT NULL);
CREATE TABLE metadata(id INTEGER PRIMARY KEY,metadata_version INTEGER NOT NULL,metadata TEXT NOT NULL);
CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL, data BLOB NOT NULL);
CREATE INDEX timestamp_idx ON messages (timestamp ASC);
"""  # noqa: E501
_FAST = ("journal_mode=MEMORY", "synchronous=OFF")
_RESILIENT = ("journal_mode=WAL", "synchronous=NORMAL")
_PRAGMA = re.compile(r"\s*(\w+)\s*=\s*([\w-]+)\s*")
COMMIT_EVERY, COMMIT_BYTES = 500, 1 << 18
"""Commit after this many messages or bytes: committed messages survive a crash of the program and a full disk."""


class SqliteWriter:
    """A new file. `preset` 'resilient' trades speed for safety from a power cut; `config` is a YAML file."""

    def __init__(self, path: Path, preset: str = "", config: str = "") -> None:
        if preset not in ("", "none", "resilient"):
            raise BagError(f"sqlite3 has no preset '{preset}'; it has none and resilient")
        self._path = path
        # Written by the process's main execution context, but closed by any context that ends the process.
        self._db = sqlite3.connect(path, check_same_thread=False, isolation_level=None)
        for pragma in (*(_RESILIENT if preset == "resilient" else _FAST), *_pragmas(config)):
            self._run(f"PRAGMA {pragma}")
        for statement in _TABLES.split(";")[:-1]:
            self._run(statement)
        self._run("INSERT INTO schema VALUES (?, ?)", SCHEMA_VERSION, "humble")
        self._run("BEGIN")
        self._page_size = self._run("PRAGMA page_size").fetchone()[0]
        self._ids: dict[str, int] = {}
        self._pending = self._pending_bytes = 0

    def _run(self, statement: str, *values: Any) -> sqlite3.Cursor:
        try:
            return self._db.execute(statement, values)
        except sqlite3.Error as error:
            raise BagError(f"'{self._path}' cannot be written: {error}") from None

    def create_topic(self, topic: TopicMetadata) -> None:
        """Register a topic."""
        insert = "INSERT INTO topics (name, type, serialization_format, offered_qos_profiles) VALUES (?, ?, ?, ?)"
        entered = self._run(insert, topic.name, topic.type, topic.serialization_format, topic.offered_qos_profiles)
        self._ids[topic.name] = entered.lastrowid or 0

    def remove_topic(self, topic: TopicMetadata) -> None:
        """Remove a registered topic."""
        self._run("DELETE FROM topics WHERE id = ?", self._ids.pop(topic.name))

    def write(self, message: Message) -> None:
        """Add a message of a registered topic."""
        insert = "INSERT INTO messages (timestamp, topic_id, data) VALUES (?, ?, ?)"
        self._run(insert, message.stamp, self._ids[message.topic], message.data)
        self._pending += 1
        self._pending_bytes += len(message.data)
        if self._pending >= COMMIT_EVERY or self._pending_bytes >= COMMIT_BYTES:
            self._run("COMMIT")
            self._run("BEGIN")
            self._pending = self._pending_bytes = 0

    def size(self) -> int:
        """Return the current size of the file in bytes."""
        return int(self._run("PRAGMA page_count").fetchone()[0]) * int(self._page_size)

    def close(self, facts: BagFacts) -> None:
        """Finish the file; it contains a copy of the bag's metadata."""
        text = metadata_file.dump(metadata_file.as_dict(facts))
        self._run("INSERT INTO metadata (metadata_version, metadata) VALUES (?, ?)", facts.version, text)
        self._run("COMMIT")
        self._db.close()

    def abandon(self) -> None:
        """Close the file as it is."""
        self._db.close()


def _pragmas(config: str) -> list[str]:
    """Read the settings `write: pragmas:` of a configuration file."""
    if not config:
        return []
    loaded = metadata_file.load_settings(Path(config)) or {}
    write = loaded.get("write") if isinstance(loaded, dict) else None
    wanted = (write or {}).get("pragmas") or [] if isinstance(write or {}, dict) else []
    for name in wanted:
        if not isinstance(name, str) or not _PRAGMA.fullmatch(name):
            raise BagError(f"{config}: {name!r} is no setting of sqlite3; write for example 'synchronous=NORMAL'")
    return list(wanted)


class SqliteReader:
    """An existing file; BagError when it is not a bag file, or broken."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._db = self._opened("mode=ro")
        try:
            self._columns = {row[1] for row in self._rows("PRAGMA table_info(topics)")}
            tables = {row[0] for row in self._rows("SELECT name FROM sqlite_master WHERE type = 'table'")}
            if not {"topics", "messages"} <= tables:
                raise BagError(f"'{path}' is a sqlite3 file, but not of a bag: it has no tables topics and messages")
        except BagError:
            self.close()
            raise

    def _opened(self, how: str) -> sqlite3.Connection:
        try:
            db = sqlite3.connect(f"{self._path.resolve().as_uri()}?{how}", uri=True, check_same_thread=False)
        except sqlite3.Error as error:
            raise self._broken(error) from None
        db.text_factory = lambda raw: raw.decode("utf-8", "replace")
        db.execute("PRAGMA trusted_schema=OFF")  # no functions hidden in the definitions of an untrusted file
        return db

    def _broken(self, error: Exception) -> BagError:
        return BagError(f"'{self._path}' cannot be read as a sqlite3 file of a bag: {error}")

    def _rows(self, statement: str, values: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
        try:
            yield from self._db.execute(statement, values)
        except (sqlite3.Error, OverflowError, UnicodeDecodeError, MemoryError) as error:
            raise self._broken(error) from None

    def topics(self) -> list[TopicMetadata]:
        """Return the topics, in the order of their creation."""
        wanted = ["name", "type", "serialization_format", "offered_qos_profiles", "type_description_hash"]
        chosen = ", ".join(f"coalesce({name}, '')" if name in self._columns else "''" for name in wanted)
        rows = self._rows(f"SELECT {chosen} FROM topics ORDER BY id")
        return [TopicMetadata(**dict[str, Any](zip(wanted, map(str, row), strict=True))) for row in rows]

    def facts(self) -> BagFacts:
        """Return the facts of a bag that consists of this file."""
        counted = "SELECT topics.name, count(messages.id) FROM topics LEFT JOIN messages ON topics.id = messages.topic_id"
        counts = dict(self._rows(f"{counted} GROUP BY topics.id"))
        ((first, last, count),) = self._rows("SELECT min(timestamp), max(timestamp), count(*) FROM messages")
        name = self._path.name
        whole = FileFacts(name)
        if count:
            first, last = self._stamp(first), self._stamp(last)
            whole = FileFacts(name, first, last - first, count)
        topics = [TopicInformation(topic, counts.get(topic.name, 0)) for topic in self.topics()]
        facts = BagFacts(
            storage_identifier="sqlite3", topics_with_message_count=topics, relative_file_paths=[name], files=[whole]
        )
        facts.sum_up()
        return facts

    def messages(self, topics: list[str] | None, start_ns: int) -> Iterator[Message]:
        """Yield the messages of these topics (None: of all) from a time on, oldest first."""
        some = "" if topics is None else f"AND topics.name IN ({', '.join('?' * len(topics))}) "
        query = (
            "SELECT topics.name, data, timestamp FROM messages JOIN topics ON messages.topic_id = topics.id "
            f"WHERE timestamp >= ? {some}ORDER BY timestamp, messages.id"
        )
        for name, data, stamp in self._rows(query, (start_ns, *(topics or ()))):
            if not isinstance(data, bytes):
                raise BagError(f"'{self._path}': a message of {name} is {type(data).__name__}, and should be bytes")
            yield Message(str(name), data, self._stamp(stamp))

    def _stamp(self, stamp: Any) -> int:
        if not isinstance(stamp, int):
            raise BagError(f"'{self._path}': the time of a message is {stamp!r}, and should be whole nanoseconds")
        return stamp

    def close(self) -> None:
        """Close the file."""
        self._db.close()
