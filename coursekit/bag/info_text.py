"""`ros2 bag info`: a bag's facts as text, in Humble's layout."""

from __future__ import annotations

import time
from collections.abc import Iterable

from coursekit.bag.metadata import BagFacts, TopicInformation

_INDENT = " " * 19
_UNITS = ("B", "KiB", "MiB", "GiB", "TiB")


def info_text(facts: BagFacts) -> str:
    r"""Return the text, with an empty first line and a final line break.

    >>> facts = BagFacts(storage_identifier="sqlite3", duration_ns=1_500_000_000, message_count=3)
    >>> print("\n".join(info_text(facts).splitlines()[3:5]))
    Storage id:        sqlite3
    Duration:          1.500000000s
    """
    end = facts.starting_time_ns + facts.duration_ns
    lines = [
        "",
        f"Files:             {_under_each_other(facts.relative_file_paths)}",
        f"Bag size:          {size_text(facts.bag_size)}",
        f"Storage id:        {facts.storage_identifier}",
        f"Duration:          {seconds_text(facts.duration_ns)}s",
        f"Start:             {time_text(facts.starting_time_ns)}",
        f"End:               {time_text(end)}",
        f"Messages:          {facts.message_count}",
        f"Topic information: {_under_each_other(map(_topic_line, facts.topics_with_message_count))}",
        "",
    ]
    return "\n".join(lines)


def _under_each_other(lines: Iterable[str]) -> str:
    return f"\n{_INDENT}".join(lines)


def _topic_line(information: TopicInformation) -> str:
    topic = information.topic_metadata
    return (
        f"Topic: {topic.name} | Type: {topic.type} | Count: {information.message_count} | "
        f"Serialization Format: {topic.serialization_format}"
    )


def seconds_text(nanoseconds: int) -> str:
    """Format seconds with nine decimals.

    >>> seconds_text(1_500_000_000)
    '1.500000000'
    """
    sign = "-" if nanoseconds < 0 else ""
    return f"{sign}{abs(nanoseconds) // 10**9}.{abs(nanoseconds) % 10**9:09d}"


def time_text(nanoseconds: int) -> str:
    """Format date and local time, and the seconds since 1970."""
    try:
        there = time.localtime(nanoseconds // 10**9)
    except (OverflowError, OSError, ValueError):
        return f"({seconds_text(nanoseconds)})"
    date = f"{time.strftime('%b', there)} {there.tm_mday:2d} {there.tm_year}"
    return f"{date} {time.strftime('%H:%M:%S', there)}.{nanoseconds % 10**9:09d} ({seconds_text(nanoseconds)})"


def size_text(size: int) -> str:
    """Format bytes in the largest unit in which the number is at least 1.

    >>> size_text(25600), size_text(12)
    ('25.0 KiB', '12 B')
    """
    number, unit = float(size), 0
    while number >= 1024 and unit < len(_UNITS) - 1:
        number /= 1024
        unit += 1
    return f"{number:.{1 if unit else 0}f} {_UNITS[unit]}"
