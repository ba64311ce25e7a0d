"""The compression of bags. In ROS 2: rosbag2_py._compression_options."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class CompressionMode(Enum):
    """The unit of compression."""

    NONE = 0
    FILE = 1
    MESSAGE = 2


def compression_mode_from_string(text: str) -> CompressionMode:
    """Return the mode of a word, ignoring case; NONE for an unknown word.

    >>> compression_mode_from_string("file")
    <CompressionMode.FILE: 1>
    """
    return CompressionMode.__members__.get(text.upper(), CompressionMode.NONE)


def compression_mode_to_string(mode: CompressionMode) -> str:
    """Return the word for a mode.

    >>> compression_mode_to_string(CompressionMode.MESSAGE)
    'MESSAGE'
    """
    return mode.name


@dataclass
class CompressionOptions:
    """Format and mode of compression. Queue size and threads have no effect here: no message is dropped."""

    compression_format: str = ""
    compression_mode: CompressionMode = CompressionMode.NONE
    compression_queue_size: int = 1
    compression_threads: int = 0
