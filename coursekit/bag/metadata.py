"""A bag's metadata. Times and durations are nanoseconds."""

from __future__ import annotations

from dataclasses import dataclass, field

NEVER = 2**63 - 1
"""The starting time of a bag without messages."""
METADATA_VERSION = 5
"""The metadata.yaml version that Humble writes; versions 1 to 9 can be read."""


@dataclass
class TopicMetadata:
    """A recorded topic: its name, its type, and the QoS of its publishers as YAML text."""

    name: str
    type: str
    serialization_format: str = "cdr"
    offered_qos_profiles: str = ""
    id: int = field(default=0, compare=False)
    type_description_hash: str = field(default="", compare=False)

    def equals(self, other: TopicMetadata) -> bool:
        """Whether both have the same values."""
        return self == other


@dataclass
class TopicInformation:
    """A topic, with its number of messages in the bag."""

    topic_metadata: TopicMetadata
    message_count: int


@dataclass
class FileFacts:
    """One file of a bag."""

    path: str
    starting_time_ns: int = NEVER
    duration_ns: int = 0
    message_count: int = 0

    def include(self, stamp: int) -> None:
        """Count a message.

        >>> facts = FileFacts("walk_0.db3")
        >>> for stamp in (20, 10, 35):
        ...     facts.include(stamp)
        >>> facts.starting_time_ns, facts.duration_ns, facts.message_count
        (10, 25, 3)
        """
        first = stamp if not self.message_count else min(self.starting_time_ns, stamp)
        last = stamp if not self.message_count else max(self.starting_time_ns + self.duration_ns, stamp)
        self.starting_time_ns, self.duration_ns = first, last - first
        self.message_count += 1


@dataclass
class BagFacts:
    """A whole bag: the contents of its metadata.yaml, and its size on disk in bytes."""

    version: int = METADATA_VERSION
    storage_identifier: str = ""
    duration_ns: int = 0
    starting_time_ns: int = NEVER
    message_count: int = 0
    topics_with_message_count: list[TopicInformation] = field(default_factory=list)
    compression_format: str = ""
    compression_mode: str = ""
    relative_file_paths: list[str] = field(default_factory=list)
    files: list[FileFacts] = field(default_factory=list)
    bag_size: int = 0
    custom_data: dict[str, str] = field(default_factory=dict)
    ros_distro: str = ""

    def sum_up(self) -> None:
        """Compute count, start and duration from the files.

        >>> facts = BagFacts(files=[FileFacts("a", 10, 5, 2), FileFacts("b", 20, 30, 4), FileFacts("empty")])
        >>> facts.sum_up()
        >>> facts.starting_time_ns, facts.duration_ns, facts.message_count
        (10, 40, 6)
        """
        filled = [file for file in self.files if file.message_count]
        self.message_count = sum(file.message_count for file in filled)
        self.starting_time_ns = min((file.starting_time_ns for file in filled), default=NEVER)
        end = max((file.starting_time_ns + file.duration_ns for file in filled), default=NEVER)
        self.duration_ns = end - self.starting_time_ns
