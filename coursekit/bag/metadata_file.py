"""metadata.yaml: written in Humble's format, read from any ROS 2 release, never trusted."""

from __future__ import annotations

from pathlib import Path, PurePosixPath
from typing import Any

import yaml

from coursekit.bag.errors import BagError
from coursekit.bag.fields import Fields
from coursekit.bag.metadata import NEVER, BagFacts, FileFacts, TopicInformation, TopicMetadata
from coursekit.bag.yaml_text import dump
from coursekit.files import read_text, write_whole

FILE_NAME = "metadata.yaml"
ROOT = "rosbag2_bagfile_information"
NEWEST = 9
LARGEST = 64 * 1024 * 1024
"""Maximum size of a metadata.yaml [bytes]."""


class _Loader(yaml.SafeLoader):
    """A safe loader without aliases: bags have none, and a few lines of them can expand to gigabytes.

    It is not the loader in C: deeply nested brackets crash the interpreter there.
    """

    def compose_node(self, parent: Any, index: Any) -> Any:
        if self.check_event(yaml.AliasEvent):
            raise yaml.YAMLError("it has aliases (*name), which bags do not have")
        return super().compose_node(parent, index)


def load_yaml(text: str, what: str) -> Any:
    """Parse YAML text of a bag; BagError when it is invalid."""
    return _loaded(text, what, _Loader)


def load_settings(path: Path) -> Any:
    """Parse a YAML file written by the user; BagError when it cannot be read."""
    try:
        return _loaded(read_text(path), str(path), yaml.SafeLoader)
    except (OSError, UnicodeDecodeError) as error:
        raise BagError(f"'{path}' cannot be read: {error}") from None


def _loaded(text: str, what: str, loader: Any) -> Any:
    try:
        return yaml.load(text, Loader=loader)
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise BagError(f"{what} is no YAML: {' '.join(str(error).split())}") from None


def read(folder: Path) -> BagFacts:
    """Read the metadata.yaml of a bag; BagError names the file and the invalid key."""
    path = folder / FILE_NAME
    try:
        if path.stat().st_size > LARGEST:
            raise BagError(f"{path} has more than {LARGEST} bytes: that is no metadata of a bag")
        text = read_text(path)
    except FileNotFoundError:
        raise BagError(
            f"there is no {FILE_NAME} in '{folder}'. If it is a bag that was not ended properly, "
            f"'ros2 bag reindex {folder}' makes one from its files"
        ) from None
    except (OSError, UnicodeDecodeError) as error:
        raise BagError(f"{path} cannot be read: {error}") from None
    return parse(text, str(path))


def parse(text: str, where: str) -> BagFacts:
    """Parse the text of a metadata.yaml; `where` names it in errors.

    >>> text = dump({ROOT: as_dict(BagFacts(storage_identifier="sqlite3", message_count=7))})
    >>> parse(text, "metadata.yaml").message_count
    7
    """
    document = load_yaml(text, where)
    if not isinstance(document, dict) or ROOT not in document:
        raise BagError(f"{where} is no metadata of a bag: it has no '{ROOT}' at the top")
    root = Fields(document[ROOT], ROOT, where)
    version = root.integer("version")
    if not 1 <= version <= NEWEST:
        raise BagError(f"{where} has version {version}; versions 1 to {NEWEST} are known")
    facts = BagFacts(
        version=version,
        storage_identifier=root.text("storage_identifier"),
        duration_ns=root.inside("duration").integer("nanoseconds"),
        starting_time_ns=root.inside("starting_time").integer("nanoseconds_since_epoch"),
        message_count=root.integer("message_count"),
        topics_with_message_count=[_topic(topic) for topic in root.each("topics_with_message_count")],
        compression_format=root.text("compression_format", ""),
        compression_mode=root.text("compression_mode", "").upper(),
        relative_file_paths=[_inside(path, version, where) for path in root.texts("relative_file_paths")],
        files=[_file(file) for file in root.each("files", optional=True)],
        custom_data=root.mapping_of_texts("custom_data"),
        ros_distro=root.text("ros_distro", ""),
    )
    facts.compression_mode = "" if facts.compression_mode == "NONE" else facts.compression_mode
    return facts


def _topic(entry: Fields) -> TopicInformation:
    topic = entry.inside("topic_metadata")
    return TopicInformation(
        TopicMetadata(
            name=topic.text("name"),
            type=topic.text("type"),
            serialization_format=topic.text("serialization_format"),
            offered_qos_profiles=topic.text_or_yaml("offered_qos_profiles"),
            type_description_hash=topic.text("type_description_hash", ""),
        ),
        entry.integer("message_count"),
    )


def _file(entry: Fields) -> FileFacts:
    return FileFacts(
        path=entry.text("path"),
        starting_time_ns=entry.inside("starting_time").integer("nanoseconds_since_epoch"),
        duration_ns=entry.inside("duration").integer("nanoseconds"),
        message_count=entry.integer("message_count"),
    )


def _inside(name: str, version: int, where: str) -> str:
    """Return a file of the bag relative to its folder; up to version 3 the name started with the folder's own."""
    path = PurePosixPath(name.replace("\\", "/"))  # from any operating system
    if version < 4:
        return PurePosixPath(name).name if "/" in name else path.name
    drive = ":" in name.split("/")[0]
    if path.is_absolute() or drive or ".." in path.parts or "\0" in name or not path.name:
        raise BagError(f"{where} names the file {name!r}, which is outside of the bag's folder: it is not opened")
    return str(PurePosixPath(name))  # on Linux a backslash is an ordinary character


def as_dict(facts: BagFacts) -> dict[str, Any]:
    """Return the facts in the order of Humble's metadata.yaml.

    >>> list(as_dict(BagFacts()))[:4]
    ['version', 'storage_identifier', 'duration', 'starting_time']
    """
    return {
        "version": facts.version,
        "storage_identifier": facts.storage_identifier,
        "duration": {"nanoseconds": facts.duration_ns},
        "starting_time": {"nanoseconds_since_epoch": facts.starting_time_ns},
        "message_count": facts.message_count,
        "topics_with_message_count": [_topic_dict(topic) for topic in facts.topics_with_message_count],
        "compression_format": facts.compression_format,
        "compression_mode": facts.compression_mode,
        "relative_file_paths": facts.relative_file_paths,
        "files": [_file_dict(file) for file in facts.files],
    }


def _topic_dict(information: TopicInformation) -> dict[str, Any]:
    topic = information.topic_metadata
    names = ("name", "type", "serialization_format", "offered_qos_profiles")
    return {"topic_metadata": {name: getattr(topic, name) for name in names}, "message_count": information.message_count}


def _file_dict(facts: FileFacts) -> dict[str, Any]:
    return {
        "path": facts.path,
        "starting_time": {"nanoseconds_since_epoch": facts.starting_time_ns},
        "duration": {"nanoseconds": facts.duration_ns},
        "message_count": facts.message_count,
    }


def write(folder: Path, facts: BagFacts) -> None:
    """Write the metadata.yaml of a bag, atomically."""
    write_whole(folder / FILE_NAME, dump({ROOT: as_dict(facts)}) + "\n")


def size_of(bag: Path) -> int:
    """Return the size of a bag's folder in bytes, including metadata, as Humble counts it; or the size of a single file."""
    return sum(file.stat().st_size for file in (bag.iterdir() if bag.is_dir() else (bag,)) if file.is_file())


__all__ = ["FILE_NAME", "NEVER", "as_dict", "dump", "load_settings", "load_yaml", "parse", "read", "size_of", "write"]
