"""Values of topics over time: the fields of a message that a path selects, and the curves of their values."""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from typing import Any

KEPT = 9000
"""The number of points kept per curve: five minutes at 30 Hz."""


def paths(words: Sequence[str]) -> list[str]:
    """The paths to plot, one for each curve.

    >>> paths(["/turtle1/pose/x:y", "/speed/data"])
    ['/turtle1/pose/x', '/turtle1/pose/y', '/speed/data']
    >>> paths(["/odom.twist.twist.linear.x:y"])
    ['/odom.twist.twist.linear.x', '/odom.twist.twist.linear.y']
    """
    curves = []
    for word in (word for word in words if word.strip(";")):
        first, *others = word.strip(";").split(":")
        before = first[: max(first.rfind("/"), first.rfind(".")) + 1]
        curves += [first, *(f"{before}{other}" for other in others)]
    return [path if path.startswith("/") else f"/{path}" for path in curves]


def topic_of(path: str, topics: Iterable[str]) -> str:
    """The topic that a path begins with, the longest if there are several; '' if there is none.

    >>> topic_of("/odom.twist.twist.linear.x", ["/odom", "/od"])
    '/odom'
    """
    fitting = [topic for topic in topics if path == topic or (path.startswith(topic) and path[len(topic)] in "/.[")]
    return max(fitting, key=len, default="")


def numbers(value: Any, name: str) -> Iterator[tuple[str, float]]:
    """Yield the number in a message's field; for a nested message, the numbers in its top-level fields."""
    if isinstance(value, (bool, int, float)):
        yield name, float(value)
    elif hasattr(value, "get_fields_and_field_types"):
        for field in value.get_fields_and_field_types():
            inner = getattr(value, field)
            if isinstance(inner, (bool, int, float)):
                yield f"{name}/{field}", float(inner)


def part(message: Any, fields: str) -> Any:
    """A part of a message, such as `pose/x`, `pose.x` or `ranges[3]`; None if it has no such part."""
    part = message
    for word in filter(None, re.split(r"[/.]", fields)):
        name, _, index = word.rstrip("]").partition("[")
        part = getattr(part, name, None) if name else part
        if index:
            part = part[int(index)] if part is not None and index.isdigit() and int(index) < len(part) else None
    return part


class Curve:
    """The values of one path with their times [s]; the oldest are discarded."""

    def __init__(self) -> None:
        self.times: deque[float] = deque(maxlen=KEPT)
        self.values: deque[float] = deque(maxlen=KEPT)
        self.total = 0
        """The number of values so far, including discarded ones."""

    def add(self, time: float, value: float) -> None:
        """Add a value. If the time goes back, as after a clock was reset, the curve begins again."""
        if self.times and time < self.times[-1]:
            self.times.clear()
            self.values.clear()
        self.times.append(time)
        self.values.append(value)
        self.total += 1

    def newer(self, than: int) -> list[tuple[float, float]]:
        """The values after the first `than`, as far as they are kept."""
        count = min(self.total - than, len(self.times))
        begin = len(self.times) - count
        return list(zip(islice(self.times, begin, None), islice(self.values, begin, None), strict=True))

    def between(self, start: float, end: float) -> tuple[list[float], list[float]]:
        """Times and values from `start` to `end` [s]."""
        times, values = list(self.times), list(self.values)
        window = slice(bisect_left(times, start), bisect_right(times, end))
        return times[window], values[window]


class Curves:
    """The curves of words in the form that `paths` reads, by name."""

    def __init__(self, words: Sequence[str]) -> None:
        self.wanted = paths(words)
        self.curves: dict[str, Curve] = {}

    def take(self, path: str, topic: str, message: Any, time: float) -> None:
        """Add a message of a topic: each number that the path selects in it becomes a point of a curve."""
        for name, number in numbers(part(message, path[len(topic) :]), path):
            self.curves.setdefault(name, Curve()).add(time, number)

    def span(self) -> tuple[float, float]:
        """The times of the first and the last value [s]."""
        ends = [(curve.times[0], curve.times[-1]) for curve in self.curves.values() if curve.times]
        return (min(start for start, _ in ends), max(end for _, end in ends)) if ends else (0.0, 0.0)


__all__ = ["KEPT", "Curve", "Curves", "numbers", "part", "paths", "topic_of"]
