"""Options and metadata of bags. In ROS 2: rosbag2_py._storage."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any

from rclpy.duration import Duration
from rclpy.time import Time

from coursekit.bag.info_text import info_text
from coursekit.bag.metadata import BagFacts, FileFacts, TopicInformation, TopicMetadata
from coursekit.bag.storage import DEFAULT_STORAGE_ID

__all__ = [
    "BagMetadata",
    "ConverterOptions",
    "FileInformation",
    "ReadOrder",
    "ReadOrderSortBy",
    "StorageFilter",
    "StorageOptions",
    "TopicInformation",
    "TopicMetadata",
    "get_default_storage_id",
]


def get_default_storage_id() -> str:
    """The storage that is used by default.

    >>> get_default_storage_id()
    'sqlite3'
    """
    return DEFAULT_STORAGE_ID


@dataclass
class ConverterOptions:
    """The input and output serialization; '' leaves it unchanged, and 'cdr' is the only format."""

    input_serialization_format: str = ""
    output_serialization_format: str = ""


@dataclass
class StorageOptions:
    """The location and format of a bag. Sizes are in bytes, durations in seconds; 0 means no limit."""

    uri: str
    storage_id: str = ""
    max_bagfile_size: int = 0
    max_bagfile_duration: int = 0
    max_cache_size: int = 0
    storage_preset_profile: str = ""
    storage_config_uri: str = ""
    snapshot_mode: bool = False
    start_time_ns: int = -1
    end_time_ns: int = -1
    custom_data: dict[str, str] = field(default_factory=dict)


@dataclass
class StorageFilter:
    """The topics to read: those in `topics` and those that match `topics_regex`; all if both are empty."""

    topics: list[str] = field(default_factory=list)
    topics_regex: str = ""
    topics_regex_to_exclude: str = ""


class ReadOrderSortBy(IntEnum):
    """The order of messages."""

    ReceivedTimestamp = 0
    PublishedTimestamp = 1
    File = 2


@dataclass
class ReadOrder:
    """The order of reading (ROS releases after Humble); here always by the time of reception."""

    sort_by: ReadOrderSortBy = ReadOrderSortBy.ReceivedTimestamp
    reverse: bool = False


class _Timed:
    """`starting_time` and `duration` as rclpy's types, over nanoseconds."""

    starting_time_ns: int
    duration_ns: int

    @property
    def starting_time(self) -> Time:
        """The time at which the first message was received."""
        return Time(nanoseconds=self.starting_time_ns)

    @starting_time.setter
    def starting_time(self, value: Any) -> None:
        self.starting_time_ns = value.nanoseconds

    @property
    def duration(self) -> Duration:
        """The time from the first message to the last."""
        return Duration(nanoseconds=self.duration_ns)

    @duration.setter
    def duration(self, value: Any) -> None:
        self.duration_ns = value.nanoseconds


class FileInformation(_Timed, FileFacts):
    """One file of a bag."""

    def __init__(self, path: str, starting_time: Any, duration: Any, message_count: int) -> None:
        super().__init__(path, starting_time.nanoseconds, duration.nanoseconds, message_count)


class BagMetadata(_Timed, BagFacts):
    """The metadata of a bag; its text is the output of `ros2 bag info`."""

    def __init__(
        self,
        version: int = 6,
        bag_size: int = 0,
        storage_identifier: str = "",
        relative_file_paths: list[str] | None = None,
        files: list[Any] | None = None,
        duration: Any = Duration(nanoseconds=0),
        starting_time: Any = Time(nanoseconds=0),
        message_count: int = 0,
        topics_with_message_count: list[TopicInformation] | None = None,
        compression_format: str = "",
        compression_mode: str = "",
        custom_data: dict[str, str] | None = None,
        ros_distro: str = "",
    ) -> None:
        super().__init__(
            version=version,
            storage_identifier=storage_identifier,
            duration_ns=duration.nanoseconds,
            starting_time_ns=starting_time.nanoseconds,
            message_count=message_count,
            topics_with_message_count=topics_with_message_count or [],
            compression_format=compression_format,
            compression_mode=compression_mode,
            relative_file_paths=relative_file_paths or [],
            files=files or [],
            bag_size=bag_size,
            custom_data=custom_data or {},
            ros_distro=ros_distro,
        )

    @classmethod
    def of(cls, facts: BagFacts) -> BagMetadata:
        """Convert the facts of a bag to ROS's class."""
        metadata = cls()
        vars(metadata).update(vars(facts))
        metadata.files = [_file_information(file) for file in facts.files]
        return metadata

    def __repr__(self) -> str:
        return info_text(self)


def _file_information(facts: FileFacts) -> Any:
    return FileInformation(
        facts.path, Time(nanoseconds=facts.starting_time_ns), Duration(nanoseconds=facts.duration_ns), facts.message_count
    )
