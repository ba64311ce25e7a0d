"""What the tests of bags make and read."""

from __future__ import annotations

from pathlib import Path

from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.reader import BagReader
from coursekit.bag.storage import Message

SECOND = 10**9
CHATTER = TopicMetadata("/chatter", "std_msgs/msg/String")
ODD = TopicMetadata("/odd", "std_msgs/msg/String")


def text_bytes(text: str) -> bytes:
    """The CDR bytes of a std_msgs/String."""
    data = text.encode() + b"\0"
    return b"\0\1\0\0" + len(data).to_bytes(4, "little") + data


def all_of(path: Path | str, storage_id: str = "") -> list[Message]:
    """All messages of a bag."""
    reader = BagReader(str(path), storage_id)
    messages = []
    while (message := reader.take()) is not None:
        messages.append(message)
    reader.close()
    return messages
