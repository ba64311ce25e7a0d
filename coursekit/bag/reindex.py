"""Regenerates the metadata.yaml of a bag from its files."""

from __future__ import annotations

import re
from pathlib import Path

from coursekit.bag import compression, metadata_file
from coursekit.bag.errors import BagError
from coursekit.bag.metadata import BagFacts, TopicInformation
from coursekit.bag.reader import BagReader
from coursekit.bag.storage import SUFFIXES

_NUMBER = re.compile(r"_(\d+)\.(db3|mcap)(\.zstd)?$")


def reindex(folder: Path, storage_id: str = "") -> BagFacts:
    """Read the bag's files, write metadata.yaml and return its facts; BagError when there are no files."""
    names = _files(folder, storage_id)
    facts = BagFacts()
    topics: dict[str, TopicInformation] = {}
    for name in names:
        reader = BagReader(str(folder / name), storage_id)
        _add(facts, topics, reader.facts)
        if not facts.compression_mode and _is_packed(reader):
            facts.compression_mode, facts.compression_format = "MESSAGE", compression.FORMAT
        reader.close()
    facts.topics_with_message_count = list(topics.values())
    facts.sum_up()
    metadata_file.write(folder, facts)
    return facts


def _files(folder: Path, storage_id: str) -> list[str]:
    wanted = (SUFFIXES[storage_id],) if storage_id else tuple(SUFFIXES.values())
    names = [path.name for path in folder.iterdir() if path.name.removesuffix(compression.SUFFIX).endswith(wanted)]
    if not names:
        raise BagError("No storage files found for reindexing. Abort")
    return sorted(names, key=_order)


def _order(name: str) -> tuple[int, str]:
    number = _NUMBER.search(name)
    return (int(number[1]) if number else -1, name)


def _add(facts: BagFacts, topics: dict[str, TopicInformation], more: BagFacts) -> None:
    facts.storage_identifier = more.storage_identifier
    facts.compression_mode, facts.compression_format = more.compression_mode, more.compression_format
    facts.files += more.files
    facts.relative_file_paths += more.relative_file_paths
    for topic in more.topics_with_message_count:
        known = topics.setdefault(topic.topic_metadata.name, TopicInformation(topic.topic_metadata, 0))
        known.message_count += topic.message_count


def _is_packed(reader: BagReader) -> bool:
    """Whether the file's messages are compressed individually: CDR begins with 0, zstd with its magic number."""
    first = reader.peek()
    return first is not None and first.data[:4] == b"\x28\xb5\x2f\xfd"
